"""Many folders of results in one table."""
from __future__ import annotations

from pathlib import Path
from typing import Any, Iterable

from .documents import frame_of
from .errors import BrokenFolder
from .results import Results


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
        results = Results(path)
        data = results.data
        rows.append({"folder": str(path), "case": data["case"], "model": data["modelled_as"],
                     "proved": results.proved, "nodes": data["model"]["nodes"],
                     "mass": data["model"]["mass"], **data["headline"],
                     **{f"f{k}": mode["frequency"] for k, mode in enumerate(data["modes"], 1)}})
    return frame_of(rows, {"mass": "kg"})
