"""Craig-Bampton superelements of `plica reduce`.

u = Psi u_b + Phi q; coordinates are ux uy uz rx ry rz of each boundary node, in order, then the
modal ones. Numbers are in `units`: "m kg s N rad", or in mm and t where that was asked for.
"""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from .documents import frame_of
from .errors import MissingData
from .optional import need

Array = npt.NDArray[Any]
DOFS = ("ux", "uy", "uz", "rx", "ry", "rz")


@dataclass(frozen=True)
class Recovery:
    """Motions (6, coordinates) or stresses (12, coordinates) of a point inside, place (3,)."""

    place: Array
    rows: Array


@dataclass(frozen=True)
class Superelement:
    """Matrices over boundary nodes and modal coordinates.

    matrices: "K", "M" and with damping "C" (viscous), "D" (structural: K + i D), each (n, n) and
    symmetric; node_names and places (nodes, 3) of the boundary; recovery: motions of sensors, six
    rows each; stresses: twelve rows each (xx yy zz xy yz zx below, then above; Pa);
    loads: (n,) per unit amplitude.
    """

    name: str
    units: str
    node_names: tuple[str, ...]
    places: Array
    matrices: dict[str, Array]
    recovery: dict[str, Recovery]
    stresses: dict[str, Recovery]
    loads: dict[str, Array]

    @property
    def K(self) -> Any:
        """Stiffness, scipy.sparse.csc_matrix."""
        return self.sparse("K")

    @property
    def M(self) -> Any:
        """Mass, scipy.sparse.csc_matrix."""
        return self.sparse("M")

    @property
    def C(self) -> Any:
        """Viscous damping; MissingData where there is none."""
        return self.sparse("C")

    @property
    def D(self) -> Any:
        """Structural damping; MissingData where there is none."""
        return self.sparse("D")

    def dense(self, letter: str) -> Array:
        """A matrix as an array."""
        if letter not in self.matrices:
            raise MissingData(f"superelement {self.name}: has no matrix {letter}; "
                              f"{', '.join(self.matrices)}")
        return self.matrices[letter]

    def sparse(self, letter: str) -> Any:
        """A matrix as scipy.sparse.csc_matrix."""
        return need("scipy.sparse", "a sparse matrix").csc_matrix(self.dense(letter))

    @property
    def boundary(self) -> int:
        """Number of boundary coordinates, six a node."""
        return 6 * len(self.node_names)

    @property
    def modal(self) -> int:
        """Number of modal coordinates."""
        return len(self.matrices["K"]) - self.boundary

    @property
    def coordinates(self) -> list[str]:
        """"left.ux", ..., "mode 1", ..."""
        return [f"{node}.{dof}" for node in self.node_names for dof in DOFS] + \
            [f"mode {k + 1}" for k in range(self.modal)]

    @property
    def fixed_frequencies(self) -> Array:
        """Frequencies with the boundary held, Hz, (modal,)."""
        return np.asarray(np.sqrt(np.diag(self.matrices["K"])[self.boundary:]) / (2 * np.pi))

    @property
    def nodes(self) -> Any:
        """DataFrame: name, place and first coordinate of each boundary node."""
        rows = [{"name": name, "x": p[0], "y": p[1], "z": p[2], "coordinate": 6 * k}
                for k, (name, p) in enumerate(zip(self.node_names, self.places))]
        length = self.units.split()[0]
        return frame_of(rows, {axis: length for axis in "xyz"})

    def rigid_motions(self) -> Array:
        """(n, 6): motions of the coordinates under the six rigid ones about the origin."""
        motions = np.zeros((len(self.matrices["K"]), 6))
        for k, (x, y, z) in enumerate(self.places):
            motions[6 * k:6 * k + 6] = np.eye(6)
            motions[6 * k:6 * k + 3, 3:] = [[0, z, -y], [-z, 0, x], [y, -x, 0]]
        return motions
