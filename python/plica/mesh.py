"""A mesh with fields as plain arrays, and as meshio and pyvista meshes where these are present."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from .optional import need

Array = npt.NDArray[Any]
LINE, TRIANGLE, QUAD = 3, 5, 9  # VTK's numbers of cell types
NAMES = {LINE: "line", TRIANGLE: "triangle", QUAD: "quad"}


@dataclass(frozen=True)
class Mesh:
    """Nodes and cells as VTK lays them out; lengths in m, in the frame of the part.

    points (nodes, 3); connectivity (all corners of all cells, one after another);
    offsets (cells,): where each cell ends in it; types (cells,): LINE, TRIANGLE, QUAD;
    point_data, cell_data: fields by name, (nodes,), (nodes, 3) or (cells,).
    """

    points: Array
    connectivity: Array
    offsets: Array
    types: Array
    point_data: dict[str, Array]
    cell_data: dict[str, Array]

    def cells(self, kind: int) -> Array:
        """Corners of all cells of a kind, (cells, corners), nodes from 0."""
        width = {LINE: 2, TRIANGLE: 3, QUAD: 4}[kind]
        ends = self.offsets[self.types == kind]
        return np.asarray(self.connectivity[ends[:, None] - width + np.arange(width)])

    @property
    def quads(self) -> Array:
        """(cells, 4)"""
        return self.cells(QUAD)

    @property
    def triangles(self) -> Array:
        """(cells, 3)"""
        return self.cells(TRIANGLE)

    @property
    def lines(self) -> Array:
        """(cells, 2), beams"""
        return self.cells(LINE)

    def with_points(self, points: Array) -> Mesh:
        """The same mesh, its nodes elsewhere: a deformed shape."""
        return Mesh(points, self.connectivity, self.offsets, self.types, self.point_data,
                    self.cell_data)

    def meshio(self) -> Any:
        """As meshio.Mesh with all fields."""
        kinds = [kind for kind in (LINE, TRIANGLE, QUAD) if np.any(self.types == kind)]
        cell_data = {name: [values[self.types == kind] for kind in kinds]
                     for name, values in self.cell_data.items()}
        return need("meshio", "a meshio mesh").Mesh(
            self.points, [(NAMES[kind], self.cells(kind)) for kind in kinds],
            point_data=dict(self.point_data), cell_data=cell_data)

    def pyvista(self) -> Any:
        """As pyvista.UnstructuredGrid with all fields."""
        pyvista = need("pyvista", "a pyvista mesh")
        grid = pyvista.UnstructuredGrid(self.padded_cells(), self.types.astype(np.uint8),
                                        np.asarray(self.points, dtype=float))
        for name, values in self.point_data.items():
            grid.point_data[name] = values
        for name, values in self.cell_data.items():
            grid.cell_data[name] = values
        return grid

    def padded_cells(self) -> Array:
        """VTK's older list of cells, each led by its number of corners: (4, a, b, c, d, 2, ...)."""
        widths = np.diff(self.offsets, prepend=0)
        starts = self.offsets - widths
        return np.insert(np.asarray(self.connectivity, dtype=np.int64), starts, widths)
