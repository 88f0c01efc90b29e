"""What a run of the program says.

A program that has `--messages json` says progress, warnings and errors as JSON lines. One that has
not runs with `--quiet`: the bar then shows seconds, and problems are taken from lines of the form
"file:line: key: wrong; allowed".
"""
from __future__ import annotations

import json
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, Any, Callable, Sequence

from .errors import Problem


@dataclass
class Said:
    """What a run said: exit code, standard output, problems, warnings, all else."""

    code: int = 0
    printed: str = ""
    problems: list[Problem] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)
    failure: str = ""


def listen(stream: IO[str], said: Said, words: Sequence[str],
           show: Callable[[str, Any], None]) -> None:
    """`words`: of the command, for problems as lines; none of a program with JSON lines."""
    rest = []
    for line in stream:
        message = None if words else _message(line)
        kind = message.get("kind") if message else None
        if message and kind == "progress":
            show(str(message.get("stage", "")), message.get("share"))
        elif message and kind == "error":
            said.problems.append(Problem(str(message.get("file") or ""), message.get("line") or 0,
                                         str(message.get("key") or ""), str(message["wrong"]),
                                         str(message.get("allowed") or "")))
        elif message and kind == "warning":
            said.warnings.append(str(message["text"]))
        elif message and kind in ("failure", "note"):
            rest.append(str(message["text"]) + "\n")
        elif words and (problem := problem_of(line, words)):
            said.problems.append(problem)
        else:
            rest.append(line)
    said.failure = "".join(rest).strip()


def _message(line: str) -> dict[str, Any] | None:
    try:
        data = json.loads(line)
    except ValueError:
        return None
    return data if isinstance(data, dict) else None


def problem_of(line: str, words: Sequence[str] = ()) -> Problem | None:
    """Of "file:line: key: wrong; allowed", of a file that is there or was given; else None."""
    found = re.match(r"(?P<file>.+?)(?::(?P<line>\d+))?: (?:(?P<key>[\w.\[\]-]+): )?"
                     r"(?P<wrong>.*?)(?:; (?P<allowed>.*))?$", line.rstrip("\n"))
    if not found or not (found["file"] in words or Path(found["file"]).is_file()):
        return None
    return Problem(found["file"], int(found["line"] or 0), found["key"] or "", found["wrong"],
                   found["allowed"] or "")
