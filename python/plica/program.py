"""The program `plica`: where it is, of which version, and what its commands take.

It is looked for as named by `plica.use("/path/to/plica")`, then by the environment variable PLICA,
then on PATH.
"""
from __future__ import annotations

import json
import os
import shutil
import subprocess
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, Mapping

from . import version
from .errors import NoExecutable, OptionError, VersionError
from .signatures import keyword_of, show

_named: list[str] = []


def use(path: str | Path) -> None:
    """Names the executable for all that follows; NoExecutable or VersionError."""
    named = str(path)  # a path stays that of the folder of now
    _named[:] = [os.path.abspath(named) if os.sep in named else named]
    executable()


def executable() -> str:
    """The program; NoExecutable says where it was looked for. Its version is checked once."""
    named = _named[0] if _named else os.environ.get("PLICA", "")
    found = shutil.which(named or "plica")
    if found is None:
        raise NoExecutable(f"'{named}' is no program that can be run; the path of plica" if named
                           else "there is no program `plica` on PATH; install the package plica, "
                                "set PLICA, or plica.use('/path/to/plica')")
    show(_schema_of(found, os.stat(found).st_mtime_ns))
    return found


@dataclass(frozen=True)
class Option:
    """An option of a command as the program describes it.

    `kind`: flag, text, number, whole or path.
    """

    name: str
    kind: str
    help: str
    list: bool = False
    delimiter: str | None = None
    required: bool = False
    choices: tuple[str, ...] | None = None
    min: float | None = None
    max: float | None = None
    default: str | None = None

    @property
    def keyword(self) -> str:
        """The name as a keyword of Python: `no_variants`."""
        return keyword_of(self.name)


@dataclass(frozen=True)
class Command:
    """A command: its help, what stands after it in order, its options by keyword."""

    name: str
    help: str
    positionals: tuple[Option, ...]
    options: Mapping[str, Option]

    def __str__(self) -> str:
        lines = [f"plica {self.name}: {self.help}"]
        for option in self.options.values():
            what = " | ".join(option.choices) if option.choices else option.kind
            lines.append(f"  {option.keyword} ({what}{', several' if option.list else ''}): "
                         + option.help)
        return "\n".join(lines)


def command(name: str) -> Command:
    """A command of the program that is in use; OptionError where it has none of that name."""
    data = schema()
    if name not in data["commands"]:
        raise OptionError(f"there is no command '{name}'; {', '.join(data['commands'])}")
    entry = data["commands"][name]
    options = [_option(o) for o in [*entry["options"], *data.get("global", [])]]
    return Command(name, entry["help"], tuple(_option(o) for o in entry["positionals"]),
                   {o.keyword: o for o in options})


def options(name: str) -> Mapping[str, Option]:
    """The options of a command by keyword: `plica.options("run")`."""
    return command(name).options


def schema() -> dict[str, Any]:
    """All commands: `plica schema commands`."""
    path = executable()
    return _schema_of(path, os.stat(path).st_mtime_ns)


@lru_cache(maxsize=8)
def _schema_of(path: str, changed: int) -> dict[str, Any]:
    """Of a program of this version; what it is said to be of is in the same JSON."""
    try:
        done = subprocess.run([path, "schema", "commands"], stdin=subprocess.DEVNULL,
                              capture_output=True, timeout=60, check=False)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise NoExecutable(f"{path}: cannot be run: {error}") from error
    try:
        data = json.loads(done.stdout)
        theirs = str(data["plica_version"])
    except (ValueError, LookupError, TypeError) as error:
        raise VersionError(f"{path}: does not say which version it is; the program plica"
                           ) from error
    version.check(theirs, path)
    return dict(data)


def _option(entry: Mapping[str, Any]) -> Option:
    choices = entry.get("choices")
    return Option(entry["name"], entry["kind"], entry.get("help", ""), bool(entry.get("list")),
                  entry.get("delimiter"), bool(entry.get("required")),
                  tuple(choices) if choices else None, entry.get("min"), entry.get("max"),
                  entry.get("default"))
