"""Functions of commands show the options of the program that is in use as their keywords: in
`help(plica.run)`, `inspect.signature`, and under the tab key of a notebook."""
from __future__ import annotations

import inspect
from keyword import iskeyword
from typing import Any, Callable, Mapping, TypeVar

KINDS = {"flag": "bool", "whole": "int", "number": "float"}  # of options; others are texts
Function = TypeVar("Function", bound=Callable[..., Any])
_functions: list[tuple[str, Callable[..., Any], inspect.Signature]] = []
_own = inspect.Parameter("progress", inspect.Parameter.KEYWORD_ONLY, default=False,
                         annotation="bool")


def keyword_of(option: str) -> str:
    """The name of an option as a keyword: `no_variants`, `yield_` where Python has the word."""
    name = option.replace("-", "_")
    return name + "_" if iskeyword(name) else name


def takes_options(command: str) -> Callable[[Function], Function]:
    """Of a function with **options that it hands to a command of the program."""
    def register(function: Function) -> Function:
        _functions.append((command, function, inspect.signature(function)))
        return function
    return register


def show(schema: Mapping[str, Any]) -> None:
    """`schema`: what `plica schema commands` of the program in use says."""
    for command, function, written in _functions:
        entry = schema.get("commands", {}).get(command)
        if entry is None:
            continue
        given = [p for p in written.parameters.values() if p.kind is not p.VAR_KEYWORD]
        names = {p.name for p in given} | {"messages"}  # which the package sets itself
        options = [o for o in entry["options"] if keyword_of(o["name"]) not in names]
        keywords = [inspect.Parameter(
            keyword_of(o["name"]), inspect.Parameter.KEYWORD_ONLY, default=None,
            annotation=KINDS.get(o["kind"], "str") + (" | list" if o.get("list") else "")
            + " | None") for o in options]
        setattr(function, "__signature__", written.replace(parameters=[*given, *keywords, _own]))
