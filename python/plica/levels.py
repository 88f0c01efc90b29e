"""Responses over the level of excitation, of a case with friction."""
from __future__ import annotations

from typing import Any

from .documents import frame_of
from .errors import MissingData
from .folder import Folder
from .guard import reads


@reads("results.json")
class Levels:
    """Families of responses: `families` as in results.json, and their tables as DataFrames."""

    def __init__(self, folder: Folder, families: list[dict[str, Any]] | None) -> None:
        if not families:
            raise MissingData(f"{folder.path}: no responses over the level; analyses.levels in "
                              "the case")
        self._folder = folder
        self.families = families
        self._files = [str(family["file"]) for family in families]

    @property
    def names(self) -> list[str]:
        """One a family: "y", or the name of the force."""
        return [str(f["base"] or f["force"]) for f in self.families]

    @property
    def peaks(self) -> Any:
        """DataFrame: peaks of every level, sweep and channel."""
        return self._folder.table("level_peaks").frame()

    @property
    def joints(self) -> Any:
        """DataFrame: motion, its mean and energy per cycle of every joint."""
        return self._folder.table("level_joints").frame()

    @property
    def backbones(self) -> Any:
        """DataFrame: frequency and damping over the amplitude."""
        return self._folder.table("level_backbones").frame()

    def curves(self, name: str | None = None) -> Any:
        """DataFrame of a family, all its levels below each other; the first unless named."""
        return self._folder.table(self._files[0 if name is None else self._number(name)]).frame()

    def measured_like(self) -> Any:
        """DataFrame with the columns of `peaks` of a measured.yaml, first peak of a channel."""
        rows = []
        for family in self.families:
            for level in family["levels"]:
                seen = set()
                for peak in level["peaks_up"]:
                    channel = (peak["sensor"], peak["direction"])
                    if channel not in seen:
                        rows.append({"base": family["base"], "level": level["level"], **peak})
                    seen.add(channel)
        return frame_of(rows, {"frequency": "Hz", "damping": "fraction of critical"})

    def _number(self, name: str) -> int:
        if name not in self.names:
            raise MissingData(f"{self._folder.path}: no levels of '{name}'; "
                              f"{', '.join(self.names)}")
        return self.names.index(name)
