"""A folder of results: files by name, read when asked for, once, their versions checked."""
from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from . import version
from .errors import BrokenFolder, MissingData
from .tables import Table, read_csv

COMMANDS = {
    "results.json": "plica run", "certificate.json": "plica reduce",
    "superelement.json": "plica reduce", "identification.json": "plica identify",
    "correlation.json": "plica compare", "fit.json": "plica fit",
    "diagnosis.json": "plica diagnose", "pretest.json": "plica diagnose --pretest",
    "supposed.json": "plica diagnose --suppose", "levels.json": "plica identify",
    "benchmark.json": "plica run",
}


class Folder:
    """`path` as a folder of results. BrokenFolder where it is none."""

    def __init__(self, path: str | Path) -> None:
        self.path = Path(path)
        if not self.path.exists():
            raise BrokenFolder(f"{self.path}: is not there; a folder that plica has written")
        if not self.path.is_dir():
            raise BrokenFolder(f"{self.path}: is a file; the folder of results it lies in")
        if not any((self.path / name).is_file() for name in COMMANDS):
            raise BrokenFolder(f"{self.path}: has no results; one of {', '.join(COMMANDS)}")
        self._documents: dict[str, Any] = {}
        self._tables: dict[str, Table] = {}

    def has(self, name: str) -> bool:
        """Is there a file of this name?"""
        return (self.path / name).is_file()

    def require(self, name: str) -> Path:
        """The path of a file; MissingData says which command writes it."""
        if not self.has(name):
            by = COMMANDS.get(name)
            have = ", ".join(sorted(p.name for p in self.path.iterdir() if p.is_file()))
            raise MissingData(f"{self.path}: has no {name}; "
                              + (f"`{by} --out {self.path}` writes it" if by else f"it has {have}"))
        return self.path / name

    def document(self, name: str) -> dict[str, Any]:
        """A JSON file; BrokenFolder where it is damaged, VersionError where of another version."""
        if name not in self._documents:
            path = self.require(name)
            try:
                data = json.loads(path.read_text(encoding="utf-8"))
            except (OSError, ValueError) as error:
                raise BrokenFolder(f"{path}: is damaged: {error}; run the command anew") from error
            if not isinstance(data, dict):
                raise BrokenFolder(f"{path}: holds no object; run the command anew")
            version.check(data.get("plica_version"), str(path))
            self._documents[name] = data
        return dict(self._documents[name])

    def table(self, name: str) -> Table:
        """A CSV table by name, with or without `.csv`."""
        name = name if name.endswith(".csv") else name + ".csv"
        if name not in self._tables:
            self._tables[name] = read_csv(self.require(name))
        return self._tables[name]

    def tables(self) -> list[str]:
        """Names of all CSV tables, without `.csv`."""
        return sorted(p.stem for p in self.path.glob("*.csv"))
