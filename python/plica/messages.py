"""What a run of the program says: with `--messages json` progress, warnings and errors are JSON
lines. Any other line is kept as it is and decides nothing."""
from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import IO, Any, Callable

from .errors import Problem


@dataclass
class Said:
    """What a run said: exit code, standard output, problems, warnings, what stood in its folder
    when it had written (fingerprints of its own files and of others by name), all else."""

    code: int = 0
    printed: str = ""
    problems: list[Problem] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)
    own: dict[str, str] = field(default_factory=dict)
    others: dict[str, str] = field(default_factory=dict)
    failure: str = ""


def listen(stream: IO[str], said: Said, show: Callable[[str, Any], None]) -> None:
    rest = []
    for line in stream:
        message = _message(line)
        kind = message.get("kind") if message else None
        if message and kind == "progress":
            show(str(message.get("stage", "")), message.get("share"))
        elif message and kind == "error":
            said.problems.append(Problem(str(message.get("file") or ""), message.get("line") or 0,
                                         str(message.get("key") or ""), str(message["wrong"]),
                                         str(message.get("allowed") or "")))
        elif message and kind == "warning":
            said.warnings.append(str(message["text"]))
        elif message and kind == "written":
            for name, file in message["files"].items():
                mine = said.own if file["command"] == message["command"] else said.others
                mine[str(name)] = str(file["fingerprint"])
        elif message and kind in ("failure", "note"):
            rest.append(str(message["text"]) + "\n")
        else:
            rest.append(line)
    said.failure = "".join(rest).strip()


def _message(line: str) -> dict[str, Any] | None:
    try:
        data = json.loads(line)
    except ValueError:
        return None
    return data if isinstance(data, dict) else None
