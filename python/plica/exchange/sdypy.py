"""SDyPy: responses as its modal analysis takes them, and time signals by SEP 005.

SEP 005 (draft): a list of dicts, one a channel, with data, name (unique), unit_str, and fs [Hz] or
time [s]; optional unit_tex, start_timestamp. Prohibited: unit, timestamp, signal, sample_frequency.
"""
from __future__ import annotations

from typing import Any, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from ..frf import Frf
from ..signals import Signals

Array = npt.NDArray[Any]
PROHIBITED = ("unit", "timestamp", "signal", "sample_frequency", "Fs", "starttimestamp")


def to_sdypy(frf: Frf, input: str | None = None) -> tuple[Array, Array]:
    """(H, frequency): H (outputs, lines) of one input, as sdypy.EMA.Model takes it.

    The only input unless `input` names one.
    """
    columns = [frf.channel(output, input) for output in frf.outputs]
    return np.array(columns), frf.frequency.copy()


def from_sdypy(H: npt.ArrayLike, frequency: npt.ArrayLike, outputs: Sequence[str],
               inputs: Sequence[str] = ("force",), unit: str = "m/s2 per N") -> Frf:
    """H (outputs, lines) of one input, or (outputs, inputs, lines), the order of pyFRF."""
    values = np.asarray(H, dtype=complex)
    values = values[:, None, :] if values.ndim == 2 else values
    return Frf(np.asarray(frequency, dtype=float), values.transpose(2, 0, 1), tuple(outputs),
               tuple(inputs), unit)


def to_sep005(signals: Signals) -> list[dict[str, Any]]:
    """One dict a channel."""
    units = signals.units or ("",) * len(signals.channels)
    return [{"data": signals.data[:, k].copy(), "fs": signals.rate, "name": name,
             "unit_str": units[k]} for k, name in enumerate(signals.channels)]


def from_sep005(channels: Sequence[Mapping[str, Any]], **entry: Any) -> Signals:
    """Signals of equal length and rate; `entry`: keys of `signals[]`, such as base and reference.

    ValueError says of which channel what SEP 005 asks for is not kept.
    """
    names = [str(c.get("name", "")) for c in channels]
    if not channels or len(set(names)) != len(names) or not all(names):
        raise ValueError(f"names {names}; SEP 005 asks for a unique name of every channel")
    rates = [_rate(c) for c in channels]
    if np.ptp(rates) > 1e-9 * rates[0] or len({len(c["data"]) for c in channels}) != 1:
        raise ValueError(f"rates {rates} Hz; one rate and one length of all channels")
    return Signals(rates[0], np.column_stack([np.asarray(c["data"], dtype=float)
                                              for c in channels]), tuple(names),
                   tuple(str(c["unit_str"] or "") for c in channels), entry)


def _rate(channel: Mapping[str, Any]) -> float:
    name = channel["name"]
    bad = [key for key in channel if key in PROHIBITED]
    if bad:
        raise ValueError(f"channel {name}: has the key '{bad[0]}', which SEP 005 prohibits")
    if "unit_str" not in channel or np.ndim(channel["data"]) != 1:
        raise ValueError(f"channel {name}: SEP 005 asks for unit_str; data of one dimension")
    if "fs" in channel:
        return float(channel["fs"])
    if "time" not in channel or len(channel["time"]) != len(channel["data"]):
        raise ValueError(f"channel {name}: SEP 005 asks for fs, or time as long as data")
    steps = np.diff(np.asarray(channel["time"], dtype=float))
    if np.ptp(steps) > 1e-6 * np.mean(steps):
        raise ValueError(f"channel {name}: its times are not equally spaced; resample it")
    return float(1 / np.mean(steps))
