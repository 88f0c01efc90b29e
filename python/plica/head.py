"""The first keys of a JSON object, without reading what is behind them.

The program writes results.json with what tables of many runs take at its head and with what grows
with the mesh at its end: of a run with stress the head is a hundredth of the text.
"""
from __future__ import annotations

import codecs
import json
import os
from pathlib import Path
from typing import Any

BLOCK = 1 << 16  # bytes that are read first, then twice as many, ...
SPACE = " \t\n\r"
_decoder = json.JSONDecoder()


def head_of(path: Path, keys: set[str]) -> dict[str, Any]:
    """Values of `keys` of the object in a file, all that are there. ValueError: it is no object, or
    is cut: it has to end as an object does."""
    with open(path, "rb") as file:
        size = os.fstat(file.fileno()).st_size
        file.seek(max(0, size - 16))
        if not file.read().rstrip().endswith(b"}"):
            raise ValueError("it is cut")
        length = BLOCK
        while True:
            file.seek(0)
            data = file.read(length)
            whole = len(data) == size
            try:  # a letter of several bytes may be cut at the end of a block
                text = codecs.getincrementaldecoder("utf-8")().decode(data, final=whole)
                return _keys_of(text, keys)
            except ValueError:
                if whole:
                    raise
            length *= 4


def _keys_of(text: str, keys: set[str]) -> dict[str, Any]:
    """ValueError also where the text ends before the last of them."""
    found: dict[str, Any] = {}
    at = _after(text, 0, "{")
    while len(found) < len(keys):
        at = _skipped(text, at)
        if text[at:at + 1] == "}":
            break
        _after(text, at, '"')
        key, at = _decoder.raw_decode(text, at)
        value, at = _decoder.raw_decode(text, _skipped(text, _after(text, at, ":")))
        if at >= len(text):  # a number may go on behind the end
            raise json.JSONDecodeError("it ends", text, at)
        if key in keys:
            found[key] = value
        at = _skipped(text, at)
        if text[at:at + 1] != "}":
            at = _after(text, at, ",")
    return found


def _skipped(text: str, at: int) -> int:
    while text[at:at + 1] in SPACE and at < len(text):
        at += 1
    return at


def _after(text: str, at: int, sign: str) -> int:
    at = _skipped(text, at)
    if text[at:at + 1] != sign:
        raise json.JSONDecodeError(f"there is no {sign}", text, at)
    return at + 1
