"""What the list of files in a folder says of each: whether it is as the program wrote it."""
from __future__ import annotations

import json
import warnings
from functools import lru_cache
from pathlib import Path
from typing import Any

from .errors import BrokenFolder

LIST = "plica_files.json"  # what the program wrote there, by which command and of which version
HASHED = 1 << 18  # bytes; of larger files the size alone is held against the list
OFFSET, PRIME, WORD = 0xcbf29ce484222325, 0x100000001b3, (1 << 64) - 1  # FNV-1a


def written(folder: Path) -> dict[str, Any]:
    """Entries by the name of a file; of a folder of `plica identify` below that of the test the
    list lies there. Empty where there is none."""
    folder = folder.absolute()
    for place, below in ((folder, ""), (folder.parent, f"{folder.name}/")):
        try:
            at = (place / LIST).stat()
        except OSError:
            continue
        files = _listed(place / LIST, at.st_mtime_ns, at.st_size, at.st_ino)
        return {name[len(below):]: entry for name, entry in files.items()
                if name.startswith(below)}
    return {}


@lru_cache(maxsize=16)
def _listed(path: Path, *_: int) -> dict[str, Any]:
    """Read anew where the file is another one."""
    try:
        files = json.loads(path.read_text(encoding="utf-8"))["files"]
        return {str(name): dict(entry) for name, entry in files.items()}
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise BrokenFolder(f"{path}: is damaged: {error}; run the command anew") from error


def fingerprint(content: bytes) -> str:
    """Size and FNV-1a hash, as they stand in the list."""
    value = OFFSET
    for byte in content:
        value = (value ^ byte) * PRIME & WORD
    return f"{len(content)}-{value:016x}"


def check_written(path: Path) -> None:
    """BrokenFolder where the file is smaller than it was written (cut); a warning where it was
    changed in another way, as by hand, or is YAML. A file that is not listed is not looked at."""
    prints = written(path.parent).get(path.name, {}).get("prints")
    try:
        size = path.stat().st_size
        sizes = [int(str(one).partition("-")[0]) for one in prints or []]
        if not sizes:
            return
        same = size in sizes and (size > HASHED or fingerprint(path.read_bytes()) in prints)
    except (OSError, ValueError, TypeError):
        return  # who reads it says so
    if size < min(sizes) and path.suffix != ".yaml":  # people go on writing those
        raise BrokenFolder(f"{path}: is damaged: it was changed since plica wrote it, has {size} "
                           f"bytes of {min(sizes)}; run the command anew")
    if not same:
        warnings.warn(f"{path}: was changed since plica wrote it", UserWarning, stacklevel=4)
