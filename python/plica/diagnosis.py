"""What a diagnosis says: its verdict, the ledger of the gap, what it tried."""
from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from .documents import Document, frame_of
from .errors import VersionError
from .folder import Folder

WORDS = 2  # the version of the words of diagnosis.json that is read here


class Diagnosis(Document):
    """diagnosis.json; VersionError of other words than these."""

    file = "diagnosis.json"

    def __init__(self, folder: Folder) -> None:
        super().__init__(folder)
        if self.data.get("version") != WORDS:
            raise VersionError(f"{folder.path / self.file}: has words of version "
                               f"{self.data.get('version')}, this package reads {WORDS}; diagnose "
                               "the case anew")

    def __repr__(self) -> str:
        return f"<diagnosis of {self.data['case']}: {self.verdict}>"

    @property
    def verdict(self) -> str:
        """none, identified, ambiguous, several, mostly or unknown."""
        return str(self.data["verdict"])

    @property
    def headline(self) -> str:
        """The verdict in a sentence."""
        return str(self.data["headline"])

    @property
    def ledger(self) -> Any:
        """DataFrame: what the gap is made of; shares of it sum to 1.

        Columns: what, left (not an effect), effects, places, share, low, high (90 %), probability.
        attrs: gap, readings, explained.
        """
        ledger = self.data["ledger"]
        rows = []
        for row in ledger["rows"]:
            effects = row["effects"]
            rows.append({"what": row["what"], "left": row["left"],
                         "effects": " or ".join(e["name"] for e in effects),
                         "places": " or ".join(e["place"] for e in effects),
                         "share": row["share"], "low": row["interval"][0],
                         "high": row["interval"][1],
                         "probability": effects[0]["anywhere"] if len(effects) == 1 else np.nan})
        frame = frame_of(rows)
        frame.attrs.update({k: ledger[k] for k in ("gap", "readings", "explained")})
        return frame

    @property
    def effects(self) -> Any:
        """DataFrame: the named effects, one parameter a row, with value and 90 % interval, SI."""
        rows = [{"effect": e["name"], "place": e["place"], "way": e["way"],
                 "probability": e["probability"], "parameter": name, "value": value,
                 "low": e["interval"][name][0], "high": e["interval"][name][1],
                 "unit": e["unit"][name]}
                for e in self.data["effects"] for name, value in e["value"].items()]
        return frame_of(rows)

    @property
    def readings(self) -> Any:
        """DataFrame: every reading, measured, nominal and with the best hypothesis."""
        return frame_of(self.data["readings"])

    @property
    def where(self) -> Any:
        """DataFrame: where the gap lies, in standard deviations."""
        return frame_of(self.data["where"])

    @property
    def hypotheses(self) -> Any:
        """DataFrame: what was tried, with evidence and gap."""
        keep = [{k: v for k, v in h.items() if not isinstance(v, (list, dict))}
                for h in self.data["hypotheses"]]
        return frame_of(keep)

    @property
    def next_measurement(self) -> Any:
        """DataFrame: what to measure next, by the change of the ledger per hour."""
        return frame_of(self.data["next_measurement"])

    @property
    def gap(self) -> dict[str, Any]:
        """before, after, shrink, interval, readings; the same of what was held out."""
        return dict(self.data["gap"])

    @property
    def likeness(self) -> tuple[list[str], npt.NDArray[np.float64]]:
        """Names of effects and how alike what they do to the readings is, (effects, effects)."""
        part = self.data["identifiability"]
        return list(part["effects"]), np.array(part["likeness"], dtype=float)
