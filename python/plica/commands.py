"""The commands of the program as functions.

Options are keywords, those of the program itself: `plica.options("run")` lists them with their
help, `no_variants=True` is `--no-variants`. Each function takes a Case, a file or a folder, and
`progress=True` shows a bar. Errors: CaseError with all problems of an input, NumericalVerdict (the
results are written), ProgramFailed, OptionError, NoExecutable. Results are of their own run:
BrokenFolder where another has been written to `out` since.
"""
from __future__ import annotations

import json
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

from . import arguments, child, program, yaml_edit
from .errors import CaseError, NumericalVerdict, OptionError, ProgramFailed, TooLarge
from .messages import Said
from .one_run import of_one_run
from .results import Results
from .signatures import takes_options

if TYPE_CHECKING:
    from .case import Case
    from .measured import Measured

AnyCase = Union["Case", str, Path]
AnyTest = Union["Measured", Results, str, Path]


@dataclass(frozen=True)
class Check:
    """A valid case: what the program says of its size and cost, and as data where it says so."""

    text: str
    warnings: list[str] = field(default_factory=list)
    data: dict[str, Any] = field(default_factory=dict)


@takes_options("run")
def run(case: AnyCase, out: str | Path | None = None, **options: Any) -> Results:
    """`plica run`: statics, modes, responses and report. Results in `out`."""
    return _compute("run", [case], out, options)


@takes_options("reduce")
def reduce(case: AnyCase, out: str | Path | None = None, **options: Any) -> Results:
    """`plica reduce`: the case as a superelement, `results.superelement`."""
    return _compute("reduce", [case], out, options)


@takes_options("fit")
def fit(case: AnyCase, out: str | Path | None = None, **options: Any) -> Results:
    """`plica fit`: numbers of the case adjusted to its test, `results.fit`."""
    return _compute("fit", [case], out, options)


@takes_options("diagnose")
def diagnose(case: AnyCase, out: str | Path | None = None, **options: Any) -> Results:
    """`plica diagnose`: what the gap to the test is made of, `results.diagnosis`."""
    return _compute("diagnose", [case], out, options)


@takes_options("compare")
def compare(result: AnyTest, test: AnyTest, out: str | Path | None = None, **options: Any
            ) -> Results:
    """`plica compare`: simulation and test side by side, `results.correlation`."""
    return _compute("compare", [result, test], out, options)


@takes_options("identify")
def identify(files: AnyTest | list[str | Path], out: str | Path | None = None, **options: Any
             ) -> Results:
    """`plica identify`: modes of a measured.yaml or of files of responses."""
    return _compute("identify", list(files) if isinstance(files, list) else [files], out, options)


@takes_options("ejma")
def ejma(case: AnyCase, out: str | Path | None = None, **options: Any) -> Results:
    """`plica ejma`: EJMA's formulas for every bellows beside its shells, `results.ejma`."""
    return _compute("ejma", [case], out, options)


@takes_options("stiffness")
def stiffness(case: AnyCase, out: str | Path | None = None, **options: Any) -> Results:
    """`plica stiffness`: dynamic stiffness between two ends, `results.stiffness`."""
    return _compute("stiffness", [case], out, options)


@takes_options("init")
def init(path: str | Path, **options: Any) -> Case:
    """`plica init`: writes a commented case file to begin with, `kind="decoupler"` and the like;
    the case, of `kind="measured"` that beside the test."""
    from .case import Case
    _call("init", [path], options)
    return Case(path)


def schema(kind: str = "case") -> dict[str, Any]:
    """`plica schema`: the JSON Schema of the "case", "measured" or "benchmark" file, or the
    "commands"."""
    said, _ = _call("schema", [kind], {})
    return dict(json.loads(said.printed))


@takes_options("check")
def check(case: AnyCase, **options: Any) -> Check:
    """`plica check`: CaseError with all problems, or what the case would cost."""
    said, _ = _call("check", [case], {**options, "json": True})
    data = json.loads(said.printed)
    return Check(_size_of(data), [*said.warnings, *data.get("warnings", [])], data)


def _size_of(data: dict[str, Any]) -> str:
    if "model" not in data:
        return "the benchmark is valid"
    model, cost = data["model"], data["estimate"]
    return (f"the case is valid: {model['nodes']} nodes, {model['elements']} elements, "
            f"{model['dofs']} degrees of freedom; estimate: {cost['memory'] / 1e9:.1f} GB, "
            f"{cost['seconds']:.0f} s a run")


def run_sweep(case: AnyCase, out: str | Path, **options: Any) -> Path:
    """`plica sweep`: the table of many variants, `out`/sweep.csv and sweep.h5; plica.sweep gives
    it as a DataFrame."""
    _call("sweep", [case], {**options, "out": Path(out)})
    return Path(out)


def _compute(name: str, inputs: list[Any], out: str | Path | None, options: dict[str, Any]
             ) -> Results:
    if options.get("write_deck"):
        raise OptionError("write_deck writes a deck and no results; plica.write_deck(case, out, "
                          "solver)")
    if options.get("json"):
        raise OptionError(f"json prints and writes no results; plica.results(out).{name}")
    if out is not None:
        options = {**options, "out": Path(out)}
    folder = Path(options.get("out") or program.options(name)["out"].default or "out")
    said, words = _call(name, inputs, options)
    if said.code == 2:
        raise NumericalVerdict(f"{' '.join(words[1:3])}: {said.failure or 'a verdict failed'}; "
                               f"the results are in {folder}", folder)
    return of_one_run(Results(folder), said)


def write_deck(case: AnyCase, out: str | Path, solver: str, **options: Any) -> Path:
    """`plica run --write-deck`: the model for "abaqus" or "nastran"; the path of the deck."""
    _call("run", [case], {**options, "out": Path(out), "write_deck": solver})
    return Path(out) / ("model.bdf" if solver == "nastran" else "model.inp")


def _call(name: str, inputs: list[Any], options: dict[str, Any]) -> tuple[Said, list[str]]:
    command = program.command(name)
    options = dict(options)
    changes: Any = options.get("set")
    if isinstance(changes, dict):  # {path: value}
        options["set"] = [f"{path}={value if isinstance(value, str) else yaml_edit.flow(value)}"
                          for path, value in changes.items()]
    bar = options.pop("progress", False)
    options["messages"] = "json"
    with ExitStack() as stack:
        paths = [_path(item, stack) for item in inputs]
        words = [program.executable(), name, *paths, *arguments.words(command, options)]
        said = child.call(words, f"plica {name}", bool(bar))
        if said.code == 1:
            raise CaseError(said.problems, said.failure)
        if said.code not in (0, 2):
            kind = TooLarge if said.code == 4 else ProgramFailed
            raise kind(f"plica {name} ended with {said.code}: {said.failure}", said.code)
    return said, words


def _path(item: Any, stack: ExitStack) -> str:
    """The path that the program gets: of a changed case a file that goes again."""
    if hasattr(item, "file") and hasattr(item, "digest"):
        return str(stack.enter_context(item.file()))
    path = item.path if hasattr(item, "path") else Path(item)
    if str(path).startswith("-"):
        raise OptionError(f"'{path}' begins like an option; ./{path}")
    return str(path)
