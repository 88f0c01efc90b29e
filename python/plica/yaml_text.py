"""YAML loaded as the program reads it, and places in it.

Paths are those of the program: `parts.bellows.profile[1].height`; an entry of a list may also be
named, `sensors[mid].at`. Needs PyYAML.
"""
from __future__ import annotations

import re
from typing import Any

from .errors import MissingData, OptionError
from .optional import need

FLOAT = r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?"
EXAMPLE = "such as parts.bellows.profile[1].height"


class BrokenText(ValueError):
    """A text is no YAML, or no map: what is wrong in which line, 0 is the whole."""

    def __init__(self, line: int, wrong: str, allowed: str, text: str = "") -> None:
        self.line, self.wrong, self.allowed = line, wrong, allowed
        super().__init__(text or f"{wrong}; {allowed}")


def _loader(yaml: Any) -> Any:
    base = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    loader: Any = type("Loader", (base,), {})
    loader.add_implicit_resolver("tag:yaml.org,2002:float", re.compile(f"^{FLOAT}$"),
                                 list("-+0123456789."))
    return loader


def _broken(text: str, error: Any) -> BrokenText:
    """Of an error of PyYAML, or of a value that is no date."""
    mark = getattr(error, "problem_mark", None)
    line = 0 if mark is None else int(mark.line) + 1
    if hasattr(error, "position"):  # a letter that no YAML has
        line = text.encode()[:error.position].count(b"\n") + 1
    what = getattr(error, "problem", None) or getattr(error, "reason", None) or str(error)
    return BrokenText(line, f"YAML syntax: {what}",
                      "check brackets, quotes, colons and indentation here and above", str(error))


def load(text: str) -> Any:
    """The data of a text; BrokenText where it is no YAML. 1e-8 is a number, as in YAML 1.2."""
    yaml = need("yaml", "reading YAML")
    try:
        return yaml.load(text, Loader=_loader(yaml))
    except (yaml.YAMLError, ValueError) as error:
        raise _broken(text, error) from error


def steps(path: str) -> list[str | int]:
    """["parts", "bellows", "profile", 1, "height"] of a path; OptionError where it is none."""
    if not isinstance(path, str):
        raise OptionError(f"a path is a text, not {path!r}; {EXAMPLE}")
    found: list[str | int] = []
    for part in re.finditer(r"\[([^\[\]]+)\]|([^.\[\]]+)|(.)", path):
        if part.group(3) and part.group(3) != ".":
            raise OptionError(f"'{path}' is no path; {EXAMPLE}")
        if part.group(1):
            found.append(int(part.group(1)) if part.group(1).isdecimal() else part.group(1))
        elif part.group(2):
            found.append(part.group(2))
    if not found:
        raise OptionError(f"an empty path; {EXAMPLE}")
    return found


def children(node: Any) -> list[tuple[str, Any]]:
    """Keys and values of a map; numbers, names and items of a list."""
    if node.id == "mapping":
        return [(str(key.value), value) for key, value in node.value]
    if node.id == "sequence":
        return [(str(k), item) for k, item in enumerate(node.value)]
    return []


def child(node: Any, step: str | int) -> Any | None:
    for name, value in children(node):
        if name == str(step):
            return value
        if node.id == "sequence" and dict(children(value)).get("name", value).value == step:
            return value
    return None


def find(text: str, path: str) -> tuple[Any, Any | None, list[str | int]]:
    """(parent, node, steps left): the node of a path, or None and what is not there of the path.

    OptionError where the path is none, BrokenText where the text is no map. The marks of nodes
    count the letters of a text without a byte order mark.
    """
    yaml = need("yaml", "editing a case")
    way = steps(path)
    try:
        root = yaml.compose(text, Loader=_loader(yaml))
    except yaml.YAMLError as error:
        raise _broken(text, error) from error
    if root is None:
        raise BrokenText(0, "the file is empty", "a YAML map with keys and values")
    if root.id != "mapping":
        raise BrokenText(root.start_mark.line + 1, "is no map", "a YAML map with keys and values")
    parent, node = root, root
    for k, step in enumerate(way):
        below = None if node is None else child(node, step)
        if below is None:
            return node, None, way[k:]
        parent, node = node, below
    return parent, node, []


def value_at(text: str, path: str) -> Any:
    """What stands at a path; MissingData names what is there instead."""
    parent, node, left = find(text, path)
    if node is None:
        there = [name for name, _ in children(parent)]
        raise MissingData(f"there is no '{path}': no {left[0]}; {', '.join(there) or 'a value'}")
    return load(_dedented(text, node) if is_block(node)
                else text[node.start_mark.index:node.end_mark.index])


def is_block(node: Any) -> bool:
    """A map or a list that is written over several lines, without brackets."""
    return getattr(node, "flow_style", None) is False


def _dedented(text: str, node: Any) -> str:
    """A block with its first line as far in as it was."""
    begin, end = int(node.start_mark.index), int(node.end_mark.index)
    return " " * int(node.start_mark.column) + text[begin:end]
