"""The version of this package, and which programs and files go with it."""
from __future__ import annotations

import re

from .errors import VersionError

__version__ = "0.1.0"


def parts(version: str) -> tuple[int, ...]:
    """(0, 1, 0) of "0.1.0"; VersionError for what is no version."""
    if not re.fullmatch(r"\d+(\.\d+)+", version):
        raise VersionError(f"'{version}' is no version; expected such as {__version__}")
    return tuple(int(part) for part in version.split("."))


def check(version: str | None, where: str) -> None:
    """VersionError unless the first two numbers are those of the package; None is not checked."""
    if version is None:
        return
    theirs, ours = parts(version)[:2], parts(__version__)[:2]
    if theirs != ours:
        raise VersionError(f"{where} is of Plica {version}, this package reads "
                           f"{ours[0]}.{ours[1]}; install package and program of one version")
