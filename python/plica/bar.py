"""A bar of progress."""
from __future__ import annotations

import threading
import time
import warnings
from typing import Any

from .optional import have, need


def bars() -> bool:
    """Is tqdm here? A warning says so where it is not."""
    if not have("tqdm"):
        warnings.warn("no bar of progress: the package tqdm is not here; apt install python3-tqdm, "
                      "or pip install tqdm", stacklevel=2)
    return have("tqdm")


KNOWN = "{desc}: {percentage:3.0f}% |{bar}| {elapsed}{postfix}"
WIDTH = 10  # of the bar of a stage that does not say its share


class Bar:
    """A bar of tqdm where that is present, else a word that it is not.

    With a share it fills; without one a mark goes to and fro. Stage and time are always there.
    """

    def __init__(self, title: str, wanted: bool) -> None:
        self.bar: Any = None
        if wanted and bars():
            self.bar = need("tqdm.auto", "a bar").tqdm(
                total=1.0, desc=title, leave=False, bar_format=_unknown(0))
        self.share: float | None = None
        self.begun = self.shown = time.monotonic()
        self.lock = threading.Lock()

    def show(self, stage: str, share: Any) -> None:
        with self.lock:
            if self.bar is not None:
                self.bar.set_postfix_str(stage, refresh=False)
                self.share = None if share is None else float(share)
                self._fill()

    def _fill(self) -> None:
        self.bar.n = self.share or 0.0
        self.bar.bar_format = _unknown(int(5 * (time.monotonic() - self.begun))) \
            if self.share is None else KNOWN

    def tick(self) -> None:
        if self.bar is not None and time.monotonic() - self.shown > 0.2:
            with self.lock:
                self._fill()
                self.bar.refresh()
            self.shown = time.monotonic()

    def __enter__(self) -> Bar:
        return self

    def __exit__(self, *error: object) -> None:
        with self.lock:
            if self.bar is not None:
                self.bar.close()
                self.bar = None


def _unknown(step: int) -> str:
    at = abs((step + WIDTH - 1) % (2 * (WIDTH - 1)) - (WIDTH - 1))
    return "{desc}: |" + (" " * at + "#").ljust(WIDTH) + "| {elapsed}{postfix}"
