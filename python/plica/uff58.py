"""Universal files, data set 58 and 58b: functions at nodal degrees of freedom.

After the published format of SDRC. A data set is a dict with the keys that pyuff gives it.

Limits: real and complex, even and uneven, single and double, IEEE floats of either byte order;
other data sets of a file are left out. Units are those of the file; the program converts them.
"""
from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np

from .errors import BrokenFolder

DataSet = dict[str, Any]
AXES = ("abscissa", "ordinate", "orddenom", "z_axis")


def read_uff58(path: str | Path) -> list[DataSet]:
    """All data sets 58 of a file, in its order; BrokenFolder where one is cut."""
    try:
        data = Path(path).read_bytes()
    except OSError as error:
        raise BrokenFolder(f"{path}: cannot be read: {error.strerror}; a universal file") from error
    sets, at = [], 0
    try:
        while at < len(data):
            text, at = _line(data, at)
            if text.strip() != "-1":
                continue
            head, at = _line(data, at)
            if head.strip() == "58" or head.strip().startswith("58b"):
                one, at = _read_one(data, at, head)
                sets.append(one)
            else:
                at = _skip(data, at)
    except (ValueError, IndexError) as error:
        raise BrokenFolder(f"{path}: data set {len(sets) + 1} of type 58 is damaged: {error}") \
            from error
    return sets


def _line(data: bytes, at: int) -> tuple[str, int]:
    """The line at a place, empty behind the end, and where the next one begins."""
    end = data.find(b"\n", at)
    end = len(data) if end < 0 else end
    return data[at:end].decode("latin-1").rstrip("\r"), end + 1


def _skip(data: bytes, at: int) -> int:
    while at < len(data):
        text, at = _line(data, at)
        if text.strip() == "-1":
            break
    return at


def _read_one(data: bytes, at: int, head: str) -> tuple[DataSet, int]:
    lines = []
    for _ in range(11):
        if at >= len(data):
            raise ValueError("its records 1 to 11 are not all there")
        text, at = _line(data, at)
        lines.append(text)
    one = _header(lines)
    count, kind, even = one["num_pts"], one["ord_data_type"], one["abscissa_spacing"] == 1
    per_point = (2 if kind in (5, 6) else 1) + (0 if even else 1)
    if head.strip().startswith("58b"):
        values, at = _binary(data, at, one, "<" if int(head[7:13]) == 1 else ">")
    else:
        numbers: list[float] = []
        while at < len(data):
            text, at = _line(data, at)
            if text.strip() == "-1":
                break
            numbers.extend(_numbers(text, kind, even, len(numbers) % per_point))
        values = np.array(numbers)
    if values.size != count * per_point:
        raise ValueError(f"it has {values.size} numbers, not {count * per_point}")
    if head.strip().startswith("58b"):
        at = _skip(data, at)
    rows = values.reshape(count, per_point)
    one["x"] = one["abscissa_min"] + one["abscissa_inc"] * np.arange(count) if even else rows[:, 0]
    rows = rows if even else rows[:, 1:]
    one["data"] = rows[:, 0] + 1j * rows[:, 1] if kind in (5, 6) else rows[:, 0]
    return one, at


def _header(lines: list[str]) -> DataSet:
    one: DataSet = {"type": 58, **{f"id{k + 1}": lines[k].rstrip() for k in range(5)}}
    dof, form = lines[5].ljust(80), lines[6].ljust(80)
    one.update(func_type=int(dof[0:5]), func_id=_whole(dof[5:15]), ver_num=_whole(dof[15:20]),
               load_case_id=_whole(dof[20:30]), rsp_ent_name=dof[31:41].strip(),
               rsp_node=_whole(dof[41:51]), rsp_dir=_whole(dof[51:55]),
               ref_ent_name=dof[56:66].strip(), ref_node=_whole(dof[66:76]),
               ref_dir=_whole(dof[76:80]), ord_data_type=int(form[0:10]),
               num_pts=int(form[10:20]), abscissa_spacing=int(form[20:30]),
               abscissa_min=_real(form[30:43]), abscissa_inc=_real(form[43:56]),
               z_axis_value=_real(form[56:69]))
    for name, text in zip(AXES, (line.ljust(67) for line in lines[7:11])):
        one.update({f"{name}_spec_data_type": _whole(text[0:10]),
                    f"{name}_len_unit_exp": _whole(text[10:15]),
                    f"{name}_force_unit_exp": _whole(text[15:20]),
                    f"{name}_temp_unit_exp": _whole(text[20:25]),
                    f"{name}_axis_lab": text[26:46].strip(),
                    f"{name}_axis_units_lab": text[47:67].strip()})
    return one


def _whole(field: str) -> int:
    return int(field) if field.strip() else 0


def _real(field: str) -> float:
    return float(field) if field.strip() else 0.0


def _numbers(text: str, kind: int, even: bool, place: int) -> list[float]:
    """A line of 6E13.5, 4E20.12 or, uneven and double, E13.5 with E20.12 behind it."""
    values: list[float] = []
    double, at = kind in (4, 6), 0
    parts = (2 if kind in (5, 6) else 1) + (0 if even else 1)
    text = text.rstrip()
    while at < len(text):
        width = 13 if not double or (not even and (place + len(values)) % parts == 0) else 20
        values.append(float(text[at:at + width]))
        at += width
    return values


def _binary(data: bytes, at: int, one: DataSet, order: str) -> tuple[Any, int]:
    """The numbers, and where they end. An uneven abscissa is single by the standard, of some
    writers (pyuff among them) double; the closing -1 tells, as the stated number of bytes may be
    wrong."""
    kind, count = one["ord_data_type"], one["num_pts"]
    ordinate = "f4" if kind in (2, 5) else "f8"
    ordinates = [(f"y{k}", order + ordinate) for k in range(2 if kind in (5, 6) else 1)]
    for abscissa in [""] if one["abscissa_spacing"] == 1 else ["f4", ordinate]:
        row = np.dtype(([("x", order + abscissa)] if abscissa else []) + ordinates)
        end = at + count * row.itemsize
        if end <= len(data) and re.match(rb"\s*(-1|$)", data[end:end + 16]):
            rows = np.frombuffer(data[at:end], row)
            return np.column_stack([rows[n].astype(float) for n in row.names or ()]).ravel(), end
    raise ValueError(f"behind its header there are not {count} numbers, then -1")
