"""YAML loaded as the program reads it, and places in it.

Paths are those of the program: `parts.bellows.profile[1].height`; an entry of a list may also be
named, `sensors[mid].at`. Needs PyYAML.
"""
from __future__ import annotations

import re
from typing import Any

from .errors import MissingData
from .optional import need

FLOAT = r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?"


def load(text: str) -> Any:
    """The data of a text; ValueError where it is no YAML. 1e-8 is a number, as in YAML 1.2."""
    yaml = need("yaml", "reading YAML")
    base = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    loader: Any = type("Loader", (base,), {})
    loader.add_implicit_resolver("tag:yaml.org,2002:float", re.compile(f"^{FLOAT}$"),
                                 list("-+0123456789."))
    try:
        return yaml.load(text, Loader=loader)
    except yaml.YAMLError as error:
        raise ValueError(str(error)) from error


def steps(path: str) -> list[str | int]:
    """["parts", "bellows", "profile", 1, "height"] of a path; ValueError where it is none."""
    found: list[str | int] = []
    for part in re.finditer(r"\[([^\[\]]+)\]|([^.\[\]]+)|(.)", path):
        if part.group(3) and part.group(3) != ".":
            raise ValueError(f"'{path}' is no path; such as parts.bellows.profile[1].height")
        if part.group(1):
            found.append(int(part.group(1)) if part.group(1).isdigit() else part.group(1))
        elif part.group(2):
            found.append(part.group(2))
    if not found:
        raise ValueError("an empty path; such as parts.bellows.profile[1].height")
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
    """(parent, node, steps left): the node of a path, or None and what is not there of the path."""
    yaml = need("yaml", "editing a case")
    root = yaml.compose(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))
    way, parent, node = steps(path), root, root
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
