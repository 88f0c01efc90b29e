"""Reading: tables, units, versions, what is broken."""
import json
import shutil

import numpy as np
import pytest
from conftest import TREE

import plica


def test_modes_are_those_of_the_csv(bellows):
    modes, table = bellows.modes, bellows.table("modes")
    assert list(modes.index) == [1, 2, 3, 4]
    np.testing.assert_allclose(modes["frequency"], table["frequency"], rtol=1e-15)
    np.testing.assert_allclose(modes["effective_mass_y"], table["effective mass y"], atol=1e-12)
    assert modes.attrs["units"]["frequency"] == "Hz"
    assert table.attrs["units"]["effective inertia x"] == "kg m2"


def test_every_csv_is_a_table_without_options(bellows, levels, lap):
    for results in (bellows, levels, lap):
        for name in results.tables:
            frame = results.table(name)
            assert len(frame.columns) > 0 and "units" in frame.attrs
            assert len(set(frame.columns)) == len(frame.columns)
            assert not any(c.startswith("Unnamed") for c in frame.columns)


def test_headers_that_would_be_one_name_stay_whole(lap):
    pairs = plica.tables.named(["test", "test [Hz]", "f [Hz]", "parts.a[1].h", "x [%]", "x [g]"])
    assert pairs[0] == ["test", "test [Hz]", "f", "parts.a[1].h", "x [%]", "x [g]"]
    assert "deviation [%]" in lap.table("comparison")


def test_formulas_lose_the_apostrophe_of_the_spreadsheet(tmp_path):
    (tmp_path / "t.csv").write_text("a,b\n'=1+1,\n'tis,2\n")
    table = plica.read_csv(tmp_path / "t.csv")
    assert list(table["a"]) == ["=1+1", "'tis"] and np.isnan(table["b"][0])


def test_a_cut_table_is_broken(tmp_path):
    (tmp_path / "t.csv").write_text("a,b\nx,1\ny\n")
    with pytest.raises(plica.BrokenFolder, match=r"t.csv:3: has 1 cells; 2"):
        plica.read_csv(tmp_path / "t.csv")


def test_responses_are_complex_with_channels_and_units(bellows):
    array = bellows.responses["y"].array
    assert array.dims == ("frequency", "channel") and np.iscomplexobj(array.values)
    assert array.attrs["units"] == "m/s2 per m/s2" and array.attrs["level"] == 10
    y = array.sel(channel="mid.y")
    peak = bellows.responses["y"].peaks[0]
    near = abs(y.sel(frequency=peak["frequency"], method="nearest")).item()
    assert near == pytest.approx(peak["amplitude"], rel=0.01)
    table = bellows.table("response_y")
    np.testing.assert_array_equal(y.real, table["mid y real"])
    assert "random" not in bellows.responses and set(bellows.responses) == {"x", "y"}


def test_excitations_as_inputs_of_one_matrix(bellows):
    both = bellows.responses.frf("y", "x")
    assert both.H.shape == (len(both.frequency), 3, 2) and both.inputs == ("base.y", "base.x")
    np.testing.assert_array_equal(both.channel("mid.x", "base.x"),
                                  bellows.responses["x"].frf.channel("mid.x"))
    assert both.dataarray().attrs["units"] == "m/s2 per m/s2"


def test_motion_and_random_tables(bellows):
    response = bellows.responses["y"]
    assert response.motion.attrs["units"]["mid y displacement"] == "m"
    assert response.random.attrs["units"]["mid y"] == "(m/s2)2/Hz"
    level = response.level * abs(response.frf.channel("mid.y"))
    np.testing.assert_allclose(response.motion["mid y acceleration"], level, rtol=1e-12)


def test_static_stiffness_and_its_matrix_agree(bellows):
    static = bellows.static
    assert static.axial == pytest.approx(static.end_stiffness[7, 7], rel=1e-6)
    assert static.end_stiffness.shape == (12, 12)
    assert static.series["axial"] == static.axial and static.series.attrs["units"]["axial"] == "N/m"


def test_stress_levels_comparison_variants(bellows, levels, lap):
    assert {"static", "mode", "harmonic"} & set(bellows.stress["kind"])
    assert bellows.stress.attrs["units"]["von Mises"] == "Pa"
    assert levels.levels.names == ["z"]
    assert set(levels.levels.peaks["level"]) == {1, 10, 30}
    assert len(levels.levels.curves("z")) > 10 and len(levels.levels.joints) >= 3
    assert lap.comparison["measured"].notna().any()
    assert list(bellows.variants["variant"]) == ["nominal"]


def test_diagnosis_has_a_ledger_that_sums_to_one(lap):
    ledger = lap.diagnosis.ledger
    assert ledger["share"].sum() == pytest.approx(1, abs=1e-9)
    assert lap.diagnosis.verdict == "identified" and ledger.attrs["gap"] > 1
    assert "joint_friction" in set(lap.diagnosis.effects["effect"])
    names, likeness = lap.diagnosis.likeness
    assert likeness.shape == (len(names), len(names))


def test_nothing_is_read_before_it_is_asked_for(bellows, tmp_path):
    copy = tmp_path / "copy"
    shutil.copytree(bellows.path, copy)
    (copy / "results.json").write_text("{")
    (copy / "modes.vtu").write_bytes(b"no VTU")
    results = plica.results(copy)
    assert len(results.table("modes")) == 4
    with pytest.raises(plica.BrokenFolder, match="results.json: is damaged"):
        results.modes
    with pytest.raises(plica.BrokenFolder, match="modes.vtu: is damaged"):
        results.mesh


@pytest.mark.parametrize("version", ["0.2.0", "9.1.3", "1"])
def test_another_version_is_refused(bellows, tmp_path, version):
    data = json.loads((bellows.path / "results.json").read_text())
    data["plica_version"] = version
    (tmp_path / "results.json").write_text(json.dumps(data))
    with pytest.raises(plica.VersionError):
        plica.results(tmp_path).modes


def test_package_and_program_are_of_one_version():
    cmake = (TREE / "CMakeLists.txt").read_text()
    assert f"VERSION {plica.__version__} " in cmake


def test_other_words_of_a_diagnosis_are_refused(lap, tmp_path):
    data = json.loads((lap.path / "diagnosis.json").read_text())
    data["version"] = 1
    (tmp_path / "diagnosis.json").write_text(json.dumps(data))
    with pytest.raises(plica.VersionError, match="version 1, this package reads 2"):
        plica.results(tmp_path).diagnosis


def test_folders_that_are_none(tmp_path, beam):
    with pytest.raises(plica.BrokenFolder, match="is not there"):
        plica.results(tmp_path / "nowhere")
    with pytest.raises(plica.BrokenFolder, match="is a file"):
        plica.results(beam.path / "results.json")
    with pytest.raises(plica.BrokenFolder, match="has no results"):
        plica.results(tmp_path)


def test_what_is_not_there_says_which_command_writes_it(beam):
    with pytest.raises(plica.MissingData, match="plica reduce CASE"):
        beam.superelement
    with pytest.raises(plica.MissingData, match="plica diagnose --out"):
        beam.diagnosis
    with pytest.raises(plica.MissingData, match="static: true"):
        beam.static
    with pytest.raises(plica.MissingData, match="analyses.levels"):
        beam.levels
    with pytest.raises(plica.MissingData, match="none: analyses.response"):
        beam.responses["y"]


def test_a_run_as_measured_data(bellows):
    simulated = bellows.simulated
    assert simulated.specimen == "bellows" and len(simulated.sensors) == 1
    y = next(f for f in simulated.frf if f.inputs == ("base.y",))
    np.testing.assert_allclose(y.channel("mid.y"), bellows.responses["y"].frf.channel("mid.y"))
