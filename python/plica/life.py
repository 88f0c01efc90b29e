"""The life of a part: what every duty costs, and where."""
from __future__ import annotations

from pathlib import Path
from typing import Any, Mapping

from .errors import MissingData
from .folder import Folder
from .guard import reads


@reads("results.json")
class Life:
    """What a case with `analyses.life` found; `data` as in results.json."""

    def __init__(self, folder: Folder, data: Mapping[str, Any] | None) -> None:
        if not data:
            raise MissingData(f"{folder.path}: no life; analyses.life in the case")
        self._folder, self.data = folder, dict(data)

    def __repr__(self) -> str:
        return f"<life by {self.curve}, damage {self.damage:.3g}>"

    @property
    def curve(self) -> str:
        """The curve of cycles, its source and factors."""
        return str(self.data["curve"])

    @property
    def damage(self) -> float:
        """Miner's sum of all duties at the hot spot, the place with the largest certain damage (see
        `bound` of `spots`); 0 where no place was looked at."""
        spots = self.data["spots"]
        return float(spots[0]["damage"]) if spots else 0.0

    @property
    def duties(self) -> Any:
        """DataFrame: every duty with its hot spot, range, life and damage."""
        return self._folder.table("life_duties").frame()

    @property
    def spots(self) -> Any:
        """DataFrame: the places and faces from the hot spot on, with the damage of each duty."""
        return self._folder.table("life").frame()

    @property
    def meridian(self) -> Any:
        """DataFrame: damage along the wall through the hot spot, on both faces."""
        return self._folder.table("life_meridian").frame()

    @property
    def densities(self) -> Mapping[str, Any]:
        """DataFrames by the name of a random duty: density of the stress at its hot spot."""
        return Tables(self._folder, {
            str(duty["name"]): str(duty["random"]["file"])
            for duty in self.data["duties"] if duty.get("random")}, "analyses.life.random")


class Tables(Mapping[str, Any]):
    """CSV files as DataFrames by a name; each is read when asked for. `key` of the case asks for
    them."""

    def __init__(self, folder: Folder, files: Mapping[str, str], key: str) -> None:
        self._folder, self._files, self._key = folder, dict(files), key

    def __repr__(self) -> str:
        return f"<tables {', '.join(self._files) or 'none'}>"

    def __getitem__(self, name: str) -> Any:
        if name not in self._files:
            known = ", ".join(self._files) or f"none: {self._key} in the case"
            raise MissingData(f"{self._folder.path}: there is no '{name}'; {known}")
        return self._folder.table(Path(self._files[name]).stem).frame()

    def __iter__(self) -> Any:
        return iter(self._files)

    def __len__(self) -> int:
        return len(self._files)
