"""Measured data: `measured.yaml` read into tables and responses.

Tables have numbers in SI, also where the file has another unit ("54.4 kN/m"); `data` is as written.
"""
from __future__ import annotations

from functools import cached_property
from pathlib import Path
from typing import Any, Mapping, Sequence

from .documents import frame_of
from .errors import BrokenFolder, MissingData
from .frf import Frf, of_table
from .guard import reads
from .quantities import si
from .tables import read_csv
from .uff58 import read_uff58
from .yaml_text import load

PLAIN = {"frequency": "Hz", "damping": "fraction of critical", "at": "m", "mass": "kg"}


@reads("", "as `plica schema measured` says")
class Measured:
    """A measured.yaml; `data` is the file as it is."""

    def __init__(self, path: Path, data: dict[str, Any]) -> None:
        self.path, self.data = path, data

    def __repr__(self) -> str:
        lists = [f"{len(v)} {k}" for k, v in self.data.items() if isinstance(v, list)]
        return f"<measured data of {self.specimen}: {', '.join(lists)}>"

    @property
    def specimen(self) -> str:
        """The case the data belong to."""
        return str(self.data["specimen"])

    @property
    def mass(self) -> float | None:
        """In kg, of several weighings the first; None where it was not weighed."""
        entry = self.data.get("mass")
        if isinstance(entry, list):
            entry = entry[0] if entry else None
        value, _ = si(entry.get("value") if isinstance(entry, dict) else entry, "mass")
        return float(value) if isinstance(value, (int, float)) else None

    @property
    def weighings(self) -> Any:
        """DataFrame: value [kg], sigma, state, ... of each; empty where it was not weighed."""
        entry = self.data.get("mass") or []
        rows = entry if isinstance(entry, list) else [entry]
        in_kg = ("value", "sigma", "repeats")  # "5 g" is a mass there
        return frame_of([{key: si(value, "mass")[0] if key in in_kg else value
                          for key, value in row.items()} for row in rows],
                        {"value": "kg", "sigma": "kg"})

    def entries(self, name: str) -> Any:
        """DataFrame of a list: "sensors", "modes", "static", "frf", "signals", "states"."""
        return _frame(self.data.get(name) or [])

    @property
    def sensors(self) -> Any:
        """DataFrame: name, at [m], axes, mass."""
        return self.entries("sensors")

    @property
    def modes(self) -> Any:
        """DataFrame: frequency, damping, shape, ... as the file has them."""
        return self.entries("modes")

    @property
    def peaks(self) -> Any:
        """DataFrame: one peak a row, levels unrolled."""
        rows = []
        for entry in self.data.get("peaks") or []:
            levels = entry["level"]
            for k, level in enumerate(levels):
                rows.append({key: v[k] if isinstance(v, list) and len(v) == len(levels) else v
                             for key, v in entry.items()} | {"level": level})
        return _frame(rows)

    @cached_property
    def frf(self) -> list[Frf]:
        """The responses of every entry, CSV or UFF 58; MissingData of a MATLAB file."""
        return [self._load(entry) for entry in self.data.get("frf") or []]

    def _load(self, entry: dict[str, Any]) -> Frf:
        file = self.path.parent / entry["file"]
        level, _ = si(entry.get("level"))
        level = float(level) if isinstance(level, (int, float)) else None
        base = entry.get("base")
        driven = f"base.{base}" if base else str(entry.get("force", ""))
        unit = "m/s2 per m/s2" if base else "m/s2 per N"
        if file.suffix.lower() in (".uff", ".unv"):
            return _of_universal_file(file, driven, level)
        if file.suffix.lower() not in (".csv", ".txt"):
            raise MissingData(f"{file}: is not read here; CSV or UFF 58 (`plica identify` reads it "
                              "and writes frf.uff)")
        frf = of_table(read_csv(file), driven, unit, level)
        names = entry.get("channels")
        if names:
            keep = [i for i, name in enumerate(names) if name != "-"]
            frf = Frf(frf.frequency, frf.H[:, keep], tuple(names[i] for i in keep), frf.inputs,
                      frf.unit, frf.level)
        return frf


def _frame(rows: Sequence[Mapping[str, Any]]) -> Any:
    """In SI; units of the columns that have one of them throughout, or none, in attrs."""
    units: dict[str, set[str]] = {key: {unit} for key, unit in PLAIN.items()}
    converted = []
    for row in rows:
        here = {key: si(value, key) for key, value in row.items()}
        converted.append({key: value for key, (value, _) in here.items()})
        for key, (_, unit) in here.items():
            if unit:
                units.setdefault(key, set()).add(unit)
    return frame_of(converted, {key: found.pop() for key, found in units.items()
                                if len(found) == 1})


def _of_universal_file(file: Path, driven: str, level: float | None) -> Frf:
    from .exchange.pyuff import from_pyuff  # which needs this module
    found = from_pyuff(read_uff58(file))
    for frf in found:
        if driven in frf.inputs:
            return Frf(frf.frequency, frf.by_input(driven), frf.outputs, (driven,), frf.unit,
                       level)
    known = ", ".join(name for frf in found for name in frf.inputs)
    raise MissingData(f"{file}: has no response to {driven}; to {known or 'nothing'}")


def read_measured(path: str | Path) -> Measured:
    """A measured.yaml, or the folder it lies in. BrokenFolder where it cannot be read."""
    path = Path(path)
    path = path / "measured.yaml" if path.is_dir() else path
    try:
        data = load(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise BrokenFolder(f"{path}: cannot be read: {error}; a measured.yaml") from error
    if not isinstance(data, dict) or "specimen" not in data:
        raise BrokenFolder(f"{path}: is no measured data; a map with `specimen`")
    return Measured(path, data)
