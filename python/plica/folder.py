"""A folder of results: files by name, read when asked for, once, their versions checked."""
from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Callable, TypeVar

from . import version
from .errors import BrokenFolder, MissingData
from .head import head_of
from .tables import Table, read_csv
from .written import LIST, check_written, written

Read = TypeVar("Read")
COMMANDS = {
    "results.json": "plica run", "certificate.json": "plica reduce",
    "superelement.json": "plica reduce", "identification.json": "plica identify",
    "correlation.json": "plica compare", "fit.json": "plica fit",
    "diagnosis.json": "plica diagnose", "pretest.json": "plica diagnose --pretest",
    "supposed.json": "plica diagnose --suppose", "levels.json": "plica identify",
    "benchmark.json": "plica run", "sweep.json": "plica sweep", "ejma.json": "plica ejma",
    "stiffness.csv": "plica stiffness", "stiffness.h5": "plica stiffness",
    "transfer_stiffness.csv": "plica stiffness", "beam.csv": "plica reduce --beam",
}


class Folder:
    """`path` as a folder of results. BrokenFolder where it is none."""

    def __init__(self, path: str | Path) -> None:
        self.path = Path(path)
        if not self.path.exists():
            raise BrokenFolder(f"{self.path}: is not there; a folder that plica has written")
        if not self.path.is_dir():
            raise BrokenFolder(f"{self.path}: is a file; the folder of results it lies in")
        if not any((self.path / name).is_file() for name in (*COMMANDS, LIST)):
            raise BrokenFolder(f"{self.path}: has no results; one of {', '.join(COMMANDS)}")
        self._documents: dict[str, Any] = {}
        self._tables: dict[str, Table] = {}

    def has(self, name: str) -> bool:
        """Is there a file of this name?"""
        return (self.path / name).is_file()

    def lists(self, name: str) -> bool:
        """Is it there, or was it written there?"""
        return self.has(name) or name in written(self.path)

    def require(self, name: str) -> Path:
        """The path of a file; MissingData says which command writes it, VersionError where it is
        of another version, BrokenFolder where it was written and is gone or cut."""
        path, entry = self._listed(name)
        check_written(path)
        if entry:
            _check_version(entry.get("plica_version") or None, path)
        return path

    def read(self, name: str, reader: Callable[[Path], Read]) -> Read:
        """What `reader` makes of a file; errors as of `require`."""
        return reader(self.require(name))

    def _listed(self, name: str) -> tuple[Path, dict[str, Any]]:
        entry = written(self.path).get(name, {})
        if not self.has(name):
            if entry:
                raise BrokenFolder(f"{self.path / name}: is missing, plica wrote it here "
                                   f"(`plica {entry.get('command', 'run')}`); run the command anew")
            by = COMMANDS.get(name)
            have = ", ".join(sorted(p.name for p in self.path.iterdir() if p.is_file()))
            raise MissingData(f"{self.path}: has no {name}; "
                              + (f"`{by} --out {self.path}` writes it" if by else f"it has {have}"))
        return self.path / name, entry

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
            _check_version(data.get("plica_version"), path)
            self._documents[name] = data
        return dict(self._documents[name])

    def head(self, name: str, keys: set[str]) -> dict[str, Any]:
        """These keys of a JSON file, which is read as far as the last of them; what is behind is
        not looked at. Errors as of `document`."""
        if name in self._documents:
            return {k: v for k, v in self._documents[name].items() if k in keys}
        path = self.path / name  # of results.json, which says its version itself
        try:
            data = head_of(path, keys)
        except FileNotFoundError:
            data = {}
            self.require(name)
        except (OSError, ValueError) as error:
            raise BrokenFolder(f"{path}: is damaged: {error}; run the command anew") from error
        _check_version(data.get("plica_version"), path)
        return data

    def table(self, name: str) -> Table:
        """A CSV table by name, with or without `.csv`."""
        name = name if name.endswith(".csv") else name + ".csv"
        if name not in self._tables:
            path, entry = self._listed(name)
            _check_version(entry.get("plica_version") or None, path)
            self._tables[name] = read_csv(path)  # which looks whether it is whole
        return self._tables[name]

    def tables(self) -> list[str]:
        """Names of all CSV tables, without `.csv`."""
        return sorted(p.stem for p in self.path.glob("*.csv"))


def _check_version(said: Any, path: Path) -> None:
    if said is not None and not isinstance(said, str):
        raise BrokenFolder(f"{path}: is damaged: its plica_version is {said!r}, no text such as "
                           f"'{version.__version__}'; run the command anew")
    version.check(said, str(path))
