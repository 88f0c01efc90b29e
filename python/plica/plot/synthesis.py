"""Measured responses and what the identified modes make of them."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence

import numpy as np

from .style import COLOURS, INK, RULE, look

if TYPE_CHECKING:
    from ..documents import Identification


def draw(identification: Identification, *, channels: Sequence[str] | None = None,
         ax: Any = None) -> Any:
    """Magnitude (log) of the responses to the first input, points, with their synthesis, lines.

    channels: such as ["mid.y"]; unless given the strongest of every mode.
    """
    test, fitted = identification.frf[0], identification.synthesised[0]
    strongest = [mode["strongest"].partition(" by ")[0] for mode in identification.data["modes"]]
    wanted = list(channels or dict.fromkeys(strongest)) or list(test.outputs[:1])
    with look(ax) as axes:
        for mode in identification.data["modes"]:
            axes.axvline(mode["frequency"], color=RULE, linewidth=3, zorder=0)
        for k, channel in enumerate(wanted):
            axes.plot(test.frequency, np.abs(test.channel(channel, test.inputs[0])), ".",
                      color=COLOURS[k % len(COLOURS)], markersize=3,
                      label=channel.replace(".", " "))
            axes.plot(fitted.frequency, np.abs(fitted.channel(channel, fitted.inputs[0])),
                      color=INK, linewidth=0.9, label="from the modes" if k == 0 else None)
        axes.set(yscale="log", xlabel="frequency in Hz", ylabel=test.unit,
                 xlim=(test.frequency[0], test.frequency[-1]), title=identification.data["title"])
        axes.legend()
    return axes
