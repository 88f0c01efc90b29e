"""Universal files written: data sets 58 (dicts as `uff58` reads them), ASCII."""
from __future__ import annotations

from pathlib import Path

import numpy as np

from .uff58 import AXES, DataSet


def write_uff58(path: str | Path, sets: list[DataSet]) -> None:
    """ASCII, in the precision that `ord_data_type` says; a new file (FileExistsError)."""
    with open(path, "x", encoding="latin-1") as file:
        file.write("".join(_text(one) for one in sets))


def _text(one: DataSet) -> str:
    def whole(key: str, width: int) -> str:
        return f"{int(one.get(key, 0)):{width}d}"

    def name(key: str, width: int) -> str:
        return f" {str(one.get(key, '') or 'NONE')[:width]:{width}}"
    lines = ["    -1", "    58"] + [str(one.get(f"id{k}", "") or "NONE")[:80] for k in range(1, 6)]
    lines.append(whole("func_type", 5) + whole("func_id", 10) + whole("ver_num", 5)
                 + whole("load_case_id", 10) + name("rsp_ent_name", 10) + whole("rsp_node", 10)
                 + whole("rsp_dir", 4) + name("ref_ent_name", 10) + whole("ref_node", 10)
                 + whole("ref_dir", 4))
    lines.append(whole("ord_data_type", 10) + f"{len(one['data']):10d}"
                 + whole("abscissa_spacing", 10)
                 + "".join(f"{float(one.get(key, 0)):13.5e}"
                           for key in ("abscissa_min", "abscissa_inc", "z_axis_value")))
    for axis in AXES:
        lines.append(whole(f"{axis}_spec_data_type", 10) + whole(f"{axis}_len_unit_exp", 5)
                     + whole(f"{axis}_force_unit_exp", 5) + whole(f"{axis}_temp_unit_exp", 5)
                     + name(f"{axis}_axis_lab", 20) + name(f"{axis}_axis_units_lab", 20))
    return "\n".join(lines + _ascii(one)) + "\n    -1\n"


def _ascii(one: DataSet) -> list[str]:
    data, even = np.asarray(one["data"]), int(one["abscissa_spacing"]) == 1
    double, complex_ = int(one["ord_data_type"]) in (4, 6), int(one["ord_data_type"]) in (5, 6)
    form = "{:20.12e}" if double else "{:13.5e}"
    per_line = (6 if not double else 4 if even or not complex_ else 3) \
        // ((2 if complex_ else 1) + (0 if even else 1))
    cells = []
    for x, value in zip(one["x"], data):
        cell = "" if even else f"{x:13.5e}"
        for part in ((value.real, value.imag) if complex_ else (value,)):
            cell += form.format(part)
        cells.append(cell)
    return ["".join(cells[k:k + per_line]) for k in range(0, len(cells), per_line)]
