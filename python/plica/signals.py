"""Time signals of a test."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Mapping

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[Any]


@dataclass(frozen=True)
class Signals:
    """Time signals of one recording, equally spaced.

    rate in Hz; data (samples, channels); channels such as "base.y", "mid.y"; units of each, SI
    where empty; entry: further keys of `signals[]`: base, reference, force, excitation, level.
    """

    rate: float
    data: Array
    channels: tuple[str, ...]
    units: tuple[str, ...] = ()
    entry: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if np.ndim(self.data) != 2 or np.shape(self.data)[1] != len(self.channels):
            raise ValueError(f"data have the shape {np.shape(self.data)}; (samples, "
                             f"{len(self.channels)}): one column a channel")
