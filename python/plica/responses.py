"""Computed responses: the tables `response_*.csv`, `motion_*.csv` and `random_*.csv` of a run."""
from __future__ import annotations

from typing import Any, Iterator, Mapping

from .errors import MissingData
from .folder import Folder
from .frf import Frf, axis_of, of_table, stack
from .guard import ANEW
from .optional import need


class Response:
    """The response of all sensors to one excitation. Its numbers are read when asked for.

    `source`: "base", "motion" (of ends), "force" or "together" (several at once); `name`: "y", or
    the name of the force; `level`: amplitude of the excitation; `peaks`: a list of dicts, as in
    results.json.
    """

    def __init__(self, folder: Folder, entry: Mapping[str, Any]) -> None:
        self._folder = folder
        kinds = ("base", "motion", "force", "together")
        self.source = next((kind for kind in kinds if entry.get(kind)), "base")
        self.name = str(entry.get(self.source))
        self.key = str(entry["file"])[len("response_"):-len(".csv")]
        self.level = entry.get("level")
        self.peaks: list[dict[str, Any]] = list(entry.get("peaks", []))
        self._files: dict[str, str] = {
            "response": str(entry["file"]), "motion": str(entry["motion_file"]),
            "random": str((entry.get("random") or {}).get("file") or "")}

    def __repr__(self) -> str:
        return f"<response to {self.source} {self.name}, {len(self.peaks)} peaks>"

    @property
    def frf(self) -> Frf:
        """Acceleration of every sensor per excitation, one input: `base.y`, `force.tap`."""
        return of_table(self._folder.table(self._files["response"]), f"{self.source}.{self.name}",
                        "", self.level, f"; {ANEW}")

    @property
    def array(self) -> Any:
        """As xarray.DataArray (frequency, channel), complex, with coords sensor and direction."""
        frf = self.frf
        pairs = [axis_of(channel) for channel in frf.outputs]
        array = need("xarray", "a DataArray").DataArray(
            frf.H[:, :, 0], dims=("frequency", "channel"), name=self.key,
            coords={"frequency": frf.frequency, "channel": list(frf.outputs),
                    "sensor": ("channel", [p[0] for p in pairs]),
                    "direction": ("channel", [p[1] for p in pairs])},
            attrs={"units": frf.unit, "level": self.level, "source": self.source,
                   "excitation": self.name})
        array.frequency.attrs["units"] = "Hz"
        return array

    @property
    def motion(self) -> Any:
        """DataFrame: acceleration, velocity and displacement of every channel at the level."""
        return self._folder.table(self._files["motion"]).frame()

    @property
    def random(self) -> Any:
        """DataFrame: power spectral densities; MissingData where none was asked for."""
        if not self._files["random"]:
            raise MissingData(f"{self._folder.path}: no random response to {self.key}; "
                              "analyses.response.random in the case")
        return self._folder.table(self._files["random"]).frame()


class Responses(Mapping[str, Response]):
    """All responses of a run, by the name of their files: "y", "x", "force_tap"."""

    def __init__(self, folder: Folder, entries: list[dict[str, Any]]) -> None:
        self._all = {r.key: r for r in (Response(folder, entry) for entry in entries)}
        self._folder = folder

    def __repr__(self) -> str:
        return f"<responses {', '.join(self._all)}>"

    def __getitem__(self, key: str) -> Response:
        if key not in self._all:
            known = ", ".join(self._all) or "none: analyses.response in the case"
            raise MissingData(f"{self._folder.path}: no response to '{key}'; {known}")
        return self._all[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._all)

    def frf(self, *keys: str) -> Frf:
        """Several excitations as the inputs of one Frf, those of `keys` or all, for matrices of
        responses; ValueError where they differ in lines or unit (motions and forces)."""
        return stack([self[key].frf for key in keys or self._all])

    def __len__(self) -> int:
        return len(self._all)
