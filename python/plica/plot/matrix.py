"""Matrices: MAC of two sets of modes, correlation of fitted parameters."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence

import numpy as np
import numpy.typing as npt

from ..errors import MissingData
from .style import look

if TYPE_CHECKING:
    from ..documents import Correlation, Fit

Array = npt.NDArray[Any]


def mac(correlation: Correlation, *, ax: Any = None) -> Any:
    """Simulated modes upwards, measured ones along; numbers from 0 to 1."""
    if correlation.mac.size == 0:
        raise MissingData(f"{correlation.folder.path}: no MAC, the test has no shapes; "
                          "modes[].vector in measured.yaml")
    rows, columns = correlation.mac.shape
    return _draw(correlation.mac, [str(k + 1) for k in range(rows)],
                 [str(k + 1) for k in range(columns)], "Blues", (0, 1), ax,
                 ylabel="simulated mode", xlabel="measured mode", title="MAC")


def correlation(fit: Fit, *, ax: Any = None) -> Any:
    """Fitted parameters against each other, -1 to 1; those near 1 cannot be told apart."""
    names = [p["path"] for p in fit.data["parameters"]]
    if fit.correlation.size == 0:
        raise MissingData(f"{fit.folder.path}: no correlation; the fit has no covariance")
    axes = _draw(fit.correlation, names, names, "RdBu_r", (-1, 1), ax,
                 title="correlation of the parameters")
    axes.tick_params(axis="x", labelrotation=30)
    return axes


def _draw(values: Array, rows: Sequence[str], columns: Sequence[str], colours: str,
          limits: tuple[float, float], ax: Any, **words: str) -> Any:
    longest = 0.075 * max(map(len, rows))
    size = (max(3.6, longest + 1.2 + 0.45 * len(columns)), max(2.8, 1.6 + 0.42 * len(rows)))
    with look(ax, figsize=size) as axes:
        axes.imshow(values, cmap=colours, vmin=limits[0], vmax=limits[1], origin="lower")
        middle = 0.6 * max(abs(limits[0]), limits[1])
        for (i, j), value in np.ndenumerate(values):
            axes.text(j, i, f"{value:.2f}", ha="center", va="center", fontsize=7,
                      color="white" if abs(value) > middle else "#1b2127")
        axes.set_xticks(range(len(columns)), columns)
        axes.set_yticks(range(len(rows)), rows)
        axes.grid(False)
        axes.set(**words)
    return axes
