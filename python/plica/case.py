"""A case file that is read, changed and run: comments, order, line ends and byte order mark of the
file stay as they are."""
from __future__ import annotations

import hashlib
import os
import re
import tempfile
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Iterator, Mapping

from . import commands, yaml_edit, yaml_text
from .errors import CaseError, Problem
from .results import Results
from .signatures import takes_options

BOM = "\ufeff"  # which editors on Windows write; not in `text`, whose letters YAML counts from 0
FILE_KEYS = ("measured", "file")  # keys whose text is a file, relative to the case


class Case:
    """`case["parts.bellows.profile[1].height"] = "8.5 mm"`; nothing is written until `save`.

    A folder stands for the file in it that has its name, as on the command line. CaseError where
    the file cannot be read, on the first look into it where it is no YAML; OptionError where a
    path is none.
    """

    def __init__(self, path: str | Path) -> None:
        path = Path(path)
        self.path = path / (path.resolve().name + ".yaml") if path.is_dir() else path
        try:
            text = self.path.read_bytes().decode("utf-8")
        except (OSError, UnicodeDecodeError) as error:
            raise CaseError([Problem(str(self.path), 0, "", f"cannot be read: {error}",
                                     "a case file (plica init my_pipe.yaml writes one)")]) \
                from error
        self.bom = BOM if text.startswith(BOM) else ""
        self.text = self.original = text[len(self.bom):]

    def __repr__(self) -> str:
        return f"<case {self.path}{', changed' if self.changed else ''}>"

    @property
    def changed(self) -> bool:
        """Was something set since the file was read?"""
        return self.text != self.original

    def __getitem__(self, path: str) -> Any:
        """What the file says at a path, units as written; MissingData where it says nothing."""
        with self._at_fault():
            return yaml_text.value_at(self.text, path)

    def __setitem__(self, path: str, value: Any) -> None:
        """A value with its unit as text ("8.5 mm"), a number in SI, a Path of a file beside the
        case; None takes the key out."""
        with self._at_fault():
            self.text = yaml_edit.removed(self.text, path) if value is None \
                else yaml_edit.replaced(self.text, path, value)

    def __delitem__(self, path: str) -> None:
        self[path] = None

    def __contains__(self, path: object) -> bool:
        with self._at_fault():
            return isinstance(path, str) and yaml_text.find(self.text, path)[1] is not None

    @contextmanager
    def _at_fault(self) -> Iterator[None]:
        """What is wrong in the text as what is wrong in the file."""
        try:
            yield
        except yaml_text.BrokenText as error:
            raise CaseError([Problem(str(self.path), error.line, "", error.wrong, error.allowed)]) \
                from error

    def update(self, values: Mapping[str, Any]) -> Case:
        """Sets several values; gives the case back."""
        for path, value in values.items():
            self[path] = value
        return self

    def copy(self) -> Case:
        """The case as it is now; what is changed in one does not change the other."""
        other = object.__new__(Case)
        other.path, other.bom = self.path, self.bom
        other.original, other.text = self.original, self.text
        return other

    def save(self, path: str | Path) -> Path:
        """Writes the case as it is now; files that it names are to lie beside the new file, too."""
        path = Path(path)
        path.write_bytes((self.bom + self.text).encode())
        return path

    @property
    def digest(self) -> str:
        """A name of what the case says now: twelve hexadecimal digits."""
        return hashlib.sha256(self.text.encode()).hexdigest()[:12]

    @contextmanager
    def file(self) -> Iterator[Path]:
        """A file with the case as it is now: the file itself, or one that goes again."""
        if not self.changed:
            yield self.path
            return
        with tempfile.TemporaryDirectory(prefix="plica-") as folder:
            path = Path(folder) / self.path.name
            path.write_bytes((self.bom + self._elsewhere()).encode())
            try:
                yield path
            except CaseError as error:
                raise CaseError([Problem(*_renamed(p, path, self.path)) for p in error.problems],
                                error.text.replace(str(path), str(self.path))) from None

    def _elsewhere(self) -> str:
        """The text with the files that it names as absolute paths; its lines stay."""
        def absolute(found: re.Match[str]) -> str:
            name = found.group(2).strip("'\"")
            beside = (self.path.parent / name).resolve()
            return f'{found.group(1)}"{beside}"' if beside.exists() and not os.path.isabs(name) \
                else found.group(0)
        return re.sub(rf"""(\b(?:{'|'.join(FILE_KEYS)}):\s+)("[^"]*"|'[^']*'|[^\s,}}]+)""",
                      absolute, self.text)

    @takes_options("run")
    def run(self, out: str | Path | None = None, **options: Any) -> Results:
        """`plica run`; see plica.run."""
        return commands.run(self, out, **options)

    @takes_options("check")
    def check(self, **options: Any) -> commands.Check:
        """`plica check`; see plica.check."""
        return commands.check(self, **options)

    @takes_options("reduce")
    def reduce(self, out: str | Path | None = None, **options: Any) -> Results:
        """`plica reduce`; see plica.reduce."""
        return commands.reduce(self, out, **options)

    def write_deck(self, out: str | Path, solver: str, **options: Any) -> Path:
        """`plica run --write-deck`; see plica.write_deck."""
        return commands.write_deck(self, out, solver, **options)

    @takes_options("fit")
    def fit(self, out: str | Path | None = None, **options: Any) -> Results:
        """`plica fit`; see plica.fit."""
        return commands.fit(self, out, **options)

    @takes_options("ejma")
    def ejma(self, out: str | Path | None = None, **options: Any) -> Results:
        """`plica ejma`; see plica.ejma."""
        return commands.ejma(self, out, **options)

    @takes_options("stiffness")
    def stiffness(self, out: str | Path | None = None, **options: Any) -> Results:
        """`plica stiffness`; see plica.stiffness."""
        return commands.stiffness(self, out, **options)

    def sweep(self, values: Any, out: str | Path, **options: Any) -> Any:
        """`plica sweep`; see plica.sweep."""
        from .sweep import sweep
        return sweep(self, values, out, **options)

    @takes_options("diagnose")
    def diagnose(self, out: str | Path | None = None, **options: Any) -> Results:
        """`plica diagnose`; see plica.diagnose."""
        return commands.diagnose(self, out, **options)


def _renamed(problem: Problem, shown: Path, meant: Path) -> tuple[str, int, str, str, str]:
    file = str(meant) if Path(problem.file) == shown else problem.file
    return file, problem.line, problem.key, problem.wrong, problem.allowed
