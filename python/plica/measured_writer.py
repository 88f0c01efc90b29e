"""measured.yaml from arrays: what a lab with Python hands to `plica identify` and `diagnose`."""
from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Iterable, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from .frf import Frf
from .measured import Measured, read_measured
from .signals import Signals

Array = npt.NDArray[Any]
Rows = Any  # a DataFrame, or an iterable of dicts
QUANTITIES = {"m/s2 per N": "accelerance", "m/s per N": "mobility", "m per N": "receptance"}


def measured(folder: str | Path, specimen: str, *,
             mass: float | Mapping[str, Any] | Rows | None = None,
             sensors: Rows = (), static: Rows = (), modes: Rows = (), peaks: Rows = (),
             frf: Frf | Sequence[Frf] = (), signals: Signals | Sequence[Signals] = (),
             source: str = "", states: Rows = (), hold_out: Sequence[str] = (),
             caveats: Sequence[str] = (), sigma: Mapping[str, float] | None = None) -> Measured:
    """Writes measured.yaml with its tables into `folder` and gives it back, read.

    Numbers are in SI. Rows are DataFrames or dicts with the keys of `plica schema measured`; NaN
    and None are left out. `mass`: a number, one weighing as a dict, several as rows. `frf`: one
    table an input, frf_1.csv and so on; `base.y` is a motion of the table, any other (`mid.y`) a
    force, and `unit` says what the response is; `sigma` {"relative": 0.02, "floor": 0.01} goes to
    all of them. ValueError where a unit is not SI or a number none; FileExistsError names a file
    that is there already. Reading back needs PyYAML.
    """
    folder = Path(folder)
    frfs = [Frf(f.frequency, f.by_input(driven), f.outputs, (driven,), f.unit, f.level)
            for f in ([frf] if isinstance(frf, Frf) else frf) for driven in f.inputs]
    records = [signals] if isinstance(signals, Signals) else list(signals)
    files: dict[str, str] = {}
    entries: dict[str, Any] = {
        "specimen": specimen, "source": source or None, "sensors": _rows(sensors),
        "states": _rows(states), "mass": _mass(mass),
        "static": _rows(static), "modes": _rows(modes), "peaks": _rows(peaks),
        "frf": [_frf_entry(f, f"frf_{k}.csv", sigma, files) for k, f in enumerate(frfs, 1)],
        "signals": [_signals_entry(s, f"signals_{k}.csv", files)
                    for k, s in enumerate(records, 1)],
        "hold_out": list(hold_out), "caveats": list(caveats)}
    files["measured.yaml"] = "".join(_section(k, v) for k, v in entries.items())
    folder.mkdir(parents=True, exist_ok=True)
    for name in files:
        if (folder / name).exists():
            raise FileExistsError(f"{folder / name}: is there already; a new folder")
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    return read_measured(folder)


def _mass(mass: float | Mapping[str, Any] | Rows | None) -> Any:
    if isinstance(mass, (int, float)):
        return {"value": mass}
    return mass if mass is None or isinstance(mass, Mapping) else _rows(mass)


def _rows(rows: Rows) -> list[dict[str, Any]]:
    dicts: Iterable[Mapping[str, Any]] = rows.to_dict("records") if hasattr(rows, "to_dict") \
        else rows
    return [{str(k): v for k, v in row.items() if not _missing(v)} for row in dicts]


def _missing(value: Any) -> bool:
    return value is None or (isinstance(value, float) and np.isnan(value))


def _section(key: str, value: Any) -> str:
    if value is None or value == [] or value == {}:
        return ""
    if isinstance(value, list):
        return f"{key}:\n" + "".join(f"  - {_flow(item)}\n" for item in value)
    return f"{key}: {_flow(value)}\n"


def _flow(value: Any) -> str:
    """JSON, which YAML reads; numbers in full."""
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{k}: {_flow(v)}" for k, v in value.items()
                               if not _missing(v)) + "}"
    if isinstance(value, (list, tuple, np.ndarray)):
        return "[" + ", ".join(_flow(v) for v in value) + "]"
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, np.generic):
        return _flow(value.item())
    if isinstance(value, float) and not np.isfinite(value):
        raise ValueError(f"{value} is no number for measured.yaml; leave it out")
    return repr(value) if isinstance(value, (int, float)) else json.dumps(str(value),
                                                                          ensure_ascii=False)


def _frf_entry(frf: Frf, name: str, sigma: Mapping[str, float] | None,
               files: dict[str, str]) -> dict[str, Any]:
    heads = ["frequency [Hz]"] + [f"{c.replace('.', ' ')} {part}" for c in frf.outputs
                                  for part in ("real", "imaginary")]
    H = frf.H[:, :, 0]
    parts = np.stack([H.real, H.imag], axis=2).reshape(len(H), -1)
    files[name] = _csv(heads, np.column_stack([frf.frequency, parts]))
    source, _, axis = frf.inputs[0].rpartition(".")
    driven = {"base": axis} if source == "base" else {"force": frf.inputs[0]}
    allowed = ["", "m/s2 per m/s2"] if source == "base" else ["", *QUANTITIES]
    if frf.unit not in allowed:
        raise ValueError(f"{name}: responses to {frf.inputs[0]} in '{frf.unit}'; SI: "
                         + ", ".join(allowed[1:]))
    return {"file": name, **driven, "level": frf.level, "quantity": QUANTITIES.get(frf.unit),
            "sigma": sigma}


def _signals_entry(signals: Signals, name: str, files: dict[str, str]) -> dict[str, Any]:
    units = signals.units or ("",) * len(signals.channels)
    heads = ["time [s]"] + [c + (f" [{u}]" if u else "") for c, u in zip(signals.channels, units)]
    time = np.arange(len(signals.data)) / signals.rate
    files[name] = _csv(heads, np.column_stack([time, signals.data]))
    return {"file": name, "channels": list(signals.channels), **signals.entry}


def _csv(heads: Sequence[str], rows: Array) -> str:
    body = "\n".join(",".join(map(repr, row)) for row in np.asarray(rows, dtype=float).tolist())
    return ",".join(heads) + "\n" + body + "\n"
