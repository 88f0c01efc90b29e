"""YAML edited in place: one value changes its letters and nothing else does.

Comments, order, blanks, line ends and the numbers of the lines before it stay.
"""
from __future__ import annotations

import json
import os
import re
from typing import Any, Iterator

from .errors import MissingData, OptionError
from .yaml_text import FLOAT, children, find, is_block

BLANK = " \t\r\n"


def _span(text: str, node: Any) -> tuple[int, int]:
    """Where the letters of a node are; a block ends before blanks and comments that follow it."""
    begin, end = node.start_mark.index, node.end_mark.index
    leaves = list(_leaves(node))
    if is_block(node) and leaves:
        end = leaves[-1].end_mark.index
    while end > begin and text[end - 1] in BLANK:
        end -= 1
    return begin, end


def _leaves(node: Any) -> Iterator[Any]:
    if is_block(node):
        for _, value in children(node):
            yield from _leaves(value)
    else:
        yield node


def replaced(text: str, path: str, value: Any) -> str:
    """The text with another value at a path; a key that is not there yet is added to its map."""
    parent, node, left = find(text, path)
    end: int
    if node is not None:
        begin, end = _span(text, node)
        return text[:begin] + flow(value) + text[end:]
    if parent is None or parent.id != "mapping" or any(isinstance(s, int) for s in left):
        raise MissingData(f"there is no place for '{path}': no {left[0]}")
    for step in reversed(left[1:]):
        value = {str(step): value}
    entry = f"{left[0]}: {flow(value)}"
    if parent.flow_style:
        end = int(parent.end_mark.index) - 1
        while text[end - 1] in BLANK + ",":
            end -= 1
        return text[:end] + (", " if parent.value else "") + entry + text[end:]
    indent = int(parent.value[0][0].start_mark.column)
    _, end = _span(text, parent)
    rest = text.find("\n", end)  # behind a comment on the last line
    end = len(text) if rest < 0 else rest - (text[rest - 1] == "\r")
    line_end = "\r\n" if "\r\n" in text else "\n"
    return text[:end] + line_end + " " * indent + entry + text[end:]


def removed(text: str, path: str) -> str:
    """The text without a key or an item; MissingData where it is not there."""
    parent, node, left = find(text, path)
    if node is None:
        raise MissingData(f"there is no '{path}': no {left[0]}")
    if parent.id == "mapping":
        keys = {id(value): key for key, value in parent.value}
        begin = keys[id(node)].start_mark.index
    else:
        begin = node.start_mark.index
    end = _span(text, node)[1]
    if parent.flow_style:
        after = re.match(r"\s*,\s*", text[end:])
        if after:
            return text[:begin] + text[end + after.end():]
        before = re.search(r",?\s*$", text[:begin])
        return text[:before.start() if before else begin] + text[end:]
    line = text.rfind("\n", 0, begin) + 1
    rest = text.find("\n", end)
    return text[:line] + ("" if rest < 0 else text[rest + 1:])


def flow(value: Any) -> str:
    """A value on one line: plain where that is safe, else in quotes. OptionError where it is none
    that YAML has; a Path is its text."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if isinstance(value, dict):
        return "{" + ", ".join(f"{flow(str(k))}: {flow(v)}" for k, v in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(flow(v) for v in value) + "]"
    if isinstance(value, str):
        plain = re.fullmatch(r"[A-Za-z0-9_+\-/.%^*() ]*[A-Za-z0-9%)]", value)
        safe = plain and not value.startswith(("-", "*", "%", " ")) \
            and value.lower() not in ("null", "true", "false", "yes", "no", "on", "off") \
            and not re.fullmatch(FLOAT, value)
        return value if safe else json.dumps(value, ensure_ascii=False)
    try:
        return "null" if value is None else json.dumps(value)
    except TypeError:
        raise OptionError(f"{value!r} is no value of a case: {type(value).__name__}; a text with a "
                          "unit, a number in SI, a list or a dict of these") from None
