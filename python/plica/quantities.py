"""Numbers with a unit as files have them ("54.9 kN/m"), in SI. The units are those of the program
(a test holds them against its table); what is no number with a known unit stays as it is."""
from __future__ import annotations

import re
from typing import Any

SI: dict[str, tuple[str, float]] = {  # unit: that of SI, and how many of it
    "%": ("", 0.01), "m": ("m", 1), "mm": ("m", 1e-3), "cm": ("m", 1e-2), "um": ("m", 1e-6),
    "rad": ("rad", 1), "deg": ("rad", 0.017453292519943295), "kg": ("kg", 1), "t": ("kg", 1e3),
    "kg m2": ("kg m2", 1), "kg mm2": ("kg m2", 1e-6), "kg cm2": ("kg m2", 1e-4), "Pa": ("Pa", 1),
    "kPa": ("Pa", 1e3), "MPa": ("Pa", 1e6), "GPa": ("Pa", 1e9), "N/mm2": ("Pa", 1e6),
    "bar": ("Pa", 1e5), "mbar": ("Pa", 1e2), "N": ("N", 1), "kN": ("N", 1e3), "MN": ("N", 1e6),
    "Nm": ("Nm", 1), "N m": ("Nm", 1), "Nmm": ("Nm", 1e-3), "N mm": ("Nm", 1e-3),
    "kNm": ("Nm", 1e3), "N/m": ("N/m", 1), "kN/m": ("N/m", 1e3), "MN/m": ("N/m", 1e6),
    "N/mm": ("N/m", 1e3), "kN/mm": ("N/m", 1e6), "Nm/rad": ("Nm/rad", 1),
    "kNm/rad": ("Nm/rad", 1e3), "Nm/deg": ("Nm/rad", 57.29577951308232), "s": ("s", 1),
    "ms": ("s", 1e-3), "min": ("s", 60), "h": ("s", 3600), "Hz": ("Hz", 1), "kHz": ("Hz", 1e3),
    "m/s2": ("m/s2", 1), "mm/s2": ("m/s2", 1e-3), "(m/s2)2/Hz": ("(m/s2)2/Hz", 1),
    "g2/Hz": ("(m/s2)2/Hz", 9.80665 ** 2), "degC": ("degC", 1), "C": ("degC", 1),
}
GRAM, GRAVITY = ("kg", 1e-3), ("m/s2", 9.80665)


def si(value: Any, key: str = "") -> tuple[Any, str | None]:
    """(54900.0, "N/m") of "54.9 kN/m"; lists item by item. The unit is None where none is given,
    then the value is as it was. `key`: g is a gram under "mass", else the acceleration."""
    if isinstance(value, list):
        found = [si(item, key) for item in value]
        units = {unit for _, unit in found if unit is not None}
        return [item for item, _ in found], units.pop() if len(units) == 1 else None
    parts = re.fullmatch(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(\S(?:.*\S)?)\s*",
                         value) if isinstance(value, str) else None
    if not parts:
        return value, None
    entry = SI.get(parts[2])
    if parts[2] == "g":
        entry = GRAM if key == "mass" else GRAVITY
    return (float(parts[1]) * entry[1], entry[0]) if entry else (value, None)
