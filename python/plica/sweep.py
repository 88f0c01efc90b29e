"""Many runs of one case with other numbers into one table.

`plica sweep` runs them, many in one process, and keeps what it finished: what was run before in
`out` is not run again, also after Ctrl-C. With `collect` every variant is a run of its own, in a
folder of its own, and `collect(results)` says what goes into the table.
"""
from __future__ import annotations

import csv
import itertools
import json
import math
import os
import re
import tempfile
from concurrent.futures import Future, ThreadPoolExecutor, as_completed
from pathlib import Path
from typing import Any, Callable, Iterable, Mapping, Sequence

from . import child, commands, yaml_edit
from .bar import bars
from .case import Case
from .documents import frame_of
from .errors import CaseError, OptionError, PlicaError
from .optional import need
from .results import Results
from .variants import Row, folder_of, run_before, run_into

Collect = Callable[[Results], Mapping[str, Any]]


def sweep(case: Case | str | Path, values: Any, out: str | Path, *,
          collect: Collect | None = None, workers: int | None = None, progress: bool = False,
          **options: Any) -> Any:
    """DataFrame, one variant a row in the order of `values`: its values, its numbers, `error`.

    values: {path: list} for all combinations, or a DataFrame or list of {path: value}; a value is
    a text with a unit or a number in SI, None what the case says. values None: the options say
    what varies, such as vary="parts.tip.mass=0.1kg:0.4kg", design="sobol", count=100; the table is
    then that of the program, with status and reason. out: folder for the runs.
    workers: variants side by side, as many as there are cores unless given. options: those of
    `plica sweep`, such as result=["modes[0].frequency"] in place of the headline (first modes,
    stiffness, mass; SI), or set={path: value}.

    collect: numbers of a run, as a function of its results; options are then those of `plica run`,
    threads being 1 unless given. A changed input beside the case is then not seen by what was run
    before: take another folder.

    A variant that fails has its message in `error` and NaN for its numbers. CaseError where the
    case itself is wrong.
    """
    base = case.copy() if isinstance(case, Case) else Case(case)
    if values is None:
        if collect is not None:
            raise OptionError("collect goes with values; result=[...] with vary")
        commands.run_sweep(base, out, jobs=workers or 0, progress=progress, **options)
        return Results(out).sweep
    rows = combinations(values)
    if collect is None:
        return _by_program(base, rows, Path(out), workers, progress, options)
    options = {"threads": 1, "no_error_bars": True, **options}
    found = _all([_alone(base, rows, k, Path(out), collect, options) for k in range(len(rows))],
                 workers, progress)
    return frame_of([{**rows[k], **found[k]} for k in range(len(rows))])


def combinations(values: Any) -> list[Row]:
    """Rows of {path: value}: all combinations of {path: list}, or the rows of a table."""
    if isinstance(values, Mapping):
        lists = [list(v) if isinstance(v, Iterable) and not isinstance(v, str) else [v]
                 for v in values.values()]
        return [dict(zip(values, row)) for row in itertools.product(*lists)]
    if hasattr(values, "to_dict"):
        values = values.to_dict("records")
    return [{str(path): value for path, value in row.items()} for row in values]


def _by_program(base: Case, rows: list[Row], out: Path, workers: int | None, progress: bool,
                options: Mapping[str, Any]) -> Any:
    paths = list(dict.fromkeys(path for row in rows for path in row))
    with tempfile.TemporaryDirectory() as folder:
        table = Path(folder) / "variants.csv"
        with table.open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(paths)
            writer.writerows([_cell(row.get(path)) for path in paths] for row in rows)
        before = _written(out)
        try:
            commands.run_sweep(base, out, table=table, jobs=workers or 0, progress=progress,
                               **options)
        except CaseError as error:
            if error.problems or _written(out) == before or not _every_variant_failed(out):
                raise
    found, units = _numbers(out / "sweep.csv", paths)
    frame = frame_of([{**row, **numbers} for row, numbers in zip(rows, found)])
    if hasattr(frame, "attrs"):
        frame.attrs["units"] = units
    return frame


def _written(out: Path) -> tuple[int, int] | None:
    """Which sweep.json is there: one of before says nothing of this sweep."""
    try:
        found = (out / "sweep.json").stat()
    except OSError:
        return None
    return found.st_ino, found.st_mtime_ns


def _every_variant_failed(out: Path) -> bool:
    """The program ends with 1 then, too, but it has written its table."""
    counts = json.loads((out / "sweep.json").read_text(encoding="utf-8"))
    return int(counts["ok"]) == 0 and int(counts["failed"]) > 0


def _cell(value: Any) -> str:
    """As YAML; empty for what the case says itself."""
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return ""
    return value if isinstance(value, str) else str(yaml_edit.flow(value))


def _numbers(file: Path, paths: Sequence[str]) -> tuple[list[Row], dict[str, str]]:
    """Results and `error` of every row of sweep.csv, and the units of its columns."""
    with file.open(newline="", encoding="utf-8") as stream:
        header, *lines = csv.reader(stream)
    names = [re.sub(r" \[[^\[\]]*\]$", "", cell) for cell in header]
    units = {name: cell[len(name) + 2:-1] for name, cell in zip(names, header) if cell != name}
    results = range(1 + len(paths), len(header) - 2)
    rows: list[Row] = []
    for cells in lines:
        row: Row = {names[k]: float(cells[k]) if cells[k] else math.nan for k in results}
        row["error"] = cells[-1]
        rows.append(row)
    return rows, units


def _all(tasks: Sequence[Callable[[], dict[int, Row]]], workers: int | None, progress: bool
         ) -> dict[int, Row]:
    found: dict[int, Row] = {}
    with child.handling(), ThreadPoolExecutor(workers or os.cpu_count() or 1) as pool:
        futures: list[Future[dict[int, Row]]] = [pool.submit(task) for task in tasks]
        done: Any = as_completed(futures)
        if progress and bars():
            done = need("tqdm.auto", "a bar").tqdm(done, total=len(futures), desc="plica sweep")
        try:
            for future in done:
                found.update(future.result())
        except BaseException:
            for future in futures:
                future.cancel()
            child.end_all()
            raise
    return found


def _alone(base: Case, rows: list[Row], k: int, out: Path, collect: Collect,
           options: Mapping[str, Any]) -> Callable[[], dict[int, Row]]:
    def task() -> dict[int, Row]:
        try:
            case = base.copy().update(rows[k])
            folder = folder_of(out, case, options)
            found = run_before(folder) or run_into(
                case, folder, {"no_variants": True, **options})
            return {k: {**collect(found), "error": ""}}
        except PlicaError as error:
            return {k: {"error": str(error)}}
    return task
