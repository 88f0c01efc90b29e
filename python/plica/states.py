"""States in which a part works, beside one another."""
from __future__ import annotations

from typing import Any, Mapping

import numpy as np

from .collect import unit_of
from .documents import frame_of
from .errors import MissingData
from .folder import Folder

AT_REST = "at rest"


def frame_of_states(folder: Folder, data: Mapping[str, Any]) -> Any:
    """DataFrame, one state a row by its name, the part at rest first: headline numbers, largest
    displacement, lowest buckling factor. MissingData where the case has no states."""
    found = [v for v in data["variants"] if v.get("state")]
    if not found:
        raise MissingData(f"{folder.path}: no states; states in the case, run without --state")
    rows: list[dict[str, Any]] = [{"state": AT_REST, **data["headline"]}]
    for variant in found:
        state = variant["state"]
        loads: list[Any] = (state.get("buckling") or {}).get("loads") or []
        factors = [float(load["factor"]) for load in loads]
        rows.append({"state": state["name"], **variant["headline"],
                     "largest_displacement": state["largest_displacement"],
                     "linear_error": state["linear_error"],
                     "buckling_factor": min(factors) if factors else np.nan})
    units = {name: unit_of(name) for row in rows for name in row if unit_of(name)}
    frame = frame_of(rows, {**units, "largest_displacement": "m"})
    return frame.set_index("state")
