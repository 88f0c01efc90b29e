"""Results of one run: BrokenFolder for what is read after another run was written to its folder."""
from __future__ import annotations

from pathlib import Path
from typing import Any, Callable

from .errors import BrokenFolder
from .folder import Folder, Read
from .messages import Said
from .results import Results
from .tables import Table
from .written import written


class OneRun(Folder):
    """A folder as it was when a run had written there, by what the run said.

    None of its own files may be another one since, and of those of other commands none that is
    read: looked at before and after, as another run may begin to write between. What was read
    before stays.
    """

    def __init__(self, folder: Folder, said: Said) -> None:
        super().__init__(folder.path)
        self._own, self._others = dict(said.own), dict(said.others)
        self._check("")

    def _check(self, name: str) -> None:
        now = written(self.path)
        for known, mark in self._own.items():
            self._same(known, mark, now)
        if name in self._others:
            self._same(name, self._others[name], now)

    def _same(self, name: str, mark: str, now: dict[str, Any]) -> None:
        if now.get(name, {}).get("prints") != [mark]:  # two while another takes its place
            raise BrokenFolder(f"{self.path}: another run has been written there since, or it was "
                               "removed; give each run an `out` of its own")

    def has(self, name: str) -> bool:  # every file goes through it before it is read
        self._check(name)
        return super().has(name)

    def read(self, name: str, reader: Callable[[Path], Read]) -> Read:
        return self._checked(name, lambda: super(OneRun, self).read(name, reader))

    def document(self, name: str) -> dict[str, Any]:
        known = name in self._documents
        return super().document(name) if known else \
            self._checked(name, lambda: super(OneRun, self).document(name))

    def table(self, name: str) -> Table:
        name = name if name.endswith(".csv") else name + ".csv"
        known = name in self._tables
        return super().table(name) if known else \
            self._checked(name, lambda: super(OneRun, self).table(name))

    def head(self, name: str, keys: set[str]) -> dict[str, Any]:
        return self._checked(name, lambda: super(OneRun, self).head(name, keys))

    def _checked(self, name: str, read: Callable[[], Read]) -> Read:
        """Errors of a file that another run is about to replace are not those of this one."""
        self._check(name)
        try:
            found = read()
        finally:
            try:
                self._check(name)
            except BrokenFolder:
                self._documents.pop(name, None)
                self._tables.pop(name, None)
                raise
        return found


def of_one_run(results: Results, said: Said) -> Results:
    """The same results, of the run that said so alone."""
    results.folder = OneRun(results.folder, said)
    return results
