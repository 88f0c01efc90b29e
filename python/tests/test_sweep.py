"""Sweeps: what comes out, what fails, what is not run again."""
import json
import shutil

import numpy as np
import pytest
from conftest import CASES

import plica

MASSES = [0.1, 0.2, 0.4]
DEPTHS = ["5 mm", "6 mm"]
GRID = {"parts.tip.mass": MASSES, "parts.beam.section.depth": DEPTHS}


def test_headlines_are_those_of_single_runs(tmp_path):
    table = plica.sweep(CASES / "beam.yaml", GRID, tmp_path / "s")
    assert len(table) == 6 and (table["error"] == "").all()
    assert list(table["parts.tip.mass"][:2]) == [0.1, 0.1]
    alone = plica.sweep(CASES / "beam.yaml", GRID, tmp_path / "t",
                        collect=lambda r: {"f": r.modes["frequency"][1], "m": r.headline["mass"]})
    np.testing.assert_allclose(alone["f"], table["f_transverse"], rtol=1e-9)
    np.testing.assert_allclose(alone["m"], table["mass"], rtol=1e-12)


def test_a_row_that_fails_says_why_and_the_others_are_there(tmp_path):
    rows = [{"parts.tip.mass": m} for m in (0.1, -1, "3 mm", 0.2)] + [{"parts.tap.mass": 1}]
    for collect in (None, lambda r: {"mass": r.headline["mass"]}):
        table = plica.sweep(CASES / "beam.yaml", rows, tmp_path / str(collect), collect=collect)
        assert list(table["mass"].notna()) == [True, False, False, True, False]
        assert "out of range" in table["error"][1] and "mass" in table["error"][2]
        assert "tap" in table["error"][4]


def test_a_case_that_is_wrong_itself_is_an_error(tmp_path):
    case = plica.Case(CASES / "beam.yaml")
    case["materials.steel.nu"] = 3
    with pytest.raises(plica.CaseError, match="materials.steel.nu"):
        plica.sweep(case, GRID, tmp_path / "s")


def test_what_was_run_is_not_run_again(tmp_path):
    first = plica.sweep(CASES / "beam.yaml", GRID, tmp_path / "s", workers=1)
    stamps = {p: p.stat().st_mtime_ns for p in tmp_path.glob("s/*/results.json")}
    again = plica.sweep(CASES / "beam.yaml", GRID, tmp_path / "s", workers=1)
    assert again.equals(first)
    assert stamps == {p: p.stat().st_mtime_ns for p in tmp_path.glob("s/*/results.json")}


def test_a_sweep_that_was_stopped_goes_on(tmp_path):
    first = plica.sweep(CASES / "beam.yaml", GRID, tmp_path / "s", workers=1)
    [file] = tmp_path.glob("s/*/results.json")
    data = json.loads(file.read_text())
    del data["variants"][3:]  # as Ctrl-C leaves it
    data["warnings"].append("stopped by Ctrl-C")
    shutil.rmtree(file.parent)
    file.parent.mkdir()
    file.write_text(json.dumps(data))
    with pytest.raises(plica.CaseError, match="results.json"):  # the file is not the program's own
        plica.sweep(CASES / "beam.yaml", GRID, tmp_path / "s", workers=1)
    file.unlink()
    assert plica.sweep(CASES / "beam.yaml", GRID, tmp_path / "s", workers=1).equals(first)


def test_runs_over_a_table_with_a_model_of_its_own(tmp_path):
    case = plica.Case(CASES / "beam.yaml")
    case["models"] = {"heavy": {"set": {"parts.tip.mass": 2}}}
    frame = plica.sweep(case, [{"parts.beam.section.depth": d} for d in DEPTHS], tmp_path,
                        model="heavy", progress=True)
    assert frame["mass"].min() > 2
    light = plica.sweep(case, [{"parts.beam.section.depth": d} for d in DEPTHS], tmp_path,
                        collect=lambda r: {"mass": r.headline["mass"]})
    assert light["mass"].max() < 2  # another run than that of the model
