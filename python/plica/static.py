"""Static stiffness between the two caps."""
from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .errors import MissingData
from .optional import need

UNITS = {"axial": "N/m", "transverse_x": "N/m", "transverse_z": "N/m", "bending_x": "Nm/rad",
         "bending_z": "Nm/rad", "torsion": "Nm/rad"}


@dataclass(frozen=True)
class StaticStiffness:
    """axial, transverse_* in N/m; bending_*, torsion in Nm/rad. How each is defined: the docs.

    `end_stiffness` (12, 12): forces of the left and the right cap by their motions, ux uy uz rx
    ry rz each. `mesh_error`: what the numbers miss of their converged values, where it was asked.
    """

    axial: float
    transverse_x: float
    transverse_z: float
    bending_x: float
    bending_z: float
    torsion: float
    end_stiffness: npt.NDArray[np.float64] = field(repr=False)
    mesh_error: dict[str, float] = field(repr=False)

    @staticmethod
    def of(data: dict[str, Any], path: Path) -> StaticStiffness:
        """From results.json; MissingData where there is none."""
        static = data.get("static")
        if static is None:
            raise MissingData(f"{path}: no static stiffness; `static: true` and two caps in the "
                              "case")
        errors = {}
        if "mesh_error" in static:
            for name, error in _flat(static["mesh_error"]).items():
                known = [v for v in error.values() if v is not None]
                errors[name] = sum(known) if known else float("nan")
        return StaticStiffness(**_flat(static), mesh_error=errors, end_stiffness=np.array(
            static["end_stiffness"], dtype=float))

    @property
    def series(self) -> Any:
        """pandas.Series by name, units in attrs."""
        series = need("pandas", "a Series").Series({name: getattr(self, name) for name in UNITS},
                                                   name="stiffness")
        series.attrs["units"] = dict(UNITS)
        return series


def _flat(static: dict[str, Any]) -> dict[str, Any]:
    """By the names of UNITS, as they stand in measured.yaml."""
    return {"axial": static["k_axial"], "torsion": static["k_torsion"],
            **{f"{kind}_{axis}": static[f"k_{kind}"][axis]
               for kind in ("transverse", "bending") for axis in ("x", "z")}}
