"""Sweeps: what comes out, what fails, what is not run again."""
import numpy as np
import pytest
from conftest import CASES

import plica
from plica import child

MASSES = [0.1, 0.2, 0.4]
DEPTHS = ["5 mm", "6 mm"]
GRID = {"parts.tip.mass": MASSES, "parts.beam.section.depth": DEPTHS}


def lines(folder):
    return (folder / "runs.jsonl").read_text().splitlines()


def test_headlines_are_those_of_single_runs(tmp_path):
    table = plica.sweep(CASES / "beam.yaml", GRID, tmp_path / "s")
    assert len(table) == 6 and (table["error"] == "").all()
    assert list(table["parts.tip.mass"][:2]) == [0.1, 0.1]
    assert table.attrs["units"]["f_transverse"] == "Hz"
    alone = plica.sweep(CASES / "beam.yaml", GRID, tmp_path / "t",
                        collect=lambda r: {"f": r.modes["frequency"][1], "m": r.headline["mass"]})
    np.testing.assert_allclose(alone["f"], table["f_transverse"], rtol=1e-9)
    np.testing.assert_allclose(alone["m"], table["mass"], rtol=1e-12)


def test_any_number_of_the_results(tmp_path):
    table = plica.sweep(CASES / "beam.yaml", GRID, tmp_path, workers=2, progress=True,
                        result=["modes[2].frequency", "modes[0].damping"])
    assert (table["modes[0].damping"] == 0.01).all()
    third = plica.Case(CASES / "beam.yaml").update({"parts.tip.mass": 0.4}).run(tmp_path / "r")
    at = table[(table["parts.tip.mass"] == 0.4) & (table["parts.beam.section.depth"] == "6 mm")]
    np.testing.assert_allclose(at["modes[2].frequency"], third.modes["frequency"][3], rtol=1e-9)


def test_a_row_that_fails_says_why_and_the_others_are_there(tmp_path):
    rows = [{"parts.tip.mass": m} for m in (0.1, -1, "3 mm", 0.2)] + [{"parts.tap.mass": 1}]
    for collect in (None, lambda r: {"mass": r.headline["mass"]}):
        table = plica.sweep(CASES / "beam.yaml", rows, tmp_path / str(collect), collect=collect)
        assert list(table["mass"].notna()) == [True, False, False, True, False]
        assert "out of range" in table["error"][1] and "mass" in table["error"][2]
        assert "tap" in table["error"][4]
    none = plica.sweep(CASES / "beam.yaml", [{"parts.tip.mass": -1}], tmp_path / "none")
    assert "out of range" in none["error"][0]


def test_that_every_row_failed_is_read_from_files_and_not_from_words(tmp_path, monkeypatch):
    wrong = [{"parts.tip.mass": -1}]
    real = child.call

    def other_words(*given):
        said = real(*given)
        said.failure = "none of them went well"
        return said
    monkeypatch.setattr(child, "call", other_words)
    for _ in range(2):  # run, and taken from what was run before
        assert "out of range" in plica.sweep(CASES / "beam.yaml", wrong, tmp_path)["error"][0]

    def nothing_written(*given):
        return child.Said(code=1, failure="plica: every variant failed, the first for: x")
    monkeypatch.setattr(child, "call", nothing_written)
    for folder in (tmp_path, tmp_path / "new"):  # the files of before do not count
        with pytest.raises(plica.CaseError, match="every variant failed"):
            plica.sweep(CASES / "beam.yaml", wrong, folder)


def test_what_varies_by_the_options_of_the_program(tmp_path):
    table = plica.sweep(CASES / "beam.yaml", None, tmp_path / "s", design="sobol", count=5,
                        vary=["parts.tip.mass=0.1kg:0.4kg", "parts.beam.section.depth=5mm:8mm"])
    assert len(table) == 5 and (table["status"] == "ok").all()
    assert table["parts.tip.mass"].between(0.1, 0.4).all()
    assert table.attrs["units"]["parts.beam.section.depth"] == "m"
    assert plica.Case(CASES / "beam.yaml").sweep({"parts.tip.mass": [0.1]}, tmp_path / "t")[
        "mass"][0] == pytest.approx(0.6652)
    with pytest.raises(plica.OptionError, match="collect goes with values"):
        plica.sweep(CASES / "beam.yaml", None, tmp_path / "s", collect=dict)


def test_a_case_that_is_wrong_itself_is_an_error(tmp_path):
    case = plica.Case(CASES / "beam.yaml")
    case["materials.steel.nu"] = 3
    with pytest.raises(plica.CaseError, match="materials.steel.nu"):
        plica.sweep(case, GRID, tmp_path / "s")
    with pytest.raises(plica.OptionError, match="jops"):
        plica.sweep(CASES / "beam.yaml", GRID, tmp_path / "s", jops=2)


def test_what_was_run_is_not_run_again_and_a_sweep_that_was_stopped_goes_on(tmp_path):
    first = plica.sweep(CASES / "beam.yaml", GRID, tmp_path, workers=1)
    before = lines(tmp_path)
    assert plica.sweep(CASES / "beam.yaml", GRID, tmp_path).equals(first)
    assert lines(tmp_path) == before
    (tmp_path / "runs.jsonl").write_text("\n".join(before[:4]) + "\n" + before[4][:20])
    assert plica.sweep(CASES / "beam.yaml", GRID, tmp_path).equals(first)
    heavier = plica.Case(CASES / "beam.yaml")
    heavier["parts.beam.section.width"] = "40 mm"
    assert (plica.sweep(heavier, GRID, tmp_path)["mass"] > first["mass"]).all()


def test_runs_over_a_table_with_a_model_of_its_own(tmp_path):
    case = plica.Case(CASES / "beam.yaml")
    case["models"] = {"heavy": {"set": {"parts.tip.mass": 2}}}
    rows = [{"parts.beam.section.depth": d} for d in DEPTHS]
    frame = plica.sweep(case, rows, tmp_path, model="heavy")
    assert frame["mass"].min() > 2
    light = plica.sweep(case, rows, tmp_path, set={"parts.tip.mass": 0.1})
    assert light["mass"].max() < 2  # another run than that of the model
