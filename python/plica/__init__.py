"""Plica in Python: results read, commands run, data exchanged, plots with the report's look.

    import plica
    r = plica.results("out/bellow_a2")
    r.modes, r.responses["y"].array, r.diagnosis.ledger
    r.plot()

    case = plica.Case("a.yaml")
    case["parts.bellows.profile[1].height"] = "8.5 mm"
    r = case.run(threads=2)

Files and the command line alone: no server, no text of the console. SI throughout.
"""
from . import exchange
from .case import Case
from .collect import collect
from .commands import (Check, check, compare, diagnose, ejma, fit, identify, init, reduce, run,
                       schema, stiffness, write_deck)
from .diagnosis import Diagnosis
from .errors import (BrokenFolder, CaseError, MissingData, MissingPackage, NoExecutable,
                     NumericalVerdict, OptionError, PlicaError, Problem, ProgramFailed, TooLarge,
                     VersionError)
from .frf import Frf
from .measured import Measured, read_measured
from .measured_writer import measured
from .mesh import Mesh
from .program import executable, options, use
from .results import Results, results
from .signals import Signals
from .superelement import Superelement
from .superelement_files import read_superelement
from .sweep import sweep
from .tables import read_csv
from .version import __version__

__all__ = [
    "BrokenFolder", "Case", "CaseError", "Check", "Diagnosis", "Frf", "Measured", "Mesh",
    "MissingData", "MissingPackage", "NoExecutable", "NumericalVerdict", "OptionError",
    "PlicaError", "Problem", "ProgramFailed", "Results", "Signals", "Superelement", "TooLarge",
    "VersionError", "__version__", "check", "collect", "compare", "diagnose", "ejma", "exchange",
    "executable", "fit", "identify", "init", "measured", "options", "read_csv", "read_measured",
    "read_superelement", "reduce", "results", "run", "schema", "stiffness", "sweep", "use",
    "write_deck",
]
