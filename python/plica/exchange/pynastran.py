"""pyNastran: superelements as DMIG entries and as OUTPUT4 matrices.

Boundary nodes are grids from 101 in their order, modal coordinates scalar points from 1001, as in
superelement.bdf. `model.add_dmig(**to_dmig(s)["KPLICA"])`, `OP4().write_op4(f, to_op4(s))`.
"""
from __future__ import annotations

from typing import Any, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from ..superelement import Superelement

Array = npt.NDArray[Any]
FIRST_GRID, FIRST_SCALAR = 101, 1001
RECTANGULAR, SYMMETRIC = 2, 6  # forms of a matrix
NAMES = {"K": "KPLICA", "M": "MPLICA", "C": "BPLICA", "D": "K4PLICA"}
RECOVERY = "OTMPLICA"  # motion of recovered points by the coordinates, six rows each


def labels(s: Superelement) -> list[tuple[int, int]]:
    """(point, component) of every coordinate; component 0 is a scalar point."""
    grids = [(FIRST_GRID + k, dof) for k in range(len(s.node_names)) for dof in range(1, 7)]
    return grids + [(FIRST_SCALAR + k, 0) for k in range(s.modal)]


def grids(s: Superelement) -> dict[int, Array]:
    """Places (3,) of the grids by number, in the units of the superelement."""
    return {FIRST_GRID + k: place.copy() for k, place in enumerate(s.places)}


def to_dmig(s: Superelement) -> dict[str, dict[str, Any]]:
    """Keywords of `BDF.add_dmig`, by matrix: lower triangle, zeros left out. Their order is not the
    same in all versions.

    ifo 6 (symmetric), tin and tout 2 (real, double), GCj columns and GCi rows as (point,
    component), Real their values.
    """
    points = labels(s)
    result = {}
    for letter, matrix in s.matrices.items():
        columns, rows = np.nonzero(np.triu(matrix))  # the transpose: column by column
        result[NAMES[letter]] = {
            "name": NAMES[letter], "ifo": SYMMETRIC, "tin": 2, "tout": 0, "polar": 0, "ncols": 0,
            "GCj": [points[j] for j in columns], "GCi": [points[i] for i in rows],
            "Real": matrix[rows, columns].tolist()}
    return result


def from_dmig(matrix: Array, rows: Mapping[int, tuple[int, int]], wanted: Sequence[tuple[int, int]]
              ) -> Array:
    """(n, n) in the order of `wanted`, from what `DMIG.get_matrix()` gives: the matrix and which
    (point, component) a row is. Coordinates that it does not have are zero.
    """
    dense = matrix.toarray() if hasattr(matrix, "toarray") else np.asarray(matrix)
    place = {tuple(label): k for k, label in rows.items()}
    result = np.zeros((len(wanted), len(wanted)))
    known = [k for k, label in enumerate(wanted) if tuple(label) in place]
    at = [place[tuple(wanted[k])] for k in known]
    result[np.ix_(known, known)] = dense[np.ix_(at, at)]
    return result


def to_op4(s: Superelement) -> dict[str, tuple[int, Array]]:
    """(form, matrix) by name, as `OP4.write_op4` takes matrices; with that of recovered points."""
    found = {NAMES[letter]: (SYMMETRIC, matrix.copy()) for letter, matrix in s.matrices.items()}
    if s.recovery:
        found[RECOVERY] = RECTANGULAR, np.vstack([point.rows for point in s.recovery.values()])
    return found


def from_op4(matrices: Mapping[str, Any]) -> dict[str, Array]:
    """By letter (K, M, C, D), from what `OP4.read_op4` gives: (form, matrix) or an object with
    `data`, by name."""
    letters = {name: letter for letter, name in NAMES.items()}
    result = {}
    for name, entry in matrices.items():
        if name.upper() in letters:
            matrix = entry[1] if isinstance(entry, tuple) else getattr(entry, "data", entry)
            result[letters[name.upper()]] = np.array(
                matrix.toarray() if hasattr(matrix, "toarray") else matrix, dtype=float)
    return result
