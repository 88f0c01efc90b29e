"""SDyPy: responses as its modal analysis takes them, and time signals by SEP 005.

SEP 005 (draft): a list of dicts, one a channel, with data, name (unique), unit_str, and fs [Hz] or
time [s]; optional channel_name, quantity, unit_tex, start_timestamp. A dict may hold several
channels, data (channels, samples), with lists in channel_name and unit_str. Prohibited: unit,
timestamp, signal, sample_frequency, and names of the others with other cases or underscores.
"""
from __future__ import annotations

from typing import Any, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from ..frf import Frf
from ..signals import Signals

Array = npt.NDArray[Any]
PROHIBITED = ("unit", "timestamp", "signal", "sample_frequency")
KNOWN = ("data", "fs", "name", "time", "channel_name", "quantity", "start_timestamp",
         "start_timestamp_format", "end_timestamp", "unit_str", "unit_tex")
QUANTITIES = {"N": "f", "m/s2": "a", "m/s": "v", "m": "d", "Pa": "s"}


def to_sdypy(frf: Frf, input: str | None = None) -> tuple[Array, Array]:
    """(H, frequency): H (outputs, lines) of one input, as sdypy.EMA.Model takes it; of
    "m per N" its frf_type is receptance, of "m/s per N" mobility, of "m/s2 per N" accelerance.

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
             "unit_str": units[k],
             **({"quantity": QUANTITIES[units[k]]} if units[k] in QUANTITIES else {})}
            for k, name in enumerate(signals.channels)]


def from_sep005(channels: Mapping[str, Any] | Sequence[Mapping[str, Any]], **entry: Any) -> Signals:
    """Signals of equal length and rate; `entry`: keys of `signals[]`, such as base and reference.
    Of a dict with several channels they are named by its channel_name.

    ValueError says of which channel what SEP 005 asks for is not kept.
    """
    given = [channels] if isinstance(channels, Mapping) else channels
    single = [one for channel in given for one in _single(channel)]
    names = [str(c.get("name", "")) for c in single]
    if not single or len(set(names)) != len(names) or not all(names):
        raise ValueError(f"names {names}; SEP 005 asks for a unique name of every channel")
    rates = [_rate(c) for c in single]
    if np.ptp(rates) > 1e-9 * rates[0] or len({len(c["data"]) for c in single}) != 1:
        raise ValueError(f"rates {rates} Hz; one rate and one length of all channels")
    return Signals(rates[0], np.column_stack([np.asarray(c["data"], dtype=float)
                                              for c in single]), tuple(names),
                   tuple(str(c["unit_str"] or "") for c in single), entry)


def _single(channel: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """A dict a channel."""
    if np.ndim(channel["data"]) != 2:
        return [channel]
    rows = np.asarray(channel["data"])
    names, units = channel.get("channel_name"), channel.get("unit_str")
    if not isinstance(names, (list, tuple)) or len(names) != len(rows):
        raise ValueError(f"{channel.get('name')}: has {len(rows)} channels; SEP 005 asks for as "
                         "many names in channel_name")
    if isinstance(units, (list, tuple)) and len(units) != len(rows):
        raise ValueError(f"{channel.get('name')}: has {len(rows)} channels; as many in unit_str, "
                         "or one for all")
    return [{**channel, "data": row, "name": name,
             **({"unit_str": units[k]} if isinstance(units, (list, tuple)) else {})}
            for k, (row, name) in enumerate(zip(rows, names))]


def _rate(channel: Mapping[str, Any]) -> float:
    name = channel["name"]
    plain = {key.replace("_", "").lower(): key for key in KNOWN}
    bad = [key for key in channel if key in PROHIBITED
           or plain.get(key.replace("_", "").lower(), key) != key]
    if bad:
        raise ValueError(f"channel {name}: has the key '{bad[0]}', which SEP 005 prohibits")
    if "unit_str" not in channel or np.ndim(channel["data"]) != 1:
        raise ValueError(f"channel {name}: SEP 005 asks for unit_str; data of one or two "
                         "dimensions")
    if channel.get("fs") is not None:
        return float(channel["fs"])
    time = channel.get("time")
    if time is None or len(time) != len(channel["data"]):
        raise ValueError(f"channel {name}: SEP 005 asks for fs, or time as long as data")
    steps = np.diff(np.asarray(time, dtype=float))
    if np.ptp(steps) > 1e-6 * np.mean(steps):
        raise ValueError(f"channel {name}: its times are not equally spaced; resample it")
    return float(1 / np.mean(steps))
