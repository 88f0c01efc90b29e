"""Plots: each gives its axes, with what is to be seen on them."""
import json

import matplotlib.pyplot as pyplot
import numpy as np
import pytest
from conftest import SHIPPED

import plica
from plica.documents import Correlation, Fit, Identification
from plica.folder import Folder
from plica.plot import matrix, stability


@pytest.fixture(autouse=True)
def close():
    yield
    pyplot.close("all")


def drawn(axes, path):
    axes.figure.savefig(path / "plot.png")
    assert (path / "plot.png").stat().st_size > 4000
    return axes


def test_response_over_test(lap, tmp_path):
    axes = drawn(lap.plot.response(measured=SHIPPED / "bolted_lap"), tmp_path)
    labels = [text.get_text() for text in axes.get_legend().get_texts()]
    assert labels[0] == "joint z" and "joint z, test at 30" in labels
    assert axes.get_yscale() == "log" and axes.get_xlabel() == "frequency in Hz"
    own = pyplot.figure().add_subplot()
    assert lap.plot.response(ax=own, phase=True) is own
    at = lap.responses["z"].level  # unless told, that of the run at the level that is nearest
    nearest = min((1, 3, 10, 30), key=lambda level: abs(np.log(level / at)))
    labels = [text.get_text() for text in own.get_legend().get_texts()]
    assert labels == ["joint z", f"joint z, test at {nearest}"]
    assert len(lap.plot.response(measured=True).lines) == 5
    assert len(lap.plot.response(measured=False).lines) == 1
    with pytest.raises(plica.MissingData, match="has no response to base.z"):
        lap.plot.response(measured=SHIPPED / "lap_beam")


def test_the_ledger_as_a_waterfall(lap, tmp_path):
    axes = drawn(lap.plot(), tmp_path)  # the most telling plot of a diagnosis
    names = [text.get_text() for text in axes.get_yticklabels()]
    assert names[0] == "the gap of the nominal case" and len(names) == 1 + len(lap.diagnosis.ledger)
    ends = [patch.get_x() + patch.get_width() for patch in axes.patches]
    assert ends[-1] == pytest.approx(0, abs=1e-6)  # all of the gap is shared out


def test_shapes_of_shells_and_beams(bellows, beam, tmp_path):
    drawn(bellows.plot.shape(1), tmp_path)
    axes = drawn(beam.plot(), tmp_path)
    assert axes.get_title("left").startswith("mode 1: transverse 1")
    with pytest.raises(plica.MissingData, match="has no mode 9; 1 to 4"):
        bellows.plot.shape(9)


def test_an_animation_moves(beam, tmp_path):
    moving = beam.animate(1, frames=4)
    moving.save(tmp_path / "a.gif", writer="pillow")
    assert (tmp_path / "a.gif").read_bytes()[:3] == b"GIF"


def test_peaks_over_the_level(levels, tmp_path):
    axes = drawn(levels.plot.levels(), tmp_path)
    frequency = axes.lines[0].get_ydata()
    assert len(frequency) == 3 and np.all(np.diff(frequency) < 0)  # it softens
    drawn(levels.plot(), tmp_path)


def test_a_test_and_what_its_modes_make_of_it(identified, tmp_path):
    assert len(identified.sets) == 4
    first = identified.sets[0].identification
    test, fitted = first.frf[0], first.synthesised[0]
    peak = np.argmax(abs(test.channel("joint.z")))
    assert abs(fitted.channel("joint.z")[peak] / test.channel("joint.z")[peak] - 1) < 0.05
    axes = drawn(identified.plot(), tmp_path)  # of several sets the first
    assert axes.get_legend().get_texts()[1].get_text() == "from the modes"


def test_mac_and_correlation_of_parameters(bellows, tmp_path):
    plica.compare(bellows, bellows, tmp_path)
    folder = Folder(tmp_path)
    axes = drawn(matrix.mac(Correlation(folder)), tmp_path)
    assert axes.get_xlabel() == "measured mode"
    (tmp_path / "fit.json").write_text(json.dumps({
        "parameters": [{"path": "a"}, {"path": "b"}], "correlation": [[1, 0.9], [0.9, 1]]}))
    drawn(matrix.correlation(Fit(folder)), tmp_path)


def test_the_stability_diagram_of_an_identification(identified, tmp_path):
    """Of the bolted lap at its lowest level, end to end: what the program writes is what is drawn,
    and every mode that was found stands on a column of stable poles."""
    found = identified.sets[0]
    identification = found.identification
    poles, modes = identification.stabilisation, identification.modes
    assert set(poles["stable"]) <= {"new", "frequency", "damping", "all"} and len(modes) >= 1
    assert poles.attrs["units"]["frequency"] == "Hz" and len(poles) > 50
    axes = drawn(found.plot.stability(), tmp_path)
    marks = {line.get_label(): line for line in axes.lines if not line.get_label().startswith("_")}
    assert list(marks) == ["new", "frequency stable", "damping stable", "stable"]
    stable = poles[poles["stable"] == "all"]
    np.testing.assert_array_equal(marks["stable"].get_xdata(), stable["frequency"])
    np.testing.assert_array_equal(marks["stable"].get_ydata(), stable["order"])
    assert sum(len(line.get_xdata()) for line in marks.values()) == len(poles)
    for frequency in modes["frequency"]:
        near = stable[abs(stable["frequency"] / frequency - 1) < 0.01]
        assert near["order"].nunique() >= 5
    bands = [line for line in axes.lines if line.get_label().startswith("_")]
    assert [line.get_xdata()[0] for line in bands] == list(modes["frequency"])
    indicator = identification.data["indicator"]
    [curve] = axes.figure.axes[1].lines  # behind the poles
    assert axes.figure.axes[1].get_yscale() == "log"
    np.testing.assert_array_equal(curve.get_xdata(), indicator["frequency"])
    assert axes.get_xlabel() == "frequency in Hz" and axes.get_ylabel() == "order"
    own = pyplot.figure().add_subplot()
    assert found.plot.stability(ax=own) is own


def test_an_identification_without_the_diagram_says_so(tmp_path):
    (tmp_path / "identification.json").write_text(json.dumps({"title": "a test", "modes": []}))
    with pytest.raises(plica.MissingData, match="has no stabilisation diagram"):
        stability.draw(Identification(Folder(tmp_path)))
