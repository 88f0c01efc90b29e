"""What the tests share: the program, small cases, their results made once.

PLICA names the program, else it is looked for on PATH and in the build folder of the tree.
"""
import os
import shutil
import sys
from pathlib import Path

import matplotlib
import numpy as np
import pytest

import plica

matplotlib.use("agg")
HERE = Path(__file__).parent
TREE = HERE.parent.parent
CASES = HERE / "cases"
SHIPPED = TREE / "cases"


def program():
    built = TREE / "build" / "app" / "plica"
    return os.environ.get("PLICA") or shutil.which("plica") or (str(built) if built.is_file()
                                                                else None)


def transmissibility(f, f0, zeta):
    """Of one mass on a spring and a dashpot, over its base."""
    w, w0 = 2 * np.pi * f, 2 * np.pi * f0
    return (w0 ** 2 + 2j * zeta * w0 * w) / (w0 ** 2 - w ** 2 + 2j * zeta * w0 * w)


def shaken(f0, zeta, rate=1024.0, samples=65536):
    """Time signals of such a mass on a table that moves at random."""
    base = np.random.default_rng(5).normal(size=samples)
    spectrum = np.fft.rfft(base) * transmissibility(np.fft.rfftfreq(samples, 1 / rate), f0, zeta)
    return plica.Signals(rate, np.column_stack([base, np.fft.irfft(spectrum, samples)]),
                         ("base.y", "mid.y"), ("m/s2", "m/s2"),
                         {"base": "y", "reference": "base.y", "excitation": "random"})


@pytest.fixture(scope="session", autouse=True)
def executable():
    found = program()
    if found is None:
        pytest.skip("there is no program plica: set PLICA")
    plica.use(found)
    os.environ["PLICA"] = found
    return found


@pytest.fixture(scope="session")
def work(tmp_path_factory):
    return tmp_path_factory.mktemp("results")


@pytest.fixture(scope="session")
def beam(work):
    return plica.run(CASES / "beam.yaml", work / "beam", threads=1)


@pytest.fixture(scope="session")
def bellows(work):
    folder = work / "bellows"
    plica.run(CASES / "bellows.yaml", folder, threads=1)
    return plica.reduce(CASES / "bellows.yaml", folder, threads=1)


@pytest.fixture(scope="session")
def levels(work):
    return plica.run(CASES / "levels.yaml", work / "levels", threads=1)


@pytest.fixture(scope="session")
def lap(work):
    """The bolted lap, run, beside its test and diagnosed by what a joint does."""
    folder = work / "lap"
    plica.run(SHIPPED / "bolted_lap", folder, threads=1, no_error_bars=True)
    plica.compare(folder, SHIPPED / "bolted_lap" / "measured.yaml", folder)
    case = plica.Case(SHIPPED / "bolted_lap")
    case["diagnose"] = {"effects": ["joint_friction", "joint_stiffness"]}
    return plica.diagnose(case, folder, threads=1, no_plan=True)


@pytest.fixture(scope="session")
def identified(work):
    """The test of the bolted lap at four levels."""
    return plica.identify(SHIPPED / "bolted_lap" / "measured.yaml", work / "identified")


@pytest.fixture(scope="session")
def fitted(work):
    case = plica.Case(CASES / "beam.yaml")
    case["fit"] = {"parameters": [{"path": "parts.beam.section.depth",
                                   "bounds": ["1 mm", "20 mm"]}],
                   "targets": [{"quantity": "f_transverse = 30 Hz"}]}
    return case.fit(work / "fit", threads=1)


@pytest.fixture
def use(executable):
    """Another program for a test."""
    yield plica.use
    plica.use(executable)


@pytest.fixture
def fake(tmp_path):
    path = tmp_path / "plica"
    path.write_text(f"#!{sys.executable}\n" + (HERE / "fake_plica.py").read_text())
    path.chmod(0o755)
    return path
