"""pyuff: `pyuff.UFF("x.uff").write_sets(to_pyuff(frf))`, `from_pyuff(pyuff.UFF(f).read_sets())`.

A response is a data set 58 (dict); sensors are nodes from 1 in the order in which they come, and
their names stand as entities (ten letters, as the format has them).
"""
from __future__ import annotations

from typing import Any, Sequence

import numpy as np

from ..frf import AXES, Frf, axis_of

RESPONSE, TRANSMISSIBILITY = 4, 5  # function types; pyuff writes no 5, units tell the second
QUANTITIES = {8: "m", 11: "m/s", 12: "m/s2", 13: "N"}  # specific data types


def to_pyuff(frf: Frf) -> list[dict[str, Any]]:
    """One data set 58 an output and input, complex and double, uneven unless the lines are even."""
    sensors = list(dict.fromkeys(axis_of(c)[0] for c in frf.outputs))
    steps = np.diff(frf.frequency)
    even = len(steps) > 0 and bool(np.ptp(steps) < 1e-9 * frf.frequency[-1])
    top, _, bottom = (frf.unit or "m/s2 per N").partition(" per ")
    codes = {unit: code for code, unit in QUANTITIES.items()}
    sets = []
    for i, output in enumerate(frf.outputs):
        for j, driven in enumerate(frf.inputs):
            one: dict[str, Any] = {
                "type": 58, "binary": 0, "id1": f"{output} by {driven}",
                "func_type": RESPONSE, "ord_data_type": 6, "num_pts": len(frf.frequency),
                "abscissa_spacing": 1 if even else 0, "abscissa_min": float(frf.frequency[0]),
                "abscissa_inc": float(steps[0]) if even else 0.0, "z_axis_value": 0.0,
                "abscissa_spec_data_type": 18, "abscissa_axis_lab": "Frequency",
                "abscissa_axis_units_lab": "Hz", "ordinate_spec_data_type": codes.get(top, 0),
                "ordinate_axis_units_lab": top, "orddenom_spec_data_type": codes.get(bottom, 0),
                "orddenom_axis_units_lab": bottom, "x": frf.frequency.copy(),
                "data": frf.H[:, i, j].copy()}
            for key, channel in (("rsp", output), ("ref", driven)):
                name, axis = axis_of(channel)
                one.update({f"{key}_ent_name": name[:10], f"{key}_dir": AXES.index(axis) + 1
                            if axis else 0,
                            f"{key}_node": sensors.index(name) + 1 if name in sensors else 0})
            sets.append(one)
    return sets


def from_pyuff(sets: Sequence[dict[str, Any]]) -> list[Frf]:
    """Frequency responses among data sets; those of the same lines and unit in one Frf.

    ValueError where of one Frf a response is missing or there twice.
    """
    groups: dict[Any, list[dict[str, Any]]] = {}
    for one in sets:
        if one.get("type") in (58, "58", "58b") \
                and int(one["func_type"]) in (RESPONSE, TRANSMISSIBILITY):
            x = np.asarray(one["x"], dtype=float)
            groups.setdefault((x.tobytes(), _unit(one)), []).append(one)
    return [_joined(group) for group in groups.values()]


def _unit(one: dict[str, Any]) -> str:
    parts = [str(one.get(f"{k}_axis_units_lab") or "").strip() for k in ("ordinate", "orddenom")]
    kinds = [QUANTITIES.get(int(one.get(f"{k}_spec_data_type", 0)), "")
             for k in ("ordinate", "orddenom")]
    named = [p if p and p != "NONE" else k for p, k in zip(parts, kinds)]
    return " per ".join(named) if all(named) else named[0]


def _channel(one: dict[str, Any], key: str) -> str:
    name = str(one.get(f"{key}_ent_name") or "").strip()
    name = f"node{one.get(f'{key}_node', 0)}" if name in ("", "NONE") else name
    direction = int(one.get(f"{key}_dir", 0))
    axis = AXES[abs(direction) - 1] if direction else ""
    return ("-" if direction < 0 else "") + (f"{name}.{axis}" if axis else name)


def _joined(group: list[dict[str, Any]]) -> Frf:
    found = {(_channel(one, "rsp"), _channel(one, "ref")): one for one in group}
    outputs = tuple(dict.fromkeys(o for o, _ in found))
    inputs = tuple(dict.fromkeys(i for _, i in found))
    if len(found) != len(group) or len(found) != len(outputs) * len(inputs):
        raise ValueError(f"{len(group)} responses of {len(outputs)} outputs by {len(inputs)} "
                         "inputs: one of each pair")
    H = np.array([[found[o, i]["data"] for i in inputs] for o in outputs], dtype=complex)
    return Frf(np.asarray(group[0]["x"], dtype=float), H.transpose(2, 0, 1), outputs, inputs,
               _unit(group[0]))
