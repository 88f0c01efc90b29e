"""Packages that are used where present; numpy alone is required."""
from __future__ import annotations

import importlib
from typing import Any

from .errors import MissingPackage

DEBIAN = {
    "pandas": "python3-pandas",
    "xarray": "python3-xarray",
    "h5py": "python3-h5py",
    "scipy.sparse": "python3-scipy",
    "matplotlib": "python3-matplotlib",
    "meshio": "python3-meshio",
    "yaml": "python3-yaml",
    "tqdm": "python3-tqdm",
}


def need(name: str, what: str) -> Any:
    """The module `name`; MissingPackage says that `what` needs it and how it is installed."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        top = name.split(".")[0]
        debian = DEBIAN.get(name) or DEBIAN.get(top)
        how = f"apt install {debian}, or pip install {top}" if debian else f"pip install {top}"
        raise MissingPackage(f"{what} needs the package {top}, which is not here ({error}); {how}",
                             name=top) from error


def have(name: str) -> bool:
    """Is the module `name` installed?"""
    try:
        importlib.import_module(name)
    except ImportError:
        return False
    return True
