"""CSV tables as the program writes them: a line of headers with units, numbers, empty cells.

A header is `name [unit]`. The unit moves to `Table.units` (and `DataFrame.attrs["units"]`) unless
two columns would then have one name; those keep their headers whole. Numbers are in SI.
"""
from __future__ import annotations

import csv
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Iterator

import numpy as np
import numpy.typing as npt

from .errors import BrokenFolder
from .optional import need
from .written import check_written

Array = npt.NDArray[Any]


@dataclass(frozen=True)
class Table:
    """Columns by name, each (rows,): float64, or object where it holds texts. Needs no pandas."""

    columns: dict[str, Array]
    units: dict[str, str] = field(default_factory=dict)
    path: Path | None = None

    def __getitem__(self, name: str) -> Array:
        return self.columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return next((len(column) for column in self.columns.values()), 0)

    def frame(self) -> Any:
        """As pandas.DataFrame with `attrs["units"]` and `attrs["file"]`."""
        frame = need("pandas", "a DataFrame").DataFrame(dict(self.columns))
        frame.attrs["units"] = dict(self.units)
        if self.path is not None:
            frame.attrs["file"] = str(self.path)
        return frame


def named(headers: list[str]) -> tuple[list[str], dict[str, str]]:
    """Names and units of headers: ["f [Hz]", "set"] gives ["f", "set"] and {"f": "Hz"}."""
    split = [re.fullmatch(r"(.*\S) \[([^\[\]]+)\]", header) for header in headers]
    short = [m.group(1) if m else header for m, header in zip(split, headers)]
    names, units = [], {}
    for m, header, name in zip(split, headers, short):
        kept = name if short.count(name) == 1 else header
        names.append(kept)
        if m:
            units[kept] = m.group(2)
    return names, units


def read_csv(path: str | Path) -> Table:
    """A CSV table of the program; BrokenFolder where it is not there or a line is cut, or, in a
    folder of results, the file is."""
    path = Path(path)
    check_written(path)
    try:
        text = path.read_text(encoding="utf-8")
    except OSError as error:
        raise BrokenFolder(f"{path}: cannot be read: {error.strerror}; a CSV table of plica") \
            from error
    except UnicodeDecodeError as error:
        raise BrokenFolder(f"{path}: is damaged: {error}; a CSV table in UTF-8") from error
    lines = text.splitlines()
    if not lines:
        raise BrokenFolder(f"{path}: is empty; a line of headers")
    names, units = named(next(csv.reader(lines[:1])))
    plain = _plain_numbers(lines[1:], len(names))
    if plain is not None:
        return Table({n: plain[:, i] for i, n in enumerate(names)}, units, path)
    rows = list(csv.reader(lines[1:]))
    for number, row in enumerate(rows, start=2):
        if len(row) != len(names):
            raise BrokenFolder(f"{path}:{number}: has {len(row)} cells; {len(names)}, as the "
                               "headers")
    return Table({n: _column([row[i] for row in rows]) for i, n in enumerate(names)}, units, path)


def _plain_numbers(lines: list[str], width: int) -> Array | None:
    """Rows x columns where every cell is a number, the fast way; None where not."""
    if not lines:
        return None
    try:
        values = np.array(",".join(lines).split(","), dtype=float)
    except ValueError:
        return None
    return values.reshape(len(lines), width) if values.size == len(lines) * width else None


def _column(cells: list[str]) -> Array:
    """Numbers where all cells are numbers or empty (NaN), else texts."""
    try:
        return np.array([float(cell) if cell else np.nan for cell in cells])
    except ValueError:
        return np.array([re.sub(r"^'(?=[=+\-@\t\r])", "", cell) for cell in cells], dtype=object)
