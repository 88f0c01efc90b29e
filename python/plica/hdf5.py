"""HDF5 files of the program: each says its format and the version of its layout."""
from __future__ import annotations

from contextlib import contextmanager
from pathlib import Path
from typing import Any, Iterator

from .errors import VersionError
from .optional import need


def text(value: Any) -> str:
    """A text as HDF5 has it, bytes or not, up to its end."""
    return (value.decode() if isinstance(value, bytes) else str(value)).split("\0")[0]


@contextmanager
def opened(path: Path, form: str, layout: int, anew: str) -> Iterator[Any]:
    """The file to read. ValueError where it has another format, VersionError where another layout,
    OSError or KeyError where it is damaged. `anew`: what writes it again."""
    with need("h5py", path.name).File(path, "r") as file:
        if text(file.attrs["format"]) != form:
            raise ValueError("it has another format")
        if int(file.attrs["version"]) != layout:
            raise VersionError(f"{path}: has layout {int(file.attrs['version'])}, this package "
                               f"reads {layout}; {anew}")
        yield file
