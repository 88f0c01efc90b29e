"""Many folders of results in one table."""
from __future__ import annotations

import re
from pathlib import Path
from typing import Any, Iterable

from .documents import frame_of
from .errors import BrokenFolder
from .folder import Folder

KEYS = {"plica_version", "case", "modelled_as", "model", "headline", "modes", "verification"}
UNITS = {"mass": "kg", "k_axial": "N/m", "k_transverse": "N/m", "k_bending": "Nm/rad",
         "k_torsion": "Nm/rad"}


def collect(folders: str | Path | Iterable[str | Path]) -> Any:
    """DataFrame, one folder a row: folder, case, model, proved, headline numbers, frequencies.

    folders: paths, or one path whose folders with a results.json are taken, in the order of their
    names. BrokenFolder where there is none.
    """
    if isinstance(folders, (str, Path)):
        paths = sorted(p.parent for p in Path(folders).glob("**/results.json"))
        if not paths:
            raise BrokenFolder(f"{folders}: has no results.json below it; a folder of runs")
    else:
        paths = [Path(p) for p in folders]
    rows = []
    for path in paths:
        data = Folder(path).head("results.json", KEYS)
        try:
            rows.append(_row(path, data))
        except (KeyError, TypeError, AttributeError) as error:
            raise BrokenFolder(f"{path / 'results.json'}: has no {error}; run the command anew") \
                from error
    return frame_of(rows, {name: unit for row in rows for name in row
                           if (unit := unit_of(name))})


def _row(path: Path, data: dict[str, Any]) -> dict[str, Any]:
    proof = data["verification"]
    return {"folder": str(path), "case": data["case"], "model": data["modelled_as"],
            "proved": bool(proof["made"] and proof["passed"]), "nodes": data["model"]["nodes"],
            "mass": data["model"]["mass"], **data["headline"],
            **{f"f{k}": mode["frequency"] for k, mode in enumerate(data["modes"], 1)}}


def unit_of(name: str) -> str:
    """Of a headline number, as `plica sweep` gives it; empty where it has none."""
    if re.fullmatch(r"f\d+|f_.*", name):
        return "Hz"
    return UNITS.get(name.split("/")[0], "Pa" if name.startswith("life_") else "")
