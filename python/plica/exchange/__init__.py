"""To and from the arrays and dicts of other packages. None of them needs to be installed.

| module | of |
|---|---|
| `pyuff` | data sets 58 as dicts (`plica.uff58` and `uff58_writer` read and write the files) |
| `pyfbs` | responses with tables of channels and impacts |
| `sdypy` | responses as (outputs, lines) or (outputs, inputs, lines); time signals by SEP 005 |
| `pynastran` | DMIG and OUTPUT4 matrices |
| `pyyeti` | DMIG tables, Craig-Bampton matrices with their b-set and its table of places |
"""
from . import pyfbs, pynastran, pyuff, pyyeti, sdypy

__all__ = ["pyfbs", "pynastran", "pyuff", "pyyeti", "sdypy"]
