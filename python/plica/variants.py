"""Rows of a sweep as variants of one case, many in a process, and what was run before."""
from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Any, Callable, Iterable, Mapping

from . import commands, yaml_edit
from .case import Case
from .errors import CaseError, NumericalVerdict, PlicaError
from .results import Results

Row = dict[str, Any]


def folder_of(out: Path, case: Case, options: Mapping[str, Any]) -> Path:
    """Named by what the case says and by the options that matter to its results."""
    said = repr((case.digest, sorted((k, str(v)) for k, v in options.items()
                                     if k not in ("threads", "progress", "quiet"))))
    return out / hashlib.sha256(said.encode()).hexdigest()[:12]


def run_before(folder: Path, rows: int) -> Results | None:
    """What was run before; None where that was not, or was stopped before all its variants."""
    if not (folder / "results.json").is_file():
        return None
    results = Results(folder)
    done = {v["name"] for v in results.data["variants"]}
    told = " ".join(results.data["warnings"])
    names = [f"row {k}" for k in range(rows)]
    return results if all(n in done or f"'{n}'" in told for n in names) else None


def run_into(case: Case, folder: Path, options: Mapping[str, Any]) -> Results:
    folder.parent.mkdir(parents=True, exist_ok=True)
    try:
        return commands.run(case, folder, **options)
    except NumericalVerdict as verdict:
        raise PlicaError(str(verdict)) from verdict


def batch(base: Case, rows: list[Row], numbers: Iterable[int], out: Path,
          options: Mapping[str, Any]) -> Callable[[], dict[int, Row]]:
    """A task that runs rows as variants, without those that the program refuses."""
    def task() -> dict[int, Row]:
        left, found = list(numbers), {}
        while left:
            case, first_line = _with_variants(base, [rows[k] for k in left])
            folder = folder_of(out, case, options)
            try:
                results = run_before(folder, len(left)) or run_into(case, folder, options)
            except CaseError as error:
                wrong = _wrong_rows(error, first_line, left)
                found.update({k: {"error": text} for k, text in wrong.items()})
                left = [k for k in left if k not in wrong]
                continue
            found.update(_headlines(results, left))
            break
        return found
    return task


def _with_variants(base: Case, rows: list[Row]) -> tuple[Case, int]:
    """The case with a variant a line at its end, and the line of the first one."""
    case = base.copy()
    if "variants" in case:
        del case["variants"]
    text = case.text.rstrip("\n") + "\nvariants:\n"
    lines = [f"  - {{name: row {k}, set: {yaml_edit.flow(row)}}}\n" for k, row in enumerate(rows)]
    case.text = text + "".join(lines)
    return case, text.count("\n") + 1


def _wrong_rows(error: CaseError, first_line: int, left: list[int]) -> dict[int, str]:
    """Messages of rows by the lines of their variants; the error where another line is wrong."""
    wrong: dict[int, str] = {}
    for problem in error.problems:
        k = problem.line - first_line
        if not 0 <= k < len(left):
            raise error
        wrong[left[k]] = (wrong.get(left[k], "") + "\n" + str(problem)).strip()
    if not wrong:
        raise error
    return wrong


def _headlines(results: Results, left: list[int]) -> dict[int, Row]:
    named = {v["name"]: v["headline"] for v in results.data["variants"]}
    warnings = results.data["warnings"]
    found: dict[int, Row] = {}
    for k, row in enumerate(left):
        name = f"row {k}"
        why = next((w for w in warnings if f"'{name}'" in w), "no numbers")
        found[row] = {**named[name], "error": ""} if name in named else {"error": why}
    return found
