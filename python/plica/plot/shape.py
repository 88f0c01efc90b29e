"""Shapes of modes: the deformed part seen from a corner, and in motion.

Drawn by projection and painter's order in two dimensions: ten thousands of quads take a second.
"""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ..errors import MissingData
from ..optional import need
from .style import INK, look

if TYPE_CHECKING:
    from ..results import Results

Array = npt.NDArray[Any]
LIGHT = np.array([0.3, -0.5, 0.8])


class Scene:
    """The cells of a mesh, projected: right, up and towards the eye are the rows of `view`."""

    def __init__(self, results: Results, mode: int, scale: float, azimuth: float,
                 elevation: float) -> None:
        self.mesh, shapes = results.mesh, results.shapes
        if not 1 <= mode <= len(shapes):
            raise MissingData(f"{results.path}: has no mode {mode}; 1 to {len(shapes)}")
        self.shape = shapes[mode - 1]
        largest = np.linalg.norm(self.shape, axis=1).max()
        size = np.ptp(self.mesh.points, axis=0).max()
        self.factor = scale * size / largest if largest > 0 else 0.0
        self.motion = np.linalg.norm(self.shape, axis=1) / (largest or 1.0)
        a, e = np.radians(azimuth), np.radians(elevation)
        eye = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
        right = np.array([-np.sin(a), np.cos(a), 0.0])
        self.view = np.stack([right, np.cross(eye, right), eye])

    def points(self, amount: float) -> Array:
        """Nodes (nodes, 3) in the frame of the eye, deformed by a share of the amplitude."""
        moved = self.mesh.points + amount * self.factor * self.shape
        return np.asarray(moved @ self.view.T)

    def faces(self, amount: float) -> tuple[list[Array], Array, Array]:
        """Corners (k, 2) from back to front, motion 0 to 1 and light 0.45 to 1 of each."""
        points = self.points(amount)
        corners, motions, lights = [], [], []
        for cells in (self.mesh.quads, self.mesh.triangles):
            if len(cells) == 0:
                continue
            at = points[cells]
            normal = np.cross(at[:, 2] - at[:, 0], at[:, -1] - at[:, 1])
            length = np.linalg.norm(normal, axis=1)
            light = np.abs(normal @ LIGHT) / np.where(length > 0, length, 1)
            corners.append(at)
            motions.append(self.motion[cells].mean(axis=1))
            lights.append(0.45 + 0.55 * light / np.linalg.norm(LIGHT))
        if not corners:
            return [], np.zeros(0), np.zeros(0)
        depth = np.concatenate([at[:, :, 2].mean(axis=1) for at in corners])
        order = np.argsort(depth)
        flat = [face[:, :2] for at in corners for face in at]
        return ([flat[k] for k in order], np.concatenate(motions)[order],
                np.concatenate(lights)[order])

    def beams(self, amount: float) -> Array:
        """Ends (beams, 2, 2)."""
        return self.points(amount)[self.mesh.lines][:, :, :2]

    def paint(self, axes: Any, amount: float) -> list[Any]:
        """Draws the shape; the artists."""
        collections = need("matplotlib.collections", "a plot of a shape")
        viridis = need("matplotlib", "a plot of a shape").colormaps["viridis"]
        faces, motions, lights = self.faces(amount)
        colours = viridis(motions)
        colours[:, :3] *= lights[:, None]
        artists = []
        if faces:
            artists.append(axes.add_collection(collections.PolyCollection(
                faces, facecolors=colours, edgecolors=colours, linewidths=0.3)))
        beams = self.beams(amount)
        if len(beams):
            motion = self.motion[self.mesh.lines].mean(axis=1)
            for ghost, ends in ((True, self.beams(0.0)), (False, beams)):
                artists.append(axes.add_collection(collections.LineCollection(
                    ends, colors="#a3adb6" if ghost else viridis(motion),
                    linewidths=1 if ghost else 3, linestyles="--" if ghost else "-")))
        return artists

    def frame(self, axes: Any) -> None:
        """Limits that hold every amplitude, equal scales, no ticks."""
        all_points = np.concatenate([self.points(s)[:, :2] for s in (-1.0, 0.0, 1.0)])
        low, high = all_points.min(axis=0), all_points.max(axis=0)
        edge = 0.05 * max(high - low)
        axes.set(xlim=(low[0] - edge, high[0] + edge), ylim=(low[1] - edge, high[1] + edge))
        axes.set_aspect("equal")
        axes.axis("off")


def draw(results: Results, mode: int = 1, *, scale: float = 0.1, azimuth: float = 35,
         elevation: float = 25, ax: Any = None) -> Any:
    """A mode at its largest motion, which is drawn as `scale` of the size of the part.

    azimuth, elevation: of the eye about z and above the horizon, degrees.
    """
    scene = Scene(results, mode, scale, azimuth, elevation)
    with look(ax, figsize=(6, 4)) as axes:
        scene.paint(axes, 1.0)
        scene.frame(axes)
        axes.set_title(_title(results, mode), color=INK)
    return axes


def animate(results: Results, mode: int = 1, *, frames: int = 24, seconds: float = 1.2,
            scale: float = 0.1, azimuth: float = 35, elevation: float = 25) -> Any:
    """One period of a mode as matplotlib.animation.FuncAnimation: `.to_jshtml()`, `.save(...)`."""
    animation = need("matplotlib.animation", "an animation")
    scene = Scene(results, mode, scale, azimuth, elevation)
    with look(None, figsize=(6, 4)) as axes:
        scene.frame(axes)
        axes.set_title(_title(results, mode), color=INK)
        drawn: list[Any] = []

        def show(k: int) -> list[Any]:
            for artist in drawn:
                artist.remove()
            drawn[:] = scene.paint(axes, float(np.sin(2 * np.pi * k / frames)))
            return drawn
        return animation.FuncAnimation(axes.figure, show, frames=frames,
                                       interval=1000 * seconds / frames)


def _title(results: Results, mode: int) -> str:
    row = results.data["modes"][mode - 1]
    return f"mode {mode}: {row['label']}, {row['frequency']:.1f} Hz"
