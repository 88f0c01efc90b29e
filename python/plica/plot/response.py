"""Responses over frequency, the test over the simulation."""
from __future__ import annotations

from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, Sequence

import numpy as np

from ..errors import BrokenFolder, MissingData
from ..frf import Frf
from ..measured import Measured, read_measured
from .style import COLOURS, DASHES, look

if TYPE_CHECKING:
    from ..results import Results

LEAST = 1e-3  # of the largest: channels below are left out unless they are named


def draw(results: Results, name: str | None = None, *, channels: Sequence[str] | None = None,
         measured: Measured | str | Path | bool | None = None, phase: bool = False,
         ax: Any = None) -> Any:
    """Magnitude (log) of a response, the first unless named, or its phase in degrees.

    channels: such as ["mid.y"]; unless given those that reach a thousandth of the largest.
    measured: test data, or their file, whose responses to the same excitation are drawn over it;
    unless given those of the test that the run was held against, at the level that is nearest,
    where it has such; True for those at all levels, False for none.
    """
    if not results.responses:
        raise MissingData(f"{results.path}: no responses; analyses.response in the case")
    response = results.responses[name or next(iter(results.responses))]
    frf = response.frf
    wanted = list(channels) if channels else _large(frf)
    tests = _tests(results, measured, frf)
    with look(ax) as axes:
        for k, channel in enumerate(wanted):
            colour = COLOURS[k % len(COLOURS)]
            axes.plot(frf.frequency, _value(frf.channel(channel), phase), color=colour,
                      linestyle=DASHES[k % len(DASHES)], label=channel.replace(".", " "))
            for t, test in enumerate(tests, start=1):
                if channel in test.outputs:
                    at = f" at {test.level:g}" if test.level else ""
                    axes.plot(test.frequency, _value(test.channel(channel), phase), ".",
                              markersize=2, color=COLOURS[(k + t) % len(COLOURS)], zorder=1,
                              label=f"{channel.replace('.', ' ')}, test{at}")
        if not phase:
            axes.set_yscale("log")
        axes.set(xlabel="frequency in Hz", title=_title(results, response.source, response.name),
                 ylabel="phase in degrees" if phase else frf.unit,
                 xlim=(frf.frequency[0], frf.frequency[-1]))
        axes.legend()
    return axes


def _value(values: Any, phase: bool) -> Any:
    return np.degrees(np.unwrap(np.angle(values))) if phase else np.abs(values)


def _large(frf: Frf) -> list[str]:
    largest = np.abs(frf.H[:, :, 0]).max(axis=0)
    return [c for c, m in zip(frf.outputs, largest) if m >= LEAST * largest.max()]


def _tests(results: Results, measured: Measured | str | Path | bool | None, computed: Frf
           ) -> list[Frf]:
    driven = computed.inputs[0]
    if measured is False:
        return []
    if measured is None:
        with suppress(MissingData, BrokenFolder):  # the plot is of what was computed
            tests = [test for test in results.measured.frf if driven in test.inputs]
            away = [_distance(test.level, computed.level) for test in tests]
            return [test for test, far in zip(tests, away) if far == min(away)]
        return []
    data = results.measured if measured is True else \
        measured if isinstance(measured, Measured) else read_measured(measured)
    found = [test for test in data.frf if driven in test.inputs]
    if not found:
        raise MissingData(f"{data.path}: has no response to {driven}; frf: [{{file: ..., base: "
                          "...}]")
    return found


def _distance(level: float | None, computed: float | None) -> float:
    return abs(float(np.log(level / computed))) if level and computed else 0.0


def _title(results: Results, source: str, name: str) -> str:
    words = {"base": "base moved in", "force": "force", "motion": "ends moved:",
             "together": "together:"}
    return f"{results.case}, {words[source]} {name}"
