"""Every file that the program writes is read: each CSV as a DataFrame without options, and what
commands besides `run` find, with units."""
import json
import re
import shutil
import sys

import matplotlib.pyplot as pyplot
import numpy as np
import pandas
import pytest
from conftest import CASES, HERE, TREE, shaken

import plica
from plica import dynamic_stiffness

DECOUPLER = HERE.parent / "examples" / "cases" / "decoupler.yaml"
LIFE = {"curve": {"type": "bellows"},
        "strokes": [{"name": "starts", "axial": "2 mm", "count": 10000}],
        "random": [{"name": "road", "of": "y", "duration": "10 h"}]}


@pytest.fixture(scope="module")
def driven(work):
    return plica.run(CASES / "driven.yaml", work / "driven", threads=1)


@pytest.fixture(scope="module")
def life(work):
    case = plica.Case(CASES / "bellows.yaml")
    case["analyses.life"] = LIFE
    case["analyses.error_bars"] = True
    case["parts.bellows.profile[1].count"] = 1  # it is meshed finer as well
    case["sensors[0].at"] = [0, "8 mm", "48.8 mm"]
    return case.run(work / "life", threads=1)


@pytest.fixture(scope="module")
def stiffness(work):
    return plica.stiffness(CASES / "levels.yaml", work / "stiffness", threads=1,
                           frequencies=["0:90:30", "100"], amplitudes="0.1mm",
                           ends=["left", "right"])


@pytest.fixture(scope="module")
def everything(work, bellows, driven, levels, life, lap, stiffness, identified, fitted):
    """Folders of all commands that write tables."""
    plica.sweep(CASES / "beam.yaml", {"parts.tip.mass": [0.1, 0.2]}, work / "sweep")
    forced = plica.Case(CASES / "levels.yaml")
    forced["analyses.levels"] = {"band": ["80 Hz", "160 Hz"], "forces": [
        {"name": "tap", "at": "one.end", "direction": "z", "levels": ["0.1 N", "1 N"]}]}
    found = [bellows, driven, levels, life, lap, stiffness,
             forced.run(work / "forced", threads=1), fitted,
             plica.results(work / "sweep"), *identified.sets,
             plica.reduce(CASES / "bellows.yaml", work / "pipe", beam=True, threads=1),
             plica.ejma(CASES / "bellows.yaml", work / "ejma", threads=1),
             plica.run(CASES / "benchmark.yaml", work / "benchmark", threads=1),
             beside_a_rig(work / "measured"), noise(work / "noise"),
             loads_of_a_deck(work / "deck_loads")]
    return found


def loads_of_a_deck(folder):
    folder.mkdir()
    (folder / "bar.bdf").write_text(
        "SOL 101\nCEND\nSPC = 1\nLOAD = 2\nBEGIN BULK\nGRID,1,,0.,0.,0.\nGRID,2,,100.,0.,0.\n"
        "CBAR,1,1,1,2,0.,1.,0.\nPBAR,1,1,50.,100.,300.,400.\nMAT1,1,2.+5,,0.3,8.-9\n"
        "SPC1,1,123456,1\nFORCE,2,2,0,5.,0.,1.,0.\nENDDATA\n")
    (folder / "case.yaml").write_text(
        "case: loads\nparts:\n  bar: {type: deck, file: bar.bdf, length_unit: mm, mass_unit: t}\n"
        "analyses: {static: deck, error_bars: false}\n")
    return plica.run(folder / "case.yaml", folder / "loads", threads=1)


def beside_a_rig(folder):
    folder.mkdir()
    (folder / "rig.csv").write_text("frequency [Hz],z storage [N/mm]\n10,100\n50,90\n")
    return plica.stiffness(CASES / "levels.yaml", folder / "rig", measured=folder / "rig.csv",
                           ends=["left", "right"], threads=1)


def noise(folder):
    """Identified from time signals, which writes their spectra."""
    lab = plica.measured(folder / "lab", "pipe", signals=shaken(116, 0.01, samples=32768),
                         sensors=[{"name": "mid", "at": [0, 0, 0]}])
    return plica.identify(lab, folder / "out", block=2048, band=[60, 200])


def names_in_sources():
    """Every name of a table in the sources of what the program writes, `*` where it is put
    together."""
    names = set()
    for file in [*(TREE / "io" / "write").glob("*.cpp"), *(TREE / "io" / "tables").glob("*.cpp"),
                 *(TREE / "app").glob("*.cpp")]:
        for line in file.read_text().splitlines():
            for before, name in re.findall(r'("[a-z_]*" \+ .*?)?"([a-z_]*\.csv)"', line):
                if before:
                    names.add(re.match(r'"([a-z_]*)"', before).group(1) + "*")
                elif name != ".csv":
                    names.add(name)
    return names


def test_every_csv_is_a_table_without_options(everything):
    seen = set()
    for results in everything:
        for name in results.tables:
            frame = results.table(name)
            text = (results.path / f"{name}.csv").read_text()
            header = pandas.read_csv(results.path / f"{name}.csv", nrows=0).columns
            assert len(frame.columns) == len(header) and len(set(frame.columns)) == len(header)
            assert len(frame) == len(pandas.read_csv(results.path / f"{name}.csv", header=0))
            for head in header:  # every unit of a header is told
                if found := re.fullmatch(r"(.*\S) \[([^\[\]]+)\]", head):
                    units = frame.attrs["units"]
                    assert units.get(found[1], units.get(head)) == found[2], (name, head)
            assert not any(c.startswith("Unnamed") for c in frame.columns) and text.endswith("\n")
            seen.add(f"{name}.csv")
    missing = {n for n in names_in_sources()
               if not any(re.fullmatch(n.replace("*", ".*"), s) for s in seen)}
    assert len(seen) > 50 and not missing


def test_all_that_a_driven_part_does(driven):
    assert list(driven.responses) == ["motion_of_root_z", "motion_of_root_x", "force_tap",
                                      "together_both"]
    both = driven.responses["together_both"]
    assert (both.source, both.name) == ("together", "both")
    assert both.array.attrs["units"] == "m/s2"
    tap, root = driven.responses["force_tap"].frf, driven.responses["motion_of_root_z"].frf
    level = driven.responses["motion_of_root_z"].level
    sum_of_both = level * root.channel("tip.z") + 2j * tap.channel("tip.z")
    np.testing.assert_allclose(both.frf.channel("tip.z"), sum_of_both, rtol=1e-9)
    drop = driven.transients["drop"]
    assert drop.attrs["units"] == {"time": "s", "input": "m/s2", "tip x": "m/s2", "tip y": "m/s2",
                                   "tip z": "m/s2"}
    assert drop["input"].max() == pytest.approx(50 * 9.80665, rel=1e-6)
    assert driven.shocks["drop"]["tip z maximax"].max() > drop["tip z"].abs().max()
    assert driven.run_ups["up"].attrs["units"]["speed"] == "rpm"
    assert len(driven.run_ups_in_time["up"]) > 100 and len(driven.crossings) >= 1
    assert driven.complex_modes.attrs["units"]["tip z real"] == "1/sqrt(kg)"
    with pytest.raises(plica.MissingData, match="there is no 'fall'; drop"):
        driven.transients["fall"]
    with pytest.raises(plica.MissingData, match="no life; analyses.life in the case"):
        driven.life
    with pytest.raises(plica.MissingData, match="no states; states in the case"):
        driven.states
    with pytest.raises(plica.MissingData, match="stress_places.csv; analyses.stress in the case"):
        driven.stress_places


def test_life_and_stress_by_place(life):
    assert life.life.damage == life.data["life"]["spots"][0]["damage"]
    assert list(life.life.duties["name"]) == ["starts", "road"]
    assert life.life.duties.attrs["units"]["range"] == "Pa"
    assert life.life.damage == pytest.approx(life.life.spots["damage"][0])  # the hot spot is first
    assert set(life.life.densities) == {"road"} and len(life.life.densities["road"]) > 50
    assert life.stress_places.attrs["units"]["hoop bending"] == "Pa"
    assert len(life.stress_meridian) > 10 and "bellows" in life.life.curve
    assert life.life.meridian.attrs["units"]["along"] == "m" and len(life.life.meridian) > 10
    assert set(life.error_bars["quantity"]) >= {"k_axial", "f_axial"}


def test_states_beside_one_another(work):
    case = plica.Case(CASES / "bellows.yaml")
    del case["analyses.response"], case["analyses.stress"]
    case["states"] = {"pressed": {"offset": {"right": {"move": [0, "-0.5 mm", 0]}}},
                      "pressure": {"pressure": "1 bar", "buckling": 1}}
    case["materials.steel.E"] = 193e9
    found = case.run(work / "states", threads=1)
    assert list(found.states.index) == ["at rest", "pressed", "pressure"]
    assert found.states["largest_displacement"]["pressed"] == pytest.approx(5e-4, rel=1e-3)
    assert found.states["buckling_factor"]["pressure"] > 1
    assert found.states["k_axial"]["at rest"] == pytest.approx(found.static.axial)
    assert found.states.attrs["units"]["largest_displacement"] == "m" and found.state == {}
    one = case.run(work / "one", state="pressure", threads=1)
    assert one.state["name"] == "pressure"
    assert one.headline["k_axial"] == pytest.approx(found.states["k_axial"]["pressure"], rel=1e-9)


def test_dynamic_stiffness(stiffness, monkeypatch):
    found = stiffness.stiffness
    assert found.ends == ("left", "right") and found.Z.shape == (1, 2, 5, 12, 12)
    array = found.array
    assert array.dims == ("state", "level", "frequency", "force", "motion")
    assert array.amplitude.values.tolist() == [0, 1e-4] and array.frequency.attrs["units"] == "Hz"
    table = found.table
    row = table[(table["direction"] == "y") & (table["frequency"] == 30)].iloc[0]
    assert found.transfer("y")[1].real == pytest.approx(row["blocked transfer k21 storage"])
    axes = stiffness.plot()
    assert axes.get_yscale() == "log" and len(axes.lines) == 6
    pyplot.close("all")
    with pytest.raises(ValueError, match="one kind on one plot"):
        stiffness.plot.stiffness(directions=["x", "rx"])
    with pytest.raises(plica.MissingData, match="no direction 'q'; x, y, z"):
        found.transfer("q")
    monkeypatch.setitem(sys.modules, "h5py", None)
    text = plica.results(stiffness.path).stiffness  # of the CSV, numpy alone
    assert text.coordinates == found.coordinates and text.states == found.states
    np.testing.assert_allclose(text.Z, found.Z, rtol=1e-12, atol=1e-15 * np.abs(found.Z).max())


def test_sheets_and_sweeps_and_beams(everything):
    by_name = {r.path.name: r for r in everything}
    sheet = by_name["ejma"].ejma
    assert {"bellows", "quantity", "unit", "formula", "shells"} <= set(sheet.columns)
    assert by_name["sweep"].sweep.attrs["units"]["mass"] == "kg"
    assert by_name["pipe"].beam.attrs["units"]["shell axial"] == "N/m"
    assert by_name["benchmark"].benchmark["quantity"][0] == "first mode"
    assert len(by_name["fit"].fit.targets) == 1 and by_name["fit"].fit.evaluations > 0
    assert len(by_name["out"].identification.spectra) > 100
    assert by_name["rig"].stiffness.comparison["frequency"].max() == 50
    with pytest.raises(plica.MissingData, match="has nothing that is drawn as a whole; r.tables"):
        by_name["ejma"].plot()


def test_the_list_of_files_says_the_version_of_each(stiffness, everything, tmp_path):
    for results in everything:
        listed = json.loads((results.path / "plica_files.json").read_text()) \
            if results.folder.has("plica_files.json") else None
        if listed:
            assert all(e["plica_version"] == plica.__version__ for e in listed["files"].values())
    shutil.copytree(stiffness.path, tmp_path / "old")
    listed = tmp_path / "old" / "plica_files.json"
    listed.write_text(listed.read_text().replace(f'"{plica.__version__}"', '"0.9.1"'))
    old = plica.results(tmp_path / "old")
    for ask in (lambda: old.stiffness, lambda: old.table("transfer_stiffness")):
        with pytest.raises(plica.VersionError, match=r"stiffness.* is of Plica 0.9.1, this package "
                                                     r"reads 0.1; install"):
            ask()
    listed.write_text("no list")
    with pytest.raises(plica.BrokenFolder, match="plica_files.json: is damaged"):
        plica.results(tmp_path / "old").table("stiffness")


def test_a_damaged_stiffness_is_broken(stiffness, tmp_path):
    (tmp_path / "stiffness.h5").write_bytes(b"no HDF5")
    with pytest.raises(plica.BrokenFolder, match="stiffness.h5: is damaged or no dynamic"):
        plica.results(tmp_path).stiffness
    (tmp_path / "stiffness.h5").unlink()
    (tmp_path / "stiffness.csv").write_text("frequency [Hz],a\n1,2\n")
    with pytest.raises(plica.BrokenFolder, match="stiffness.csv: is no dynamic stiffness"):
        dynamic_stiffness.read_stiffness(plica.results(tmp_path).folder)
