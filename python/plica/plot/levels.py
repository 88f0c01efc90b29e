"""Peaks over the level of excitation, computed and measured."""
from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..measured import Measured, read_measured
from .style import COLOURS, DASHES, look

if TYPE_CHECKING:
    from ..results import Results


def draw(results: Results, *, quantity: str = "frequency",
         measured: Measured | str | Path | None = None, ax: Any = None) -> Any:
    """The first peak of every channel over the level: its frequency, amplitude or damping.

    measured: test data, or their file, whose `peaks` are drawn over it.
    """
    peaks = results.levels.measured_like()
    tests = None
    if measured is not None:
        data = measured if isinstance(measured, Measured) else read_measured(measured)
        tests = data.peaks
    labels = {"frequency": "frequency of the peak in Hz", "amplitude": "amplitude of the peak",
              "damping": "damping, fraction of critical"}
    with look(ax) as axes:
        for k, (channel, some) in enumerate(peaks.groupby(["base", "sensor", "direction"])):
            colour, (base, sensor, direction) = COLOURS[k % len(COLOURS)], channel
            some = some.sort_values("level")
            axes.plot(some["level"], some[quantity], color=colour, label=f"{sensor} {direction}",
                      linestyle=DASHES[k % len(DASHES)], marker="o", markersize=3)
            if tests is not None and len(tests) and quantity in tests:
                seen = tests[(tests["base"] == base) & (tests["direction"] == direction)]
                axes.plot(seen["level"], seen[quantity], "s", color=colour, markersize=4,
                          fillstyle="none", label=f"{sensor} {direction}, test")
        axes.set(xlabel="level of excitation", ylabel=labels[quantity], title=results.case)
        axes.legend()
    return axes
