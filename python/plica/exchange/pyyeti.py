"""pyYeti: DMIG as DataFrames with (id, dof) on both sides, and Craig-Bampton matrices with b-set.

`nastran.wtdmig(f, to_dmig(s))`; `cb.cbcheck(f, c["mcb"], c["kcb"], c["bset"], c["bset"][:6],
to_uset(s))`.
"""
from __future__ import annotations

from typing import Any, Mapping

import numpy as np
import numpy.typing as npt

from ..optional import need
from ..superelement import Superelement
from .pynastran import NAMES, grids, labels

Array = npt.NDArray[Any]
B_SET = 1 << 21 | 1 << 1  # bits of a row of the b-set


def to_dmig(s: Superelement) -> dict[str, Any]:
    """DataFrames by name, rows and columns a MultiIndex (id, dof); dof 0 is a scalar point."""
    pandas = need("pandas", "DMIG as DataFrames")
    index = pandas.MultiIndex.from_tuples(labels(s), names=["id", "dof"])
    return {NAMES[letter]: pandas.DataFrame(matrix, index=index, columns=index)
            for letter, matrix in s.matrices.items()}


def from_dmig(frames: Mapping[str, Any], s: Superelement) -> dict[str, Array]:
    """By letter, in the order of `s`; what a frame does not have is zero (`rddmig` leaves empty
    rows out). Names are taken as in `to_dmig`, upper or lower case."""
    letters = {name: letter for letter, name in NAMES.items()}
    pandas = need("pandas", "DMIG as DataFrames")
    index = pandas.MultiIndex.from_tuples(labels(s), names=["id", "dof"])
    return {letters[name.upper()]: np.asarray(
        frame.reindex(index=index, columns=index).fillna(0.0), dtype=float)
        for name, frame in frames.items() if name.upper() in letters}


def to_uset(s: Superelement) -> Any:
    """DataFrame over (id, dof) of the b-set: nasset, and x y z, which of the six rows of a grid are
    its place, the system of coordinates (number 0, kind 1: rectangular), its origin, its axes."""
    pandas = need("pandas", "a table of the b-set")
    index = pandas.MultiIndex.from_tuples(labels(s)[:s.boundary], names=["id", "dof"])
    rows = [np.vstack([place, [0, 1, 0], [0, 0, 0], np.eye(3)]) for place in grids(s).values()]
    frame = pandas.DataFrame(np.vstack(rows), index=index, columns=["x", "y", "z"])
    frame.insert(0, "nasset", B_SET)
    return frame


def to_craig_bampton(s: Superelement) -> dict[str, Any]:
    """mcb, kcb (n, n); bset, qset: places of boundary and modal coordinates, from 0; xyz (nodes, 3)
    of the boundary; frequencies [Hz] with the boundary held, (modal,)."""
    return {"mcb": s.dense("M").copy(), "kcb": s.dense("K").copy(),
            "bset": np.arange(s.boundary), "qset": np.arange(s.boundary, s.boundary + s.modal),
            "xyz": s.places.copy(), "frequencies": s.fixed_frequencies}
