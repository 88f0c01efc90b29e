"""VTU files as the program writes them: an unstructured grid, appended raw, zlib blocks or plain.

Layout after VTK's description of its XML formats: the appended data begin behind the underscore;
an array is (blocks, size, last size, compressed sizes...) and then its blocks, or with no
compressor (bytes) and then the array.
"""
from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
import zlib
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .errors import BrokenFolder
from .mesh import Mesh

Array = npt.NDArray[Any]
TYPES = {"Float64": "f8", "Float32": "f4", "Int64": "i8", "Int32": "i4", "UInt8": "u1",
         "UInt64": "u8", "UInt32": "u4", "Int8": "i1"}


def read_vtu(path: str | Path) -> Mesh:
    """The mesh with its fields; BrokenFolder where the file is cut or of another kind."""
    path = Path(path)
    try:
        return _Reader(path.read_bytes()).mesh()
    except (OSError, ValueError, KeyError, IndexError, zlib.error,
            ElementTree.ParseError) as error:
        raise BrokenFolder(f"{path}: is damaged or no VTU of plica: {error}; "
                           "run the command anew") from error


class _Reader:
    def __init__(self, data: bytes) -> None:
        start = data.index(b"<AppendedData")
        self.data = data[data.index(b"_", start) + 1:]
        self.root = ElementTree.fromstring(data[:start].decode("utf-8") + "</VTKFile>")
        self.order = "<" if self.root.get("byte_order", "LittleEndian") == "LittleEndian" else ">"
        self.header = self.order + TYPES[self.root.get("header_type", "UInt32")]
        self.compressed = self.root.get("compressor") is not None

    def mesh(self) -> Mesh:
        def of(place: str) -> dict[str, Array]:
            found = self.root.find(f".//{place}")
            return {} if found is None else {a.get("Name", place): self.array(a) for a in found}
        cells = of("Cells")
        points = next(iter(of("Points").values()))
        return Mesh(points, cells["connectivity"], cells["offsets"], cells["types"],
                    of("PointData"), of("CellData"))

    def array(self, element: ElementTree.Element) -> Array:
        if element.get("format") != "appended":
            raise ValueError(f"array {element.get('Name')} is not appended")
        raw = self.bytes_at(int(element.get("offset", "0")))
        values = np.frombuffer(raw, self.order + TYPES[element.get("type", "")])
        width = int(element.get("NumberOfComponents", "1"))
        return values.reshape(-1, width) if width > 1 else values

    def bytes_at(self, offset: int) -> bytes:
        size = np.dtype(self.header).itemsize
        first = int(np.frombuffer(self.data, self.header, 1, offset)[0])
        if not self.compressed:
            return self.data[offset + size:offset + size + first]
        if first == 0:
            return b""
        sizes = np.frombuffer(self.data, self.header, first, offset + 3 * size)
        at = offset + (3 + first) * size
        blocks = []
        for length in (int(s) for s in sizes):
            blocks.append(zlib.decompress(self.data[at:at + length]))
            at += length
        return b"".join(blocks)


def mode_of(name: str) -> tuple[int, float] | None:
    """Number and frequency [Hz] of a field "mode 01: 112.3 Hz"; None of another field."""
    found = re.fullmatch(r"mode (\d+): ([-+.\deE]+) Hz", name)
    return (int(found.group(1)), float(found.group(2))) if found else None
