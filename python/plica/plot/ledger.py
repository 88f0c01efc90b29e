"""The waterfall of the ledger: from the gap, each row takes its share away."""
from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING, Any

from .style import ACCENT, FAINT, INK, look

if TYPE_CHECKING:
    from ..diagnosis import Diagnosis


def draw(diagnosis: Diagnosis, *, ax: Any = None) -> Any:
    """Shares of the gap in percent, effects dark, what is left faint; whiskers are 90 %."""
    rows = diagnosis.data["ledger"]["rows"]
    with look(ax, figsize=(7.2, 0.8 + 0.5 * (1 + len(rows)))) as axes:
        axes.barh(0, 100, color=INK, height=0.6)
        left = 100.0
        for k, row in enumerate(rows, start=1):
            share = 100 * row["share"]
            axes.barh(k, -share, left=left, height=0.6,
                      color=ACCENT if row["effects"] else FAINT)
            axes.plot([left, left], [k - 1 + 0.3, k - 0.3], color=FAINT, linewidth=0.8)
            left -= share
            low, high = row["interval"]
            if row["effects"]:
                ends = [left + share - 100 * high, left + share - 100 * low]
                axes.plot(ends, [k, k], color=INK, linewidth=1)
            axes.text(max(left + share, left) + 1, k, f"{share:.0f} %", va="center", fontsize=8)
        names = ["the gap of the nominal case"] + [_name(row) for row in rows]
        axes.set_yticks(range(len(names)), names)
        axes.invert_yaxis()
        axes.grid(axis="y", visible=False)
        axes.set(xlabel="share of the gap in %", xlim=(min(0.0, axes.get_xlim()[0]), 112),
                 title=f"{diagnosis.data['case']}: {diagnosis.verdict}")
    return axes


def _name(row: dict[str, Any]) -> str:
    return "\n".join(textwrap.wrap(str(row["what"]), 44)[:2])
