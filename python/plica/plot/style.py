"""The look of the report: its ink, its colours, lines told apart by dashes as well."""
from __future__ import annotations

from contextlib import contextmanager
from typing import Any, Iterator

from ..optional import need

INK, MUTED, RULE, ACCENT, WARN, FAINT = ("#1b2127", "#5b6670", "#d5dbe0", "#0b5c8f", "#8a4b00",
                                         "#a3adb6")
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
DASHES = ("-", "--", ":", "-.", (0, (5, 1, 1, 1, 1, 1)), (0, (8, 2)))
LOOK: dict[str, Any] = {
    "font.family": "sans-serif", "font.size": 9, "text.color": INK, "axes.labelcolor": MUTED,
    "axes.edgecolor": "#8c98a3", "axes.linewidth": 0.8, "axes.spines.top": False,
    "axes.spines.right": False, "axes.titlesize": 10, "axes.titleweight": "semibold",
    "axes.titlelocation": "left", "axes.grid": True, "axes.axisbelow": True, "grid.color": RULE,
    "grid.linewidth": 0.6, "xtick.color": MUTED, "ytick.color": MUTED, "xtick.labelsize": 8,
    "ytick.labelsize": 8, "legend.frameon": False, "legend.fontsize": 8, "lines.linewidth": 1.4,
    "figure.figsize": (7.2, 3.6), "figure.constrained_layout.use": True, "savefig.dpi": 150}


@contextmanager
def look(ax: Any = None, **figure: Any) -> Iterator[Any]:
    """Axes with the look of the report: those that are given, or those of a new figure."""
    need("matplotlib", "a plot")
    pyplot = need("matplotlib.pyplot", "a plot")
    with pyplot.rc_context(LOOK):
        yield pyplot.figure(**figure).add_subplot() if ax is None else ax
