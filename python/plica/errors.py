"""What can go wrong: every error says what is wrong, where, and what would be right."""
from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Sequence


class PlicaError(Exception):
    """The base of all errors of this package."""


class NoExecutable(PlicaError):
    """The program `plica` was not found, or what was named is no program."""


class VersionError(PlicaError):
    """A program or a file of another version than this package reads."""


class BrokenFolder(PlicaError):
    """A folder of results is not there, or a file in it is missing or damaged."""


class MissingData(PlicaError, KeyError):
    """These results do not have what was asked for."""

    def __str__(self) -> str:  # a KeyError would put it in quotes
        return str(self.args[0]) if self.args else ""


class MissingPackage(PlicaError, ImportError):
    """An optional package is not installed."""


class OptionError(PlicaError, TypeError):
    """A command has no such option, or the option does not take this value."""


@dataclass(frozen=True)
class Problem:
    """One problem of an input file: `line` counts from 1, 0 is the whole file."""

    file: str
    line: int
    key: str
    wrong: str
    allowed: str = ""

    def __str__(self) -> str:
        place = f"{self.file}:{self.line}: " if self.line > 0 else f"{self.file}: "
        text = (place if self.file else "") + (f"{self.key}: " if self.key else "") + self.wrong
        return text + (f"; {self.allowed}" if self.allowed else "")


class CaseError(PlicaError):
    """An input is wrong, or the results cannot be written where they should be.

    `problems`: all that is wrong, each with file, line and key; `text`: what else the program said.
    """

    def __init__(self, problems: Sequence[Problem], text: str = "") -> None:
        self.problems = tuple(problems)
        self.text = text
        super().__init__("\n".join(str(p) for p in self.problems) or text)

    def __reduce__(self) -> tuple[Any, ...]:  # pickled: an exception gives its text alone
        return type(self), (self.problems, self.text), self.__dict__


class NumericalVerdict(PlicaError):
    """A numerical verdict failed (exit code 2). The results were written and are in `folder`."""

    def __init__(self, text: str, folder: Path) -> None:
        self.folder = folder
        super().__init__(text)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (str(self), self.folder), self.__dict__


class ProgramFailed(PlicaError):
    """The program failed within, or was stopped; `code` is its exit code."""

    def __init__(self, text: str, code: int) -> None:
        self.code = code
        super().__init__(text)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (str(self), self.code), self.__dict__


class TooLarge(ProgramFailed):
    """The machine has not the memory for it (exit code 4): how much it is, and what needs less."""
