"""pyFBS: responses Y (lines, channels, impacts) with a DataFrame of channels and one of impacts.

Columns of both, as in its example data: Name, Description, Quantity, Grouping, Position_1..3 [m],
Direction_1..3 (unit vector; of a rotation its axis). By Quantity its transformation to virtual
points tells rotations ("Angular Acceleration") from translations.
"""
from __future__ import annotations

from typing import Any, Mapping, NamedTuple, Sequence

import numpy as np
import numpy.typing as npt

from ..documents import frame_of
from ..frf import AXES, Frf, axis_of

QUANTITIES = {"m/s2": "Acceleration", "m/s": "Velocity", "m": "Displacement", "N": "Force",
              "rad/s2": "Angular Acceleration", "rad/s": "Angular Velocity", "rad": "Rotation",
              "Nm": "Moment"}
ANGULAR = {"m/s2": "rad/s2", "m/s": "rad/s", "m": "rad", "N": "Nm"}
Places = Mapping[str, Sequence[float]]


class PyFbs(NamedTuple):
    """What pyFBS works on: Y[k, i, j], freq [Hz], df_chn (rows i), df_imp (rows j)."""

    Y: npt.NDArray[np.complex128]
    freq: npt.NDArray[np.float64]
    df_chn: Any
    df_imp: Any


def to_pyfbs(frf: Frf, places: Places | None = None,
             grouping: Mapping[str, int] | None = None) -> PyFbs:
    """`places`: [x, y, z] of each sensor by name, m, 0 unless given; `grouping` likewise."""
    top, _, bottom = frf.unit.partition(" per ")

    def rows(channels: Sequence[str], unit: str) -> list[dict[str, Any]]:
        result = []
        for channel in channels:
            name, axis = axis_of(channel)
            place = (places or {}).get(name, (0.0, 0.0, 0.0))
            vector = np.eye(3)[AXES.index(axis) % 3] if axis else np.zeros(3)
            own = ANGULAR.get(unit, unit) if axis.startswith("r") else unit
            result.append({"Name": channel, "Description": name,
                           "Quantity": QUANTITIES.get(own, own),
                           "Grouping": (grouping or {}).get(name, 1),
                           **{f"Position_{k + 1}": float(place[k]) for k in range(3)},
                           **{f"Direction_{k + 1}": float(vector[k]) for k in range(3)}})
        return result
    return PyFbs(np.array(frf.H, dtype=complex), np.array(frf.frequency, dtype=float),
                 frame_of(rows(frf.outputs, top)), frame_of(rows(frf.inputs, bottom)))


def from_pyfbs(Y: npt.ArrayLike, freq: npt.ArrayLike, df_chn: Any, df_imp: Any,
               unit: str | None = None) -> Frf:
    """Channels by the column Name; where the names are not unique, by their number as well.

    Unless `unit` is given, by the column Unit of both tables, else by Quantity, else m/s2 per N.
    """
    def channels(frame: Any) -> tuple[str, ...]:
        names = [str(name) for name in frame["Name"]]
        return tuple(name if names.count(name) == 1 else f"{name}#{k + 1}"
                     for k, name in enumerate(names))
    return Frf(np.asarray(freq, dtype=float), np.asarray(Y, dtype=complex), channels(df_chn),
               channels(df_imp), _unit(df_chn, df_imp) if unit is None else unit)


def _unit(df_chn: Any, df_imp: Any) -> str:
    """That of translations where there are such. Where a table has no unit, or several, m/s2 of
    responses and N of impacts."""
    units = {quantity.lower(): unit for unit, quantity in QUANTITIES.items()}
    plain = {angular: unit for unit, angular in ANGULAR.items()}
    parts = []
    for frame, usual in ((df_chn, "m/s2"), (df_imp, "N")):
        column = next((name for name in ("Unit", "Quantity") if name in frame), None)
        said = [str(value).strip() for value in frame[column]] if column else []
        found = {units.get(value.lower(), value) for value in said}
        found -= {unit for unit in found if plain.get(unit) in found}
        parts.append(found.pop() if len(found) == 1 else usual)
    return " per ".join(part for part in parts if part)
