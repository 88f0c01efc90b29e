"""Dynamic stiffness over frequency."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence

import numpy as np

from .style import COLOURS, DASHES, look

if TYPE_CHECKING:
    from ..dynamic_stiffness import DynamicStiffness


def draw(stiffness: DynamicStiffness, *, directions: Sequence[str] = ("x", "y", "z"),
         state: int = 0, ax: Any = None) -> Any:
    """Magnitude (log) of the blocked transfer stiffness, a curve per direction and amplitude.

    directions: x, y, z in N/m or rx, ry, rz in Nm/rad.
    """
    turned = {d.startswith("r") for d in directions}
    if len(turned) > 1:
        raise ValueError(f"{', '.join(directions)}: are N/m and Nm/rad; one kind on one plot")
    with look(ax) as axes:
        for k, direction in enumerate(directions):
            for level, (amplitude, angle) in enumerate(zip(stiffness.amplitude, stiffness.angle)):
                size = angle if turned == {True} else amplitude
                name = direction if len(stiffness.amplitude) == 1 else (
                    f"{direction}, small" if size == 0 else f"{direction}, {size:g}")
                axes.plot(stiffness.frequency, np.abs(stiffness.transfer(direction, state, level)),
                          color=COLOURS[k % len(COLOURS)], linestyle=DASHES[level % len(DASHES)],
                          label=name)
        axes.set(yscale="log", xlabel="frequency in Hz",
                 ylabel="Nm/rad" if turned == {True} else "N/m",
                 title=f"transfer stiffness, {stiffness.ends[0]} moves, {stiffness.ends[1]} held"
                 + (f", {stiffness.states[state]}" if len(stiffness.states) > 1 else ""))
        axes.legend()
    return axes
