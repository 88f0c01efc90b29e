"""Many runs of one case with other numbers, side by side, into one table.

Headline numbers come from `variants` of the case, many in one process. With `collect` every
variant is a run of its own in a folder of its own, and `collect(results)` says what goes into the
table. What was run before in `out` is not run again: folders are named by what the case says.
"""
from __future__ import annotations

import itertools
import os
from concurrent.futures import Future, ThreadPoolExecutor, as_completed
from pathlib import Path
from typing import Any, Callable, Iterable, Mapping, Sequence

from . import child
from .case import Case
from .documents import frame_of
from .errors import PlicaError
from .optional import have, need
from .results import Results
from .variants import Row, batch, folder_of, run_before, run_into

Collect = Callable[[Results], Mapping[str, Any]]
BATCH = 25  # variants of a process


def sweep(case: Case | str | Path, values: Any, out: str | Path, *,
          collect: Collect | None = None, workers: int | None = None, progress: bool = False,
          **options: Any) -> Any:
    """DataFrame, one variant a row in the order of `values`: its values, its numbers, `error`.

    values: {path: list} for all combinations, or a DataFrame or list of {path: value}; a value is
    a text with a unit or a number in SI. out: folder for the runs. collect: numbers of a run, in
    place of the headline (first modes, stiffness, mass; SI). workers: runs side by side, as many as
    there are cores unless given. options: those of `plica run`; threads is 1 unless given.

    A variant that fails has its message in `error` and NaN for its numbers. CaseError where the
    case itself is wrong. A changed input beside the case (test data, geometry) is not seen by what
    was run before: take another folder.
    """
    base = case.copy() if isinstance(case, Case) else Case(case)
    rows = combinations(values)
    options = {"threads": 1, "no_error_bars": True, **options}
    if collect is not None or options.get("model"):
        numbers = collect or (lambda results: results.headline)
        tasks: list[Callable[[], dict[int, Row]]] = [
            _alone(base, rows, k, Path(out), numbers, options) for k in range(len(rows))]
    else:
        size = max(1, min(BATCH, -(-len(rows) // (workers or os.cpu_count() or 1))))
        tasks = [batch(base, rows, range(k, min(k + size, len(rows))), Path(out), options)
                 for k in range(0, len(rows), size)]
    found = _all(tasks, workers, progress)
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


def _all(tasks: Sequence[Callable[[], dict[int, Row]]], workers: int | None, progress: bool
         ) -> dict[int, Row]:
    found: dict[int, Row] = {}
    with ThreadPoolExecutor(workers or os.cpu_count() or 1) as pool:
        futures: list[Future[dict[int, Row]]] = [pool.submit(task) for task in tasks]
        done: Any = as_completed(futures)
        if progress and have("tqdm"):
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
            found = run_before(folder, 0) or run_into(
                case, folder, {"no_variants": True, **options})
            return {k: {**collect(found), "error": ""}}
        except PlicaError as error:
            return {k: {"error": str(error)}}
    return task
