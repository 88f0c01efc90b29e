"""Frequency responses: what runs compute, labs measure and other packages exchange."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Sequence

import numpy as np
import numpy.typing as npt

from .errors import BrokenFolder, MissingData
from .optional import need
from .tables import Table

Array = npt.NDArray[Any]
AXES = ("x", "y", "z", "rx", "ry", "rz")


def axis_of(channel: str) -> tuple[str, str]:
    """("mid", "y") of "mid.y" or "mid y"; the axis is "" where none is named."""
    for mark in (".", " "):
        name, found, axis = channel.rpartition(mark)
        if found and axis in AXES:
            return name, axis
    return channel, ""


@dataclass(frozen=True)
class Frf:
    """H[k, i, j]: response of `outputs[i]` to `inputs[j]` at `frequency[k]`, e^{+i w t}.

    frequency (n,) in Hz, rising; H (n, outputs, inputs) complex; `unit` of H, such as
    "m/s2 per m/s2" (transmissibility) or "m/s2 per N" (accelerance). Channels are "mid.y".
    """

    frequency: Array
    H: Array
    outputs: tuple[str, ...]
    inputs: tuple[str, ...]
    unit: str = ""
    level: float | None = None
    attrs: dict[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        shape = (len(self.frequency), len(self.outputs), len(self.inputs))
        if np.shape(self.H) != shape:
            raise ValueError(f"H has the shape {np.shape(self.H)}; {shape}: lines, outputs, inputs")
        if len(self.frequency) > 1 and np.any(np.diff(self.frequency) <= 0):
            raise ValueError("frequencies do not rise; each line once, from the lowest")

    def channel(self, output: str, input: str | None = None) -> Array:
        """H of one channel, (n,); the only input unless one is named."""
        return self.H[:, place(output, self.outputs), place(input, self.inputs)]

    def by_input(self, input: str) -> Array:
        """H of all outputs by one input, (n, outputs, 1)."""
        return self.H[:, :, [place(input, self.inputs)]]

    def dataarray(self) -> Any:
        """As xarray.DataArray (frequency, output, input) with attrs units and level."""
        attrs = {"units": self.unit, "level": self.level, **self.attrs}
        array = need("xarray", "a DataArray").DataArray(
            self.H, dims=("frequency", "output", "input"),
            coords={"frequency": self.frequency, "output": list(self.outputs),
                    "input": list(self.inputs)},
            attrs={k: v for k, v in attrs.items() if v is not None}, name="H")
        array.frequency.attrs["units"] = "Hz"
        return array


def place(channel: str | None, channels: Sequence[str]) -> int:
    """The number of a channel; "mid y" is "mid.y". None is the only one."""
    if channel is None:
        if len(channels) != 1:
            raise MissingData(f"there are {len(channels)} inputs; name one: {', '.join(channels)}")
        return 0
    wanted = axis_of(channel)
    for i, known in enumerate(channels):
        if axis_of(known) == wanted:
            return i
    raise MissingData(f"there is no channel '{channel}'; {', '.join(channels)}")


def of_table(table: Table, driven: str, unit: str, level: float | None, right: str = "") -> Frf:
    """Of a table of frequency [Hz], then real and imaginary part of each channel, in `unit` where
    its headers have none; BrokenFolder where it is none, which says what is `right`, too."""
    names = [name[:-len(" real")] for name in table if name.endswith(" real")]
    if not names or any(name + " imaginary" not in table.columns for name in names):
        raise BrokenFolder(f"{table.path}: has the columns {', '.join(table)}; frequency [Hz], "
                           f"then `mid y real`, `mid y imaginary`{right}")
    try:
        H = np.stack([table[name + " real"] + 1j * table[name + " imaginary"] for name in names],
                     axis=1)
        return Frf(table[next(iter(table))], H[:, :, None],
                   tuple(".".join(axis_of(name)).rstrip(".") for name in names), (driven,),
                   table.units.get(names[0] + " real", unit), level)
    except (TypeError, ValueError) as error:  # texts among the numbers, frequencies that fall
        raise BrokenFolder(f"{table.path}: {error}; numbers, frequencies that rise{right}") \
            from error


def stack(parts: Sequence[Frf]) -> Frf:
    """Several inputs side by side: same lines and outputs. ValueError where they differ."""
    first = parts[0]
    for part in parts[1:]:
        if part.outputs != first.outputs or part.unit != first.unit:
            raise ValueError(f"{part.inputs}: has other outputs or units than {first.inputs}")
        if not np.array_equal(part.frequency, first.frequency):
            raise ValueError(f"{part.inputs}: has other frequencies than {first.inputs}")
    return Frf(first.frequency, np.concatenate([part.H for part in parts], axis=2), first.outputs,
               tuple(name for part in parts for name in part.inputs), first.unit, first.level)
