"""Plots with the look of the report, in matplotlib. Each gives back the axes it drew on."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..errors import MissingData

if TYPE_CHECKING:
    from ..results import Results


class Plots:
    """`r.plot()` and its kin; every one takes `ax=` to draw on axes that are there."""

    def __init__(self, results: Results) -> None:
        self._results = results

    def __call__(self, **options: Any) -> Any:
        """The most telling plot of what is there: ledger, levels, response, a mode, MAC, test."""
        r, has = self._results, self._results.folder.has
        if has("diagnosis.json"):
            return self.ledger(**options)
        if has("results.json"):
            if r.data.get("levels"):
                return self.levels(**options)
            return self.response(**options) if r.responses else self.shape(1, **options)
        if has("correlation.json"):
            return self.mac(**options)
        if has("identification.json"):
            return self.synthesis(**options)
        if has("stiffness.h5") or has("stiffness.csv"):
            return self.stiffness(**options)
        if has("fit.json"):
            return self.correlation(**options)
        if r.sets:
            return r.sets[0].plot(**options)
        raise MissingData(f"{r.path}: has nothing that is drawn as a whole; r.tables, r.table(...)")

    def response(self, name: str | None = None, **options: Any) -> Any:
        """Magnitude of the sensors over frequency, over a test; see plica.plot.response.draw."""
        from .response import draw
        return draw(self._results, name, **options)

    def shape(self, mode: int = 1, **options: Any) -> Any:
        """A mode, deformed and coloured by its motion; see plica.plot.shape.draw."""
        from .shape import draw
        return draw(self._results, mode, **options)

    def ledger(self, **options: Any) -> Any:
        """Waterfall: what the gap to the test is made of; see plica.plot.ledger.draw."""
        from .ledger import draw
        return draw(self._results.diagnosis, **options)

    def synthesis(self, **options: Any) -> Any:
        """Measured responses and their modes; see plica.plot.synthesis.draw."""
        from .synthesis import draw
        return draw(self._results.identification, **options)

    def stability(self, **options: Any) -> Any:
        """Stabilisation diagram of an identification; see plica.plot.stability.draw."""
        from .stability import draw
        return draw(self._results.identification, **options)

    def mac(self, **options: Any) -> Any:
        """MAC of simulated and measured modes; see plica.plot.matrix.mac."""
        from .matrix import mac
        return mac(self._results.correlation, **options)

    def correlation(self, **options: Any) -> Any:
        """How fitted parameters go together; see plica.plot.matrix.correlation."""
        from .matrix import correlation
        return correlation(self._results.fit, **options)

    def stiffness(self, **options: Any) -> Any:
        """Dynamic stiffness between two ends; see plica.plot.stiffness.draw."""
        from .stiffness import draw
        return draw(self._results.stiffness, **options)

    def levels(self, **options: Any) -> Any:
        """Peaks over the level of excitation; see plica.plot.levels.draw."""
        from .levels import draw
        return draw(self._results, **options)


__all__ = ["Plots"]
