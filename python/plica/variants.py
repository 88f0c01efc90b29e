"""Variants of a sweep as runs of their own, and what was run before."""
from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Any, Mapping

from . import commands
from .case import Case
from .errors import NumericalVerdict, PlicaError
from .results import Results

Row = dict[str, Any]


def folder_of(out: Path, case: Case, options: Mapping[str, Any]) -> Path:
    """Named by what the case says and by the options that matter to its results."""
    said = repr((case.digest, sorted((k, str(v)) for k, v in options.items()
                                     if k not in ("threads", "progress", "quiet"))))
    return out / hashlib.sha256(said.encode()).hexdigest()[:12]


def run_before(folder: Path) -> Results | None:
    """What was run before; None where there is nothing."""
    return Results(folder) if (folder / "results.json").is_file() else None


def run_into(case: Case, folder: Path, options: Mapping[str, Any]) -> Results:
    folder.parent.mkdir(parents=True, exist_ok=True)
    try:
        return commands.run(case, folder, **options)
    except NumericalVerdict as verdict:
        raise PlicaError(str(verdict)) from verdict
