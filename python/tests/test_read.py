"""Reading: tables, units, versions, what is broken."""
import json
import shutil
import warnings

import numpy as np
import pytest
from conftest import CASES, TREE

import plica


def test_modes_are_those_of_the_csv(bellows):
    modes, table = bellows.modes, bellows.table("modes")
    assert list(modes.index) == [1, 2, 3, 4]
    np.testing.assert_allclose(modes["frequency"], table["frequency"], rtol=1e-15)
    np.testing.assert_allclose(modes["effective_mass_y"], table["effective mass y"], atol=1e-12)
    assert modes.attrs["units"]["frequency"] == "Hz"
    assert table.attrs["units"]["effective inertia x"] == "kg m2"


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


def copied(results, folder, listed=True):
    """A copy to break; without the list of files what is in them alone tells."""
    shutil.copytree(results.path, folder)
    if not listed:
        (folder / "plica_files.json").unlink()
    return folder


ASKED = {"modes": lambda r: r.modes, "headline": lambda r: r.headline, "static": lambda r: r.static,
         "responses": lambda r: r.responses, "verification": lambda r: r.proved,
         "case": lambda r: r.case}


def test_a_document_without_a_key_is_broken(bellows, tmp_path):
    file = copied(bellows, tmp_path / "copy", listed=False) / "results.json"
    whole = json.loads(file.read_text())
    for key, ask in ASKED.items():
        for data in ({k: v for k, v in whole.items() if k != key}, {}):
            file.write_text(json.dumps(data))
            with pytest.raises(plica.BrokenFolder, match=rf"results.json: has no '({key}|case)'"):
                ask(plica.results(file.parent))
    for ask in (lambda r: r.levels, lambda r: r.life, lambda r: r.states, lambda r: r.transients,
                lambda r: r.state, lambda r: r.measured):
        with pytest.raises(plica.BrokenFolder, match="results.json: has no 'case'"):
            ask(plica.results(file.parent))


def test_a_document_of_another_kind_is_broken(bellows, tmp_path):
    file = copied(bellows, tmp_path / "copy", listed=False) / "results.json"
    whole = json.loads(file.read_text())
    for key in ("modes", "headline", "static", "responses", "verification"):
        for wrong in (3, "text", [1]):
            file.write_text(json.dumps({**whole, key: wrong}))
            with pytest.raises(plica.BrokenFolder, match="results.json: .*run the command anew"):
                ASKED[key](plica.results(file.parent))
    file.write_text(json.dumps({**whole, "responses": [{"file": "response_y.csv"}]}))
    with pytest.raises(plica.BrokenFolder, match="results.json: has no 'motion_file'"):
        plica.results(file.parent).responses
    file.write_text(json.dumps({**whole, "plica_version": 2}))
    with pytest.raises(plica.BrokenFolder, match="results.json: .*plica_version is 2"):
        plica.results(file.parent).modes


def test_other_documents_without_their_keys_are_broken(tmp_path):
    asked = {"fit.json": ("parameters", "targets", "evaluations", "values", "correlation"),
             "correlation.json": ("pairs", "numbers", "mac", "comac"),
             "identification.json": ("modes", "shapes", "channels"),
             "diagnosis.json": ("verdict", "headline", "ledger", "effects", "readings", "gap",
                                "likeness")}
    for name, attributes in asked.items():
        (tmp_path / name).write_text('{"plica_version": "0.1.0", "version": 2}')
        document = getattr(plica.results(tmp_path), name[:-len(".json")])
        for attribute in attributes:
            with pytest.raises(plica.BrokenFolder, match=f"{name}: has no '"):
                getattr(document, attribute)
    with pytest.raises(plica.BrokenFolder, match="diagnosis.json: has no 'case'"):
        repr(plica.results(tmp_path).diagnosis)


def test_bytes_and_columns_that_are_no_table_are_broken(bellows, tmp_path):
    folder = copied(bellows, tmp_path / "copy", listed=False)
    for name, ask in (("stress", lambda r: r.stress),
                      ("response_y", lambda r: r.responses["y"].frf),
                      ("motion_y", lambda r: r.responses["y"].motion)):
        (folder / f"{name}.csv").write_bytes(b"\xff\xfe")
        with pytest.raises(plica.BrokenFolder, match=f"{name}.csv: is damaged: .*UTF-8"):
            ask(plica.results(folder))
    head = "frequency [Hz],mid y real,mid y imaginary\n"
    for text in ("a,b\n1,2\n", "a,b\n", "frequency [Hz],mid y real\n1,2\n",
                 head + "1,x,2\n", head + "2,1,1\n1,1,1\n"):
        (folder / "response_y.csv").write_text(text)
        with pytest.raises(plica.BrokenFolder, match="response_y.csv: .*run the command anew"):
            plica.results(folder).responses["y"].frf


def test_the_list_of_files_has_the_fingerprints_of_their_bytes(bellows):
    listed = json.loads((bellows.path / "plica_files.json").read_text())["files"]
    for name in ("modes.csv", "results.json", "response_y.csv", "superelement.h5"):
        assert plica.written.fingerprint((bellows.path / name).read_bytes()) in \
            listed[name]["prints"]


@pytest.mark.parametrize("cut", [lambda text: "".join(text.splitlines(True)[:50]),
                                 lambda text: text[:-3]])
def test_a_cut_file_is_broken(bellows, tmp_path, cut):
    file = copied(bellows, tmp_path / "copy") / "response_y.csv"
    size = file.stat().st_size
    file.write_text(cut(file.read_text()))
    said = ("response_y.csv: is damaged: it was changed since plica wrote it, has "
            rf"\d+ bytes of {size}")
    for ask in (lambda r: r.responses["y"].frf, lambda r: r.table("response_y"),
                lambda r: r.simulated.frf, lambda r: plica.read_csv(file)):
        with pytest.raises(plica.BrokenFolder, match=said):
            ask(plica.results(file.parent))


def test_a_changed_file_is_read_with_a_warning(bellows, tmp_path):
    folder = copied(bellows, tmp_path / "copy")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert len(plica.results(folder).modes) == len(plica.results(folder).table("modes"))
        assert len(plica.results(folder).mesh.points) and plica.results(folder).simulated.frf
    text = (folder / "modes.csv").read_text()
    for changed in (text.replace("1", "2"), text + text.splitlines(True)[-1]):
        (folder / "modes.csv").write_text(changed)
        with pytest.warns(UserWarning, match="modes.csv: was changed since plica wrote it"):
            assert len(plica.results(folder).table("modes")) >= 4
    shorter = (folder / "simulated.yaml").read_text().replace("specimen: bellows", "specimen: a")
    (folder / "simulated.yaml").write_text(shorter)  # as people do
    with pytest.warns(UserWarning, match="simulated.yaml: was changed"):
        assert plica.results(folder).simulated.specimen == "a"


def test_a_listed_file_that_is_missing_is_broken(bellows, beam, tmp_path):
    folder = copied(bellows, tmp_path / "copy")
    for name, ask in (("stress.csv", lambda r: r.stress),
                      ("static.csv", lambda r: r.table("static")),
                      ("modes.vtu", lambda r: r.mesh),
                      ("response_y.csv", lambda r: r.responses["y"].frf),
                      ("superelement.h5", lambda r: r.superelement),
                      ("results.json", lambda r: r.modes)):
        (folder / name).unlink()
        with pytest.raises(plica.BrokenFolder, match=rf"{name}: is missing, plica wrote it here"):
            ask(plica.results(folder))
    with pytest.raises(plica.MissingData, match="analyses.stress in the case"):
        beam.stress


def test_files_written_after_the_folder_was_opened_are_not_changed(tmp_path):
    """The list is read anew when a command has written it anew."""
    plica.run(CASES / "beam.yaml", tmp_path / "out", threads=1)
    results = plica.results(tmp_path / "out")
    assert len(results.table("modes"))
    case = plica.Case(CASES / "beam.yaml")
    case["parts.tip.mass"] = 0.25
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        case.run(tmp_path / "out", threads=1)
        assert results.data["headline"] and len(results.table("variants").columns)


def test_numbers_have_units(bellows, fitted):
    headline = bellows.headline
    assert headline == bellows.data["headline"] and isinstance(headline, dict)
    assert headline.units["mass" if "mass" in headline else "k_axial"] in ("kg", "N/m")
    assert all(headline.units[name] == "Hz" for name in headline if name.startswith("f_"))
    parameters = fitted.fit.parameters
    assert list(parameters["unit"]) == ["m"] and parameters.attrs["units"]["known"] == "fraction"
    assert parameters.attrs["units"]["after"] == "that of the row"
    assert fitted.fit.units == {"parts.beam.section.depth": "m"} == \
        {path: "m" for path in fitted.fit.values}
    assert list(fitted.table("fit")["unit"]) == ["m"]
    assert fitted.table("designs").attrs["units"]["parts.beam.section.depth"] == "m"
    targets = fitted.fit.targets
    assert targets.attrs["units"]["measured"] == "that of the row" and targets["unit"][0] == "Hz"


def test_measured_data_of_a_run_and_of_a_test(lap, beam, identified):
    assert lap.measured.specimen == "bolted_lap" and len(lap.measured.frf) == 4
    assert lap.measured.path == (TREE / "cases" / "bolted_lap" / "measured.yaml").resolve()
    assert lap.measured.mass == pytest.approx(lap.comparison["measured"][0], rel=1e-12)
    assert len(identified.measured.modes) > 1 and identified.measured.specimen == "bolted_lap"
    with pytest.raises(plica.MissingData, match="has no measured data"):
        beam.measured


def test_measured_data_that_were_changed_or_moved_since(tmp_path):
    lab = tmp_path / "Prüfstand 1"
    shutil.copytree(TREE / "cases" / "bolted_lap", lab)
    case = plica.Case(lab / "bolted_lap.yaml")
    case["case"] = "other"  # so that it runs from a folder that goes again
    plica.Case.run(case, lab / "out", threads=1, no_error_bars=True)
    shutil.move(lab, tmp_path / "moved")  # the results together with the test
    found = plica.results(tmp_path / "moved" / "out")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert found.measured.path == tmp_path / "moved" / "measured.yaml"
    with open(found.measured.path, "a", encoding="utf-8") as file:
        file.write("caveats: [weighed anew]\n")
    with pytest.warns(UserWarning, match=r"yaml: was changed since .*out was held against it"):
        plica.results(tmp_path / "moved" / "out").measured
    (tmp_path / "moved" / "measured.yaml").unlink()
    with pytest.raises(plica.MissingData, match=r"measured.yaml: is not there any more, .*out was"):
        plica.results(tmp_path / "moved" / "out").measured
