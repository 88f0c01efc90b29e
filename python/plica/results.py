"""A folder of results as one object: `plica.results("out/bellow_a2")`.

Nothing is read before it is asked for; what was read is kept. Every number is in SI, its unit in
`attrs["units"]` of a DataFrame or in `attrs` of a DataArray.
"""
from __future__ import annotations

import warnings
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Mapping

import numpy as np
import numpy.typing as npt

from .collect import unit_of
from .documents import Correlation, Fit, Identification, frame_of
from .diagnosis import Diagnosis
from .dynamic_stiffness import DynamicStiffness, read_stiffness
from .errors import BrokenFolder, MissingData
from .folder import Folder
from .guard import reads
from .levels import Levels
from .life import Life, Tables
from .mesh import Mesh
from .measured import Measured, read_measured
from .responses import Responses
from .states import frame_of_states
from .static import StaticStiffness
from .superelement import Superelement
from .superelement_files import read_superelement
from .vtu import mode_of, read_vtu
from .written import fingerprint

if TYPE_CHECKING:
    from .plot import Plots

Array = npt.NDArray[Any]
MASSES = ("x", "y", "z", "rx", "ry", "rz")
MODE_UNITS = {"frequency": "Hz", "damping": "fraction of critical", "mesh_error": "Hz",
              **{f"effective_mass_{axis}": "kg" if len(axis) == 1 else "kg m2" for axis in MASSES}}
RUN_KEYS = ("case", "headline", "modes", "verification", "static", "responses")  # every run has


class Headline(dict[str, float]):
    """Headline numbers by name; their units likewise in `units`."""

    @property
    def units(self) -> dict[str, str]:
        """Of those that have one, SI."""
        return {name: unit for name in self if (unit := unit_of(name))}


@reads("results.json")
class Results:
    """What commands wrote into `path`; BrokenFolder where that is no folder of results."""

    def __init__(self, path: str | Path) -> None:
        self.folder = Folder(path)
        self.path = self.folder.path

    def __repr__(self) -> str:
        return f"<results {self.path}: {', '.join(self.folder.tables()) or 'no tables'}>"

    @property
    def data(self) -> dict[str, Any]:
        """results.json as it is."""
        return self.folder.document("results.json")

    @property
    def _run(self) -> dict[str, Any]:
        """results.json; BrokenFolder where it lacks what every run has."""
        lacks = [key for key in RUN_KEYS if key not in self.data]
        if lacks:
            raise BrokenFolder(f"{self.path / 'results.json'}: has no '{lacks[0]}'; run the "
                               "command anew")
        return self.data

    @property
    def case(self) -> str:
        """The name of the case."""
        return str(self.data["case"])

    @property
    def headline(self) -> Headline:
        """The headline numbers by name, SI, a dict with `units`."""
        return Headline(self._run["headline"])

    @cached_property
    def modes(self) -> Any:
        """DataFrame, one mode a row from 1: frequency, damping, shape, effective masses, ..."""
        rows = []
        for mode in self._run["modes"]:
            row = {k: v for k, v in mode.items() if k not in ("effective_mass", "mesh_error")}
            row.update(zip((f"effective_mass_{a}" for a in MASSES), mode["effective_mass"]))
            errors = [v for v in (mode.get("mesh_error") or {}).values() if v is not None]
            row["mesh_error"] = sum(errors) if errors else np.nan
            rows.append(row)
        frame = frame_of(rows, MODE_UNITS)
        frame.insert(0, "mode", np.arange(1, len(rows) + 1))
        return frame.set_index("mode")

    @property
    def static(self) -> StaticStiffness:
        """Stiffness between the caps; MissingData where the case asks for none."""
        return StaticStiffness.of(self._run, self.path)

    @property
    def proved(self) -> bool:
        """Was it proved that no mode is missing?"""
        return bool(self._run["verification"]["made"] and self._run["verification"]["passed"])

    @cached_property
    def responses(self) -> Responses:
        """Responses by the name of their files: "y", "force_tap"."""
        return Responses(self.folder, self._run["responses"])

    @cached_property
    def stress(self) -> Any:
        """DataFrame: the largest stress of each kind and where it is."""
        return self._asked("stress", "analyses.stress")

    @cached_property
    def levels(self) -> Levels:
        """Responses over the level of excitation; MissingData where none were computed."""
        return Levels(self.folder, self._run.get("levels"))

    @property
    def stress_places(self) -> Any:
        """DataFrame: stress by load case, place, face and ply."""
        return self._asked("stress_places", "analyses.stress")

    @property
    def stress_meridian(self) -> Any:
        """DataFrame: stress along the meridian of every bellows."""
        return self._asked("stress_meridian", "analyses.stress")

    @cached_property
    def life(self) -> Life:
        """Duties, damage, hot spots; MissingData where no life was asked for."""
        return Life(self.folder, self._run.get("life"))

    @property
    def error_bars(self) -> Any:
        """DataFrame: what mesh and tolerances make of the headline numbers."""
        return self._asked("error_bars", "analyses.error_bars")

    @property
    def complex_modes(self) -> Any:
        """DataFrame: modes with dashpots and coupled loss factors, complex shapes at sensors."""
        return self._asked("complex_modes", "a damped mount or joint, or damping.coupled")

    @property
    def transients(self) -> Mapping[str, Any]:
        """DataFrames by name: motion of the sensors over time."""
        return self._tables("transients", "file", "analyses.transients")

    @property
    def shocks(self) -> Mapping[str, Any]:
        """DataFrames by name of the transient: shock response spectra."""
        return self._tables("transients", "shock_file", "analyses.transients[].spectrum")

    @property
    def run_ups(self) -> Mapping[str, Any]:
        """DataFrames by name: orders of an engine over its speed, steady at each."""
        return self._tables("run_ups", "file", "analyses.run_ups")

    @property
    def run_ups_in_time(self) -> Mapping[str, Any]:
        """DataFrames by name: the same as the speed changes."""
        return self._tables("run_ups", "time_file", "analyses.run_ups[].table")

    @property
    def crossings(self) -> Any:
        """DataFrame: where orders cross modes."""
        return self._asked("crossings", "analyses.run_ups")

    @property
    def state(self) -> dict[str, Any]:
        """The state that all is around, as in results.json; empty at rest."""
        return dict(self._run.get("state") or {})

    @cached_property
    def states(self) -> Any:
        """DataFrame: the states of the case beside the part at rest."""
        return frame_of_states(self.folder, self._run)

    def _tables(self, name: str, file: str, key: str) -> Mapping[str, Any]:
        return Tables(self.folder, {str(e["name"]): str(e[file])
                                    for e in self._run.get(name) or [] if e.get(file)}, key)

    def _asked(self, name: str, key: str) -> Any:
        if not self.folder.lists(name + ".csv"):
            raise MissingData(f"{self.path}: has no {name}.csv; {key} in the case"
                              + ("" if self.tables else ", run without only=\"json\""))
        return self.table(name)

    @property
    def comparison(self) -> Any:
        """DataFrame: computed beside measured."""
        return self.table("comparison")

    @property
    def variants(self) -> Any:
        """DataFrame: the headline numbers of the variants."""
        return self.table("variants")

    @cached_property
    def mesh(self) -> Mesh:
        """The mesh with the shapes of the modes as its fields."""
        return self.folder.read("modes.vtu", read_vtu)

    @cached_property
    def stress_mesh(self) -> Mesh:
        """The mesh with von Mises stresses [Pa] of both faces as its fields."""
        return self.folder.read("stress.vtu", read_vtu)

    @property
    def shapes(self) -> Array:
        """Shapes of the modes, (modes, nodes, 3), mass-normalised translations, 1/sqrt(kg)."""
        fields = [(mode_of(name), values) for name, values in self.mesh.point_data.items()]
        found = sorted((mode[0], i) for i, (mode, _) in enumerate(fields) if mode)
        return np.array([fields[i][1] for _, i in found]).reshape(
            len(found), len(self.mesh.points), 3)

    @cached_property
    def superelement(self) -> Superelement:
        """The superelement of `plica reduce`."""
        listed = [name for name in ("superelement.h5", "superelement.json")
                  if self.folder.lists(name)]
        for name in listed:
            self.folder.require(name)
        return self.folder.read(listed[0], lambda _: read_superelement(self.path)) if listed \
            else read_superelement(self.path)

    @property
    def certificate(self) -> dict[str, Any]:
        """certificate.json as it is."""
        return self.folder.document("certificate.json")

    @property
    def beam(self) -> Any:
        """DataFrame: the equivalent pipe of `plica reduce --beam` beside the shells (beam.csv)."""
        return self.table("beam")

    @cached_property
    def stiffness(self) -> DynamicStiffness:
        """The dynamic stiffness of `plica stiffness`."""
        return read_stiffness(self.folder)

    @property
    def ejma(self) -> Any:
        """DataFrame: the sheet of `plica ejma`, each row with its unit."""
        return self.table("ejma")

    @property
    def sweep(self) -> Any:
        """DataFrame: the table of `plica sweep`, one variant a row."""
        return self.table("sweep")

    @property
    def benchmark(self) -> Any:
        """DataFrame: what the run of a benchmark found beside its sources."""
        return self.table("benchmark")

    @cached_property
    def simulated(self) -> Measured:
        """The run in the form of measured data (simulated.yaml)."""
        return self.folder.read("simulated.yaml", read_measured)

    @cached_property
    def measured(self) -> Measured:
        """What was measured: of `plica identify` the test with its modes (measured.yaml), of a run
        the test that its case was held against, a warning where that was changed since.

        MissingData where there was none or it is not there any more; `comparison` has what it said
        of what was computed, and `plica.read_measured(FILE)` reads the file of a lab."""
        if self.folder.lists("measured.yaml"):
            return self.folder.read("measured.yaml", read_measured)
        if not self.folder.lists("results.json") or self._run["inputs"]["measured"] is None:
            raise MissingData(f"{self.path}: has no measured data; `measured` in the case, or "
                              "plica.read_measured(FILE) of those of a lab")
        test = self._run["inputs"]["measured"]
        path = (self.path / test["file"]).resolve()
        if not path.is_file():
            raise MissingData(f"{path}: is not there any more, which {self.path} was held against; "
                              "plica.read_measured(FILE) where it is now, or r.comparison")
        if test["fingerprint"] not in (None, fingerprint(path.read_bytes())):
            warnings.warn(f"{path}: was changed since {self.path} was held against it", UserWarning,
                          stacklevel=3)
        return read_measured(path)

    @cached_property
    def diagnosis(self) -> Diagnosis:
        """The diagnosis with its ledger."""
        return Diagnosis(self.folder)

    @property
    def pretest(self) -> dict[str, Any]:
        """What a planned test could tell (pretest.json, as it is)."""
        return self.folder.document("pretest.json")

    @property
    def supposed(self) -> dict[str, Any]:
        """What supposed effects would explain (supposed.json, as it is)."""
        return self.folder.document("supposed.json")

    @cached_property
    def correlation(self) -> Correlation:
        """What `plica compare` found."""
        return Correlation(self.folder)

    @cached_property
    def fit(self) -> Fit:
        """What `plica fit` found."""
        return Fit(self.folder)

    @cached_property
    def identification(self) -> Identification:
        """What `plica identify` found."""
        return Identification(self.folder)

    @property
    def sets(self) -> list[Results]:
        """Of `plica identify` with several sets: its folders 1, 2, ..., in order."""
        numbers = sorted(int(p.name) for p in self.path.iterdir() if p.name.isdigit())
        return [Results(self.path / str(k)) for k in numbers]

    def table(self, name: str) -> Any:
        """Any CSV table as DataFrame: `r.table("modes")`; names are in `r.tables`."""
        return self.folder.table(name).frame()

    @property
    def tables(self) -> list[str]:
        """Names of all CSV tables."""
        return self.folder.tables()

    @property
    def plot(self) -> Plots:
        """Plots with the look of the report: `r.plot()`, `r.plot.shape(1)`, `r.plot.ledger()`."""
        from .plot import Plots
        return Plots(self)

    def animate(self, mode: int = 1, **options: Any) -> Any:
        """A mode in motion, matplotlib.animation.FuncAnimation; see plica.plot.shape.animate."""
        from .plot.shape import animate
        return animate(self, mode, **options)


def results(path: str | Path) -> Results:
    """The results in a folder. BrokenFolder, VersionError where they cannot be read."""
    return Results(path)
