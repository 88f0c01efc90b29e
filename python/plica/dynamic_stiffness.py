"""Dynamic stiffness between two ends, of `plica stiffness`."""
from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .errors import BrokenFolder, MissingData, PlicaError
from .folder import Folder
from .hdf5 import opened, text
from .optional import have, need
from .tables import Table

Array = npt.NDArray[Any]
FORMAT, FORMAT_VERSION = "plica dynamic stiffness", 1
AXES = ("x", "y", "z", "rx", "ry", "rz")


@dataclass(frozen=True)
class DynamicStiffness:
    """Z[state, level, line, i, j]: force on `coordinates[i]` by a motion of `coordinates[j]`.

    Z complex, N/m, N/rad, N or Nm/rad; frequency (lines,) in Hz; amplitude (levels,) in m and angle
    (levels,) in rad of the moving end, 0 = small motion; coordinates such as "left.x", six an end.
    """

    states: tuple[str, ...]
    amplitude: Array
    angle: Array
    frequency: Array
    coordinates: tuple[str, ...]
    Z: Array
    folder: Folder = field(repr=False)

    @property
    def array(self) -> Any:
        """As xarray.DataArray (state, level, frequency, force, motion) with units."""
        array = need("xarray", "a DataArray").DataArray(
            self.Z, dims=("state", "level", "frequency", "force", "motion"), name="Z",
            coords={"state": list(self.states), "frequency": self.frequency,
                    "force": list(self.coordinates), "motion": list(self.coordinates),
                    "amplitude": ("level", self.amplitude), "angle": ("level", self.angle)},
            attrs={"units": "SI: N/m, N/rad, N, Nm/rad by force and motion"})
        for name, unit in (("frequency", "Hz"), ("amplitude", "m"), ("angle", "rad")):
            array[name].attrs["units"] = unit
        return array

    @property
    def ends(self) -> tuple[str, str]:
        """The end that moves and the one that is held."""
        return self.coordinates[0].rpartition(".")[0], self.coordinates[6].rpartition(".")[0]

    def transfer(self, direction: str, state: int = 0, level: int = 0) -> Array:
        """Blocked transfer stiffness k21 in a direction over the lines: the force that the part
        exerts on its held end, at rest the static stiffness."""
        if direction not in AXES:
            raise MissingData(f"there is no direction '{direction}'; {', '.join(AXES)}")
        k = AXES.index(direction)
        return np.asarray(-self.Z[state, level, :, 6 + k, k])

    @property
    def table(self) -> Any:
        """DataFrame: k11, k22, k21, a row per state, amplitude, frequency and direction."""
        return self.folder.table("transfer_stiffness").frame()

    @property
    def comparison(self) -> Any:
        """DataFrame: beside the table of a rig; MissingData without `measured`."""
        return self.folder.table("stiffness_comparison").frame()


def read_stiffness(folder: Folder) -> DynamicStiffness:
    """Of stiffness.h5 where h5py is present, else of stiffness.csv, which needs numpy alone."""
    if folder.has("stiffness.h5") and (have("h5py") or not folder.has("stiffness.csv")):
        try:
            return folder.read("stiffness.h5", lambda path: _of_hdf5(path, folder))
        except (OSError, LookupError, ValueError) as error:
            if isinstance(error, PlicaError):
                raise
            raise BrokenFolder(f"{folder.path}/stiffness.h5: is damaged or no dynamic stiffness "
                               f"of plica: {error}; run `plica stiffness` anew") from error
    table = folder.table("stiffness")
    try:
        return _of_table(table, folder)
    except (KeyError, ValueError, IndexError) as error:
        raise BrokenFolder(f"{table.path}: is no dynamic stiffness of plica: {error}; run "
                           "`plica stiffness` anew") from error


def _of_hdf5(path: Path, folder: Folder) -> DynamicStiffness:
    with opened(path, FORMAT, FORMAT_VERSION, "run `plica stiffness` anew") as file:
        return DynamicStiffness(
            tuple(text(s) for s in file["states"][:]), file["amplitude"][:], file["angle"][:],
            file["frequency"][:], tuple(text(c) for c in file["coordinates"][:]),
            file["real"][:] + 1j * file["imaginary"][:], folder)


def _of_table(table: Table, folder: Folder) -> DynamicStiffness:
    """Terms that are not in it are zero."""
    frequency, state, level = table["frequency"], table["state"], _levels(table)
    lines = np.unique(frequency)
    states = list(dict.fromkeys(str(s) for s in state))
    levels = list(dict.fromkeys(level))
    terms = [name[:-len(" storage")] for name in table if name.endswith(" storage")]
    ends = list(dict.fromkeys(c.rpartition(".")[0] for t in terms for c in t.split(" by ")))
    coordinates = [f"{end}.{axis}" for end in ends for axis in AXES]
    at = (np.array([states.index(str(s)) for s in state], dtype=int),
          np.array([levels.index(one) for one in level], dtype=int),
          np.searchsorted(lines, frequency))
    Z = np.zeros((len(states), len(levels), len(lines), 12, 12), dtype=complex)
    for term in terms:
        force, motion = (coordinates.index(c) for c in term.split(" by "))
        Z[(*at, force, motion)] = table[term + " storage"] + 1j * table[term + " loss"]
    return DynamicStiffness(tuple(states), np.array([one[0] for one in levels]),
                            np.array([one[1] for one in levels]), lines, tuple(coordinates), Z,
                            folder)


def _levels(table: Table) -> list[tuple[float, float]]:
    return [(float(a), float(b)) for a, b in zip(table["amplitude"], table["angle of motion"])]
