"""The stabilisation diagram of an identification."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .style import ACCENT, FAINT, MUTED, RULE, look

if TYPE_CHECKING:
    from ..documents import Identification

MARKS = {"new": (".", FAINT), "frequency": ("x", MUTED), "damping": ("d", MUTED),
         "all": ("o", ACCENT)}


def draw(identification: Identification, *, ax: Any = None) -> Any:
    """Poles of rising order by frequency, marked by what holds against the order below, with lines
    at the modes that were found. MissingData of a program that does not write the diagram."""
    poles = identification.stabilisation
    with look(ax) as axes:
        for frequency in identification.modes.get("frequency", []):
            axes.axvline(frequency, color=RULE, linewidth=3, zorder=0)
        for word, (mark, colour) in MARKS.items():
            some = poles[poles["stable"] == word]
            axes.plot(some["frequency"], some["order"], mark, color=colour, markersize=4,
                      label={"all": "stable", "new": "new"}.get(word, f"{word} stable"))
        _indicator(identification.data.get("indicator"), axes)
        axes.set(xlabel="frequency in Hz", ylabel="order", title=identification.data["title"])
        axes.legend(ncol=4, loc="upper center", bbox_to_anchor=(0.5, -0.14))
    return axes


def _indicator(indicator: Any, axes: Any) -> None:
    if not indicator:
        return
    twin = axes.twinx()
    twin.semilogy(indicator["frequency"], np.abs(indicator["value"]), color=MUTED, linewidth=0.8,
                  zorder=1)
    twin.yaxis.set_visible(False)
