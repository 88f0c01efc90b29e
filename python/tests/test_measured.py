"""measured.yaml from arrays, read by the program."""
import re

import matplotlib.pyplot as pyplot
import numpy as np
import pytest
from conftest import SHIPPED, TREE, shaken, transmissibility

import plica
from plica import quantities


def test_responses_from_arrays_are_identified(tmp_path):
    f = np.arange(60.0, 200.0, 0.25)
    frf = plica.Frf(f, transmissibility(f, 116, 0.011)[:, None, None], ("mid.y",), ("base.y",),
                    "m/s2 per m/s2", level=10.0)
    written = plica.measured(tmp_path / "lab", "pipe", mass=1.7096,
                             sensors=[{"name": "mid", "at": [0, 0.091, 0.073],
                                       "axes": ["x", "y", "z"], "mass": 0.005}],
                             frf=frf, source='the "lab"', sigma={"relative": 0.02, "floor": 0.01})
    np.testing.assert_array_equal(written.frf[0].H, frf.H)
    assert written.frf[0].level == 10 and written.data["source"] == 'the "lab"'
    found = plica.identify(written, tmp_path / "out").identification
    assert found.modes["frequency"][0] == pytest.approx(116, rel=1e-4)
    assert found.modes["damping"][0] == pytest.approx(0.011, rel=1e-2)
    assert found.shapes.shape == (1, 1) and found.channels == ["mid.y"]
    with pytest.raises(FileExistsError, match="measured.yaml"):
        plica.measured(tmp_path / "lab", "pipe")


def test_several_weighings_are_rows(tmp_path):
    states = [{"name": "before", "baseline": True}, {"name": "after"}]
    rows = [{"value": 1.2, "sigma": 0.001, "state": "before"}, {"value": 1.25, "state": "after"}]
    written = plica.measured(tmp_path / "lab", "pipe", states=states, mass=rows)
    assert written.mass == 1.2 and list(written.weighings["value"]) == [1.2, 1.25]
    assert list(written.weighings["state"]) == ["before", "after"]
    data = tmp_path / "measured.yaml"
    data.write_text("specimen: a\nmass: {value: 883.1 g, sigma: 0.5 g}\n")
    one = plica.read_measured(data).weighings
    assert one["value"][0] == pytest.approx(0.8831) and one["sigma"][0] == pytest.approx(5e-4)
    assert one.attrs["units"] == {"value": "kg", "sigma": "kg"}
    data.write_text("specimen: a\n")
    assert plica.read_measured(data).weighings.empty


def test_several_inputs_of_one_test_are_identified_together(tmp_path):
    """Two masses between three springs, driven at each: frequencies, damping and shapes."""
    f, k, zeta = np.arange(4.0, 20.0, 0.02), 1000.0, 0.01
    shapes = np.array([[1, 1], [1, -1]]) / np.sqrt(2)
    hertz = np.sqrt(np.array([k, 3 * k])) / (2 * np.pi)
    w, w0 = 2 * np.pi * f[:, None], 2 * np.pi * hertz
    H = np.einsum("km,im,jm->kij", -w ** 2 / (w0 ** 2 - w ** 2 + 2j * zeta * w0 * w), shapes,
                  shapes)
    channels = ("a.x", "b.x")
    lab = plica.measured(tmp_path / "lab", "two", frf=plica.Frf(f, H, channels, channels,
                                                                "m/s2 per N"),
                         sensors=[{"name": "a", "at": [0, 0, 0]}, {"name": "b", "at": [0, 1, 0]}])
    assert [one.inputs for one in lab.frf] == [("a.x",), ("b.x",)]
    np.testing.assert_array_equal(lab.frf[1].H[:, :, 0], H[:, :, 1])
    found = plica.identify(lab, tmp_path / "out")
    np.testing.assert_allclose(found.identification.modes["frequency"], hertz, rtol=1e-4)
    np.testing.assert_allclose(found.identification.modes["damping"], zeta, rtol=2e-2)
    axes = found.plot.stability()
    assert len(axes.lines) >= 6
    pyplot.close("all")


@pytest.mark.parametrize("unit, power", [("m per N", 0), ("m/s per N", 1), ("m/s2 per N", 2)])
def test_the_unit_says_what_a_response_to_a_force_is(tmp_path, unit, power):
    f = np.arange(20.0, 60.0, 0.1)
    w, w0 = 2 * np.pi * f, 2 * np.pi * 40
    H = (1j * w) ** power / (w0 ** 2 - w ** 2 + 2j * 0.01 * w0 * w)
    frf = plica.Frf(f, H[:, None, None], ("mid.z",), ("mid.z",), unit)
    lab = plica.measured(tmp_path / "lab", "a", frf=frf, sensors=[{"name": "mid", "at": [0, 0, 0]}])
    mode = plica.identify(lab, tmp_path / "out").identification.data["modes"][0]
    assert mode["frequency"] == pytest.approx(40, rel=1e-6)
    assert mode["mass_normalised"] and mode["shape"][0]["real"] == pytest.approx(1, rel=1e-3)
    with pytest.raises(ValueError, match="in 'g per N'; SI: m/s2 per N"):
        plica.measured(tmp_path / "b", "a", frf=plica.Frf(f, H[:, None, None], ("mid.z",),
                                                          ("mid.z",), "g per N"))


def test_signals_from_arrays_are_identified(tmp_path):
    plica.measured(tmp_path / "lab", "pipe", signals=shaken(116, 0.01),
                   sensors=[{"name": "mid", "at": [0, 0, 0]}])
    found = plica.identify(tmp_path / "lab" / "measured.yaml", tmp_path / "out", block=4096,
                           band=[60, 200])
    assert found.identification.modes["frequency"][0] == pytest.approx(116, rel=2e-3)


def test_modes_and_peaks_from_frames(tmp_path):
    import pandas
    modes = pandas.DataFrame({"frequency": [116.0, 178.0], "sigma": [1.0, np.nan],
                              "shape": ["axial", "transverse"], "direction": ["y", "x"]})
    peaks = [{"base": "y", "sensor": "mid", "direction": "y", "level": np.array([5.0, 10.0]),
              "frequency": [198, 185]}]
    written = plica.measured(tmp_path, "pipe", modes=modes, peaks=peaks, hold_out=["modes[1]"],
                             sensors=[{"name": "mid", "at": (0, 0, 0)}],
                             static=[{"direction": "axial", "value": np.float64(5.4e4)}])
    assert "sigma" not in written.data["modes"][1]
    assert list(written.peaks["frequency"]) == [198, 185]
    assert list(written.modes["shape"]) == ["axial", "transverse"]
    text = (tmp_path / "measured.yaml").read_text()
    assert "numpy" not in text and "value: 54000.0" in text
    with pytest.raises(ValueError, match="no number"):
        plica.measured(tmp_path / "b", "pipe", static=[{"value": np.inf}])


def test_comparison_of_a_run_with_itself_is_exact(bellows, tmp_path):
    found = plica.compare(bellows, bellows, tmp_path).correlation
    np.testing.assert_allclose(found.pairs["frequency_error"], 0, atol=1e-12)
    assert found.mac.shape[0] == found.mac.shape[1]
    assert found.numbers["simulated"].equals(found.numbers["measured"])


def test_responses_of_a_universal_file_by_their_base(bellows, tmp_path):
    file = bellows.path / "responses.uff"
    (tmp_path / "measured.yaml").write_text(
        f"specimen: a\nfrf:\n  - {{file: {file}, base: x, level: 5}}\n"
        f"  - {{file: {file}, base: z}}\n")
    data = plica.read_measured(tmp_path)
    one = data._load(data.data["frf"][0])
    assert one.inputs == ("base.x",) and one.level == 5
    np.testing.assert_allclose(one.channel("mid.x"),
                               bellows.responses["x"].frf.channel("mid.x"), rtol=1e-11)
    with pytest.raises(plica.MissingData, match="no response to base.z; to base"):
        data.frf


def test_what_is_no_measured_data(tmp_path):
    with pytest.raises(plica.BrokenFolder, match="cannot be read"):
        plica.read_measured(tmp_path)
    (tmp_path / "measured.yaml").write_text("case: a\n")
    with pytest.raises(plica.BrokenFolder, match="a map with `specimen`"):
        plica.read_measured(tmp_path)
    (tmp_path / "measured.yaml").write_text("specimen: [\n")
    with pytest.raises(plica.BrokenFolder):
        plica.read_measured(tmp_path)


def test_responses_of_a_lab_that_are_none(tmp_path):
    data = tmp_path / "measured.yaml"
    data.write_text("specimen: a\nfrf: [{file: z.csv, base: z}]\n")
    with pytest.raises(plica.BrokenFolder, match="z.csv: cannot be read: No such file"):
        plica.read_measured(data).frf
    head = "frequency [Hz],mid z real,mid z imaginary\n"
    for text in ("f [Hz],a\n1,2\n", "frequency [Hz],mid z real\n1,2\n", head + "1,x,2\n",
                 head + "2,1,1\n1,1,1\n"):
        (tmp_path / "z.csv").write_text(text)
        with pytest.raises(plica.BrokenFolder, match="z.csv: .*; frequency|z.csv: .*; numbers, fr"):
            plica.read_measured(data).frf
    data.write_text("specimen: a\nfrf: [{file: z.uff, base: z}]\n")
    with pytest.raises(plica.BrokenFolder, match="z.uff: cannot be read: .*; a universal file"):
        plica.read_measured(data).frf
    data.write_text("specimen: a\npeaks: [{sensor: mid}]\nfrf: [3]\n")
    for ask in (lambda lab: lab.peaks, lambda lab: lab.frf):
        with pytest.raises(plica.BrokenFolder, match="yaml: .*; as `plica schema measured` says"):
            ask(plica.read_measured(data))


def test_numbers_with_units_are_read_in_si():
    lab = plica.read_measured(SHIPPED / "tutorial")
    assert lab.mass == pytest.approx(0.8831)
    assert list(lab.modes["frequency"]) == [164.0, 229.5] and lab.modes["damping"][0] == 0.0103
    assert lab.modes.attrs["units"] == {"frequency": "Hz", "sigma": "Hz",
                                        "damping": "fraction of critical"}
    static = lab.entries("static")
    assert static["value"][0] == 54900 and static.attrs["units"]["value"] == "N/m"
    assert lab.sensors["at"][0] == pytest.approx([0, 0.062, 0.0488])
    assert quantities.si("5 g", "mass") == (0.005, "kg")
    assert quantities.si("-2 g") == (-19.6133, "m/s2")
    for text in ("axial 1", "3 furlongs", "z_1.csv", 3, None, True, "1e3"):
        assert quantities.si(text) == (text, None)


def test_units_are_those_of_the_program():
    text = (TREE / "words" / "units.cpp").read_text()
    table = text[text.index("dimensions{"):text.index("return dimensions;")]
    known = {"degree": np.pi / 180}
    program = {}
    for name, factor in re.findall(r'{"([^"]+)", ([^{}"]+)}', table):
        program.setdefault(name, set()).add(eval(factor, {}, known))
    for name, (_, factor) in quantities.SI.items():
        assert [factor] == pytest.approx(list(program[name]), rel=1e-15), name
    assert program["g"] == {quantities.GRAM[1], quantities.GRAVITY[1]}
