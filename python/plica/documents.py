"""What `plica compare`, `plica fit` and `plica identify` found."""
from __future__ import annotations

from typing import Any, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from .errors import MissingData
from .folder import Folder
from .frf import Frf
from .guard import reads
from .optional import need
from .uff58 import read_uff58

Array = npt.NDArray[Any]


def frame_of(rows: Sequence[Mapping[str, Any]], units: Mapping[str, str] | None = None) -> Any:
    """pandas.DataFrame of dicts; units of the columns that are there in attrs["units"]."""
    frame = need("pandas", "a DataFrame").DataFrame(list(rows))
    frame.attrs["units"] = {k: v for k, v in (units or {}).items() if k in frame.columns}
    return frame


BY_UNIT = "that of the row"  # which has it in its column `unit`


@reads("")
class Document:
    """A JSON file of a folder of results; `data` is the file as it is."""

    file = ""

    def __init_subclass__(cls) -> None:
        reads("")(cls)

    def __init__(self, folder: Folder) -> None:
        self.folder = folder
        self.data = folder.document(self.file)

    @property
    def warnings(self) -> list[str]:
        """What the program warns of."""
        return list(self.data.get("warnings", []))


class Correlation(Document):
    """Simulation and test side by side (correlation.json)."""

    file = "correlation.json"

    @property
    def pairs(self) -> Any:
        """DataFrame: modes of test and simulation that belong together."""
        return frame_of(self.data["pairs"], {"frequency_measured": "Hz",
                                             "frequency_simulated": "Hz"})

    @property
    def numbers(self) -> Any:
        """DataFrame: mass and stiffnesses, each row with its unit."""
        return frame_of(self.data["numbers"], dict.fromkeys(
            ("simulated", "measured", "sigma"), BY_UNIT))

    @property
    def mac(self) -> Array:
        """Modal assurance criterion, (simulated, measured)."""
        return np.array(self.data["mac"], dtype=float)

    @property
    def comac(self) -> dict[str, float]:
        """COMAC by channel."""
        return dict(self.data["comac"])


class Fit(Document):
    """Numbers of a case adjusted to a test (fit.json)."""

    file = "fit.json"
    UNITS = dict.fromkeys(("measured", "sigma", "before", "after"), BY_UNIT)

    @property
    def parameters(self) -> Any:
        """DataFrame: path, unit, value before and after, standard deviation; a row has its unit."""
        return frame_of(self.data["parameters"], dict.fromkeys(
            ("before", "after", "sigma"), BY_UNIT) | {"known": "fraction"})

    @property
    def targets(self) -> Any:
        """DataFrame: what was to be met, before and after, each row with its unit."""
        return frame_of(self.data["targets"], self.UNITS)

    @property
    def aims(self) -> Any:
        """DataFrame: what was to be least or most, before and after, each row with its unit."""
        return frame_of(self.data["aims"], dict.fromkeys(("before", "after"), BY_UNIT))

    @property
    def constraints(self) -> Any:
        """DataFrame: constraints with the value they have, each row with its unit."""
        return frame_of(self.data["constraints"],
                        dict.fromkeys(("value", "min", "max"), BY_UNIT))

    @property
    def evaluations(self) -> int:
        """Runs of the model that it took."""
        return int(self.data["evaluations"])

    @property
    def values(self) -> dict[str, float]:
        """Fitted numbers by path, SI: `case.update(r.fit.values)`."""
        paths = {path: p["after"] for p in self.data["parameters"]
                 for path in [p["path"], *p["also"]]}
        return {**paths, **self.data["ties"]}

    @property
    def units(self) -> dict[str, str]:
        """Units of `values` by path; "" is a pure number."""
        paths = {path: p["unit"] for p in self.data["parameters"]
                 for path in [p["path"], *p["also"]]}
        return {**paths, **self.data["tie_units"]}

    @property
    def correlation(self) -> Array:
        """Correlation of the parameters, (parameters, parameters)."""
        return np.array(self.data["correlation"], dtype=float)


class Identification(Document):
    """Modes of measured responses (identification.json)."""

    file = "identification.json"

    @property
    def modes(self) -> Any:
        """DataFrame: frequency, damping, their standard deviations, share, collinearity."""
        keep = [{k: v for k, v in mode.items() if not isinstance(v, (list, dict))}
                for mode in self.data["modes"]]
        return frame_of(keep, {"frequency": "Hz", "sigma_frequency": "Hz",
                               "damping": "fraction of critical",
                               "sigma_damping": "fraction of critical"})

    @property
    def shapes(self) -> Array:
        """(modes, channels), complex, channels as `channels`."""
        return np.array([[c["real"] + 1j * c["imaginary"] for c in mode["shape"]]
                         for mode in self.data["modes"]], dtype=complex)

    @property
    def channels(self) -> list[str]:
        """Names of the responses."""
        return list(self.data["responses"])

    @property
    def frf(self) -> list[Frf]:
        """The measured responses of the band that was used (frf.uff)."""
        return self._responses("frf.uff")

    @property
    def synthesised(self) -> list[Frf]:
        """The same responses, made of the modes (synthesised.uff)."""
        return self._responses("synthesised.uff")

    def _responses(self, name: str) -> list[Frf]:
        from .exchange.pyuff import from_pyuff  # which needs this module
        return from_pyuff(self.folder.read(name, read_uff58))

    @property
    def spectra(self) -> Any:
        """DataFrame: spectra of output-only or noisy signals (spectra.csv)."""
        return self.folder.table("spectra").frame()

    @property
    def stabilisation(self) -> Any:
        """DataFrame: order, frequency, damping, stable; MissingData of a program without it."""
        if "stabilisation" not in self.data:
            raise MissingData(f"{self.folder.path / self.file}: has no stabilisation diagram; the "
                              "program that wrote it keeps it in identification.html alone")
        return frame_of(self.data["stabilisation"], {"frequency": "Hz"})
