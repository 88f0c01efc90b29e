"""Keywords of Python as words of the command line, checked by what the program says of itself."""
from __future__ import annotations

import difflib
import os
from typing import Any, Iterable

from .errors import OptionError
from .program import Command, Option


def words(command: Command, values: dict[str, Any]) -> list[str]:
    """["--threads", "2", "--no-variants"] of {"threads": 2, "no_variants": True}.

    None and False leave an option out. OptionError: no such option, or not such a value.
    """
    result: list[str] = []
    for keyword, value in values.items():
        option = command.options.get(keyword)
        if option is None:
            near = difflib.get_close_matches(keyword, command.options, 1)
            hint = f"did you mean '{near[0]}'?" if near else ", ".join(command.options)
            raise OptionError(f"plica {command.name} has no option '{keyword}'; {hint}")
        if value is None or value is False:
            continue
        result += _words(command.name, option, value)
    return result


def _words(command: str, option: Option, value: Any) -> list[str]:
    flag = f"--{option.name}"
    if option.kind == "flag":
        if value is not True:
            raise _refused(command, option, value)
        return [flag]
    several = isinstance(value, Iterable) and not isinstance(value, (str, bytes, os.PathLike))
    if several and not option.list:
        raise _refused(command, option, value)
    texts = [_text(command, option, item) for item in (value if several else [value])]
    if not texts:
        return []
    if option.delimiter:
        return [flag, option.delimiter.join(texts)]
    return [word for text in texts for word in (flag, text)]


def _text(command: str, option: Option, value: Any) -> str:
    if isinstance(value, bool):
        raise _refused(command, option, value)
    if option.kind in ("number", "whole"):
        try:
            number = float(value)
        except (TypeError, ValueError):
            raise _refused(command, option, value) from None
        low = -float("inf") if option.min is None else option.min
        high = float("inf") if option.max is None else option.max
        if not low <= number <= high or (option.kind == "whole" and number != int(number)):
            raise _refused(command, option, value)
        return str(int(number)) if option.kind == "whole" else repr(number)
    text = str(os.fspath(value)) if isinstance(value, os.PathLike) else str(value)
    if option.choices and text not in option.choices:
        raise _refused(command, option, value)
    return text


def _refused(command: str, option: Option, value: Any) -> OptionError:
    if option.choices:
        allowed = " or ".join(option.choices)
    elif option.kind == "flag":
        allowed = "True or False"
    else:
        allowed = {"whole": "a whole number", "number": "a number"}.get(option.kind, "a text")
        if option.min is not None or option.max is not None:
            allowed += f" from {option.min} to {option.max}"
    return OptionError(f"plica {command}: {option.keyword}={value!r}; "
                       f"{allowed}{', or a list of them' if option.list else ''}")
