"""Superelements read from HDF5, or from JSON and Matrix Market, which need numpy alone."""
from __future__ import annotations

import json
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .errors import BrokenFolder, MissingData
from .hdf5 import opened, text
from .optional import have
from .superelement import Recovery, Superelement
from .written import check_written, written

Array = npt.NDArray[Any]
FORMAT, FORMAT_VERSION = "plica superelement", 2


def read_superelement(path: str | Path) -> Superelement:
    """From a folder of results, or its superelement.h5 or superelement.json.

    Of a folder the HDF5 file is read where h5py is present, else JSON and Matrix Market, which
    need numpy alone and have neither stress rows nor places of recovered points: a warning says so.
    """
    path = Path(path)
    if path.is_dir():
        h5, sidecar = path / "superelement.h5", path / "superelement.json"
        if not h5.is_file() and h5.name in written(path):
            raise BrokenFolder(f"{h5}: is missing, plica wrote it here; reduce the case anew")
        if not h5.is_file() and not sidecar.is_file():
            raise MissingData(f"{path}: has no superelement; `plica reduce CASE --out {path}` "
                              "writes it")
        path = h5 if h5.is_file() and (have("h5py") or not sidecar.is_file()) else sidecar
        if path == sidecar and h5.is_file():
            warnings.warn(f"{h5}: has stress rows and places of recovered points, which need h5py "
                          f"(apt install python3-h5py); read from {path.name}, they are left out",
                          UserWarning, stacklevel=2)
    check_written(path)
    try:
        return _from_hdf5(path) if path.suffix == ".h5" else _from_json(path)
    except (OSError, LookupError, TypeError, ValueError, AttributeError) as error:
        if isinstance(error, MissingData):
            raise
        raise BrokenFolder(f"{path}: is damaged or no superelement of plica: {error}; reduce the "
                           "case anew") from error


def _from_hdf5(path: Path) -> Superelement:
    with opened(path, FORMAT, FORMAT_VERSION, "reduce the case anew") as file:
        def entries(group: str) -> list[Any]:
            return [file[group][str(k)] for k in range(len(file[group]))]

        def rows(group: str) -> dict[str, Recovery]:
            return {text(e.attrs["name"]): Recovery(e["place"][:].ravel(), e["rows"][:])
                    for e in entries(group)}
        places = file["nodes"][:]
        return Superelement(
            text(file.attrs["name"]), text(file.attrs["units"]),
            tuple(text(file["node_names"].attrs[str(k)]) for k in range(len(places))), places,
            {letter: file[letter][:] for letter in "KMCD" if letter in file},
            rows("recovery"), rows("stresses"),
            {text(e.attrs["name"]): e["force"][:].ravel() for e in entries("loads")})


def _from_json(path: Path) -> Superelement:
    data = json.loads(path.read_text(encoding="utf-8"))
    files = {letter: path.with_name(f"superelement_{letter.lower()}.mtx") for letter in "KMCD"}
    lost = [f.name for f in files.values() if f.name in written(path.parent) and not f.is_file()]
    if lost:
        raise ValueError(f"{lost[0]} is missing, plica wrote it here")
    matrices = {k: read_matrix_market(f) for k, f in files.items() if f.is_file()}
    places = np.array(data["nodes"], dtype=float).reshape(-1, 3)
    names = tuple(data["coordinates"][6 * k].rpartition(".")[0] for k in range(len(places)))
    recovery = {name: Recovery(np.full(3, np.nan), np.array(rows, dtype=float))
                for name, rows in data["recovery"].items()}
    loads = {name: np.array(force, dtype=float) for name, force in data["loads"].items()}
    if "K" not in matrices or "M" not in matrices:
        raise ValueError("superelement_k.mtx or superelement_m.mtx is not beside it")
    return Superelement(data["name"], data["units"], names, places, matrices, recovery, {}, loads)


def read_matrix_market(path: str | Path) -> Array:
    """A symmetric real coordinate matrix, (n, n) and full."""
    path = Path(path)
    check_written(path)
    text = path.read_text(encoding="utf-8")
    if not text.endswith("\n"):
        raise ValueError(f"{path}: is cut, its last line has no end")
    lines = [line for line in text.splitlines() if line]
    if not lines or not lines[0].startswith("%%MatrixMarket matrix coordinate real symmetric"):
        raise ValueError(f"{path}: is no symmetric real coordinate matrix of Matrix Market")
    rows = [line for line in lines if not line.startswith("%")]
    size, _, count = (int(n) for n in rows[0].split())
    entries = np.array(" ".join(rows[1:]).split(), dtype=float).reshape(-1, 3)
    if len(entries) != count:
        raise ValueError(f"{path}: has {len(entries)} entries, its head says {count}")
    matrix = np.zeros((size, size))
    i, j = entries[:, 0].astype(int) - 1, entries[:, 1].astype(int) - 1
    matrix[i, j] = matrix[j, i] = entries[:, 2]
    return matrix
