"""Responses and signals to and from other packages, and universal files."""
import numpy as np
import pytest

import plica
from plica import Frf
from plica.exchange import pyfbs, pyuff, sdypy
from plica.frf import stack
from plica.uff58 import read_uff58
from plica.uff58_writer import write_uff58


@pytest.fixture
def frf():
    f = np.array([10.0, 20.0, 30.0, 45.0])
    rng = np.random.default_rng(3)
    H = rng.normal(size=(4, 3, 2)) + 1j * rng.normal(size=(4, 3, 2))
    return Frf(f, H, ("mid.x", "mid.y", "tip.z"), ("mid.y", "tip.z"), "m/s2 per N")


def same(a, b, **tolerance):
    assert a.outputs == b.outputs and a.inputs == b.inputs and a.unit == b.unit
    np.testing.assert_allclose(a.frequency, b.frequency, **tolerance)
    np.testing.assert_allclose(a.H, b.H, **tolerance)


def test_universal_file_of_a_run_is_its_csv(bellows):
    found = pyuff.from_pyuff(read_uff58(bellows.path / "responses.uff"))
    assert sorted(column for one in found for column in one.inputs) == ["base.x", "base.y"]
    for one in found:
        assert one.unit == "m/s2 per m/s2"
        for column in one.inputs:
            csv = bellows.responses[column[-1]].frf
            for output in csv.outputs:
                np.testing.assert_allclose(one.channel(output, column), csv.channel(output),
                                           rtol=1e-11, atol=1e-30)


@pytest.mark.parametrize("even", [True, False])
def test_pyuff_there_and_back_and_through_a_file(frf, tmp_path, even):
    if even:
        frf = Frf(np.arange(1.0, 5.0), frf.H, frf.outputs, frf.inputs, frf.unit)
    sets = pyuff.to_pyuff(frf)
    assert sets[0]["rsp_dir"] == 1 and sets[0]["abscissa_spacing"] == int(even)
    same(pyuff.from_pyuff(sets)[0], frf)
    write_uff58(tmp_path / "f.uff", sets)
    same(pyuff.from_pyuff(read_uff58(tmp_path / "f.uff"))[0], frf, rtol=1e-12)
    with pytest.raises(FileExistsError):
        write_uff58(tmp_path / "f.uff", sets)


def test_transmissibility_is_a_function_type_that_pyuff_writes(frf):
    """It refuses 5; the units on both sides and the input tell what the response is."""
    one = Frf(frf.frequency, frf.H[:, :, :1], frf.outputs, ("base.y",), "m/s2 per m/s2")
    sets = pyuff.to_pyuff(one)
    assert {s["func_type"] for s in sets} <= {0, 1, 2, 3, 4, 6, 9}
    same(pyuff.from_pyuff(sets)[0], one)
    same(pyuff.from_pyuff([{**s, "func_type": 5} for s in sets])[0], one)


@pytest.mark.parametrize("driven, unit", [("mid.z", "m/s2 per N"), ("base.z", "m/s2 per m/s2")])
def test_the_program_reads_what_is_written(tmp_path, driven, unit):
    f = np.arange(20.0, 60.0, 0.1)
    w, w0 = 2 * np.pi * f, 2 * np.pi * 40
    H = (driven == "base.z") + w ** 2 / (w0 ** 2 - w ** 2 + 2j * 0.01 * w0 * w)
    one = Frf(f, H[:, None, None], ("mid.z",), (driven,), unit)
    write_uff58(tmp_path / "hit.uff", pyuff.to_pyuff(one))
    found = plica.identify(tmp_path / "hit.uff", tmp_path / "out").identification.modes
    assert found["frequency"][0] == pytest.approx(40, rel=1e-5)
    assert found["damping"][0] == pytest.approx(0.01, rel=1e-3)


def test_binary_universal_files_of_both_byte_orders(tmp_path):
    for order, number in (("<", 1), (">", 2)):
        values = np.array([1.5, -2.5, 3.0, 4.0], dtype=order + "f8")  # two complex numbers
        head = (f"    -1\n    58b{number:6d}{2:6d}{11:12d}{values.nbytes:12d}"
                f"{0:6d}{0:6d}{0:12d}{0:12d}\n")
        lines = ["NONE"] * 5
        lines.append(f"{4:5d}{0:10d}{0:5d}{0:10d} {'mid':10}{1:10d}{2:4d} {'mid':10}{1:10d}{2:4d}")
        lines.append(f"{6:10d}{2:10d}{1:10d}{5:13.5e}{0.5:13.5e}{0:13.5e}")
        lines += [f"{18:10d}{0:5d}{0:5d}{0:5d} {'f':20} {'Hz':20}"] * 4
        tail = b"\n    -1\n    -1\n   151\nleft out\n    -1\n"
        data = (head + "\n".join(lines) + "\n").encode() + values.tobytes() + tail
        (tmp_path / "b.uff").write_bytes(data)
        [one] = read_uff58(tmp_path / "b.uff")
        np.testing.assert_array_equal(one["data"], [1.5 - 2.5j, 3 + 4j])
        np.testing.assert_array_equal(one["x"], [5, 5.5])
        (tmp_path / "b.uff").write_bytes(data[:len(data) - len(tail) - 9])
        with pytest.raises(plica.BrokenFolder, match="data set 1 of type 58"):
            read_uff58(tmp_path / "b.uff")


@pytest.mark.parametrize("abscissa", ["f4", "f8"])
@pytest.mark.parametrize("stated", [0, 24, 1000])
def test_binary_uneven_abscissa_and_a_wrong_number_of_bytes(frf, tmp_path, abscissa, stated):
    """pyuff writes the abscissa double, and says half the bytes of complex numbers."""
    [one] = pyuff.to_pyuff(Frf(frf.frequency, frf.H[:, :1, :1], ("mid.x",), ("mid.y",), frf.unit))
    write_uff58(tmp_path / "text.uff", [one])
    head = (tmp_path / "text.uff").read_bytes().splitlines(keepends=True)[:13]
    head[1] = f"    58b{1:6d}{2:6d}{11:12d}{stated:12d}{0:6d}{0:6d}{0:12d}{0:12d}\n".encode()
    rows = np.zeros(4, [("x", "<" + abscissa), ("re", "<f8"), ("im", "<f8")])
    rows["x"], rows["re"], rows["im"] = frf.frequency, one["data"].real, one["data"].imag
    (tmp_path / "b.uff").write_bytes(b"".join(head) + rows.tobytes() + b"    -1\n")
    [found] = read_uff58(tmp_path / "b.uff")
    np.testing.assert_array_equal(found["x"], frf.frequency)
    np.testing.assert_array_equal(found["data"], one["data"])


def test_pyfbs_tells_rotations(frf):
    turning = Frf(frf.frequency, frf.H, ("mid.x", "mid.y", "tip.rz"), ("mid.y", "tip.rz"),
                  "m/s2 per N")
    there = pyfbs.to_pyfbs(turning)
    assert list(there.df_chn["Quantity"]) == ["Acceleration"] * 2 + ["Angular Acceleration"]
    assert list(there.df_imp["Quantity"]) == ["Force", "Moment"]
    assert there.df_chn["Direction_3"][2] == 1
    same(pyfbs.from_pyfbs(*there), turning)


def test_pyfbs_there_and_back(frf):
    there = pyfbs.to_pyfbs(frf, {"mid": [0, 0.1, 0.2]})
    assert there.Y.shape == (4, 3, 2)
    assert list(there.df_chn["Direction_2"]) == [0, 1, 0]
    assert there.df_chn["Position_3"][0] == 0.2 and there.df_imp["Quantity"][0] == "Force"
    same(pyfbs.from_pyfbs(*there), frf)
    for unit in ("m/s2 per m/s2", "m per N", "N per m/s", "rad/s2 per Nm", "m/s2", ""):
        other = Frf(frf.frequency, frf.H, frf.outputs, frf.inputs, unit)
        same(pyfbs.from_pyfbs(*pyfbs.to_pyfbs(other)), other)
    assert pyfbs.from_pyfbs(*there, unit="m per N").unit == "m per N"
    bare = [table.drop(columns="Quantity") for table in (there.df_chn, there.df_imp)]
    assert pyfbs.from_pyfbs(there.Y, there.freq, *bare).unit == "m/s2 per N"
    bare[0]["Unit"] = "m/s"
    assert pyfbs.from_pyfbs(there.Y, there.freq, *bare).unit == "m/s per N"


def test_sdypy_there_and_back(frf):
    H, frequency = sdypy.to_sdypy(frf, "tip.z")
    assert H.shape == (3, 4)
    back = sdypy.from_sdypy(H, frequency, frf.outputs, ["tip.z"])
    np.testing.assert_array_equal(back.channel("mid.y"), frf.channel("mid.y", "tip.z"))
    both = stack([sdypy.from_sdypy(sdypy.to_sdypy(frf, i)[0], frequency, frf.outputs, [i])
                  for i in frf.inputs])
    same(both, frf)
    same(sdypy.from_sdypy(frf.H.transpose(1, 2, 0), frequency, frf.outputs, frf.inputs), frf)


def test_sep005_there_and_back():
    signals = plica.Signals(200.0, np.arange(6.0).reshape(3, 2), ("base.y", "mid.y"),
                            ("m/s2", "m/s2"))
    channels = sdypy.to_sep005(signals)
    assert [set(c) for c in channels] == [{"data", "fs", "name", "unit_str", "quantity"}] * 2
    assert channels[0]["quantity"] == "a"
    back = sdypy.from_sep005(channels, base="y", reference="base.y")
    np.testing.assert_array_equal(back.data, signals.data)
    assert back.rate == 200 and back.units == signals.units and back.entry["base"] == "y"
    timed = [{"data": c["data"], "time": np.arange(3) / 200, "name": c["name"], "unit_str": None}
             for c in channels]
    assert sdypy.from_sep005(timed).rate == pytest.approx(200)


def test_sep005_with_several_channels_in_one_dict():
    data = np.arange(8.0).reshape(2, 4)
    one = {"data": data, "fs": 100, "name": "test 1", "channel_name": ["base.y", "mid.y"],
           "unit_str": ["m/s2", None], "quantity": "a", "start_timestamp": "2026-01-01T00:00:00"}
    found = sdypy.from_sep005(one, base="y")
    assert found.channels == ("base.y", "mid.y") and found.units == ("m/s2", "")
    np.testing.assert_array_equal(found.data, data.T)
    assert sdypy.from_sep005([{**one, "unit_str": "g"}]).units == ("g", "g")
    for change, says in [({"channel_name": ["base.y"]}, "as many names in channel_name"),
                         ({"unit_str": ["g"]}, "as many in unit_str"),
                         ({"starttimestamp": ""}, "starttimestamp', which SEP 005 prohibits"),
                         ({"Fs": 100}, "'Fs', which SEP 005 prohibits")]:
        with pytest.raises(ValueError, match=says):
            sdypy.from_sep005([{**one, **change}])


@pytest.mark.parametrize("change, says", [
    ({"name": "mid.y"}, "unique name"), ({"unit": "g"}, "prohibits"), ({"fs": 100}, "one rate"),
    ({"data": np.zeros((2, 2))}, "channel_name")])
def test_what_is_not_sep005_is_refused(change, says):
    channels = [{"data": np.zeros(3), "fs": 200, "name": n, "unit_str": ""}
                for n in ("base.y", "mid.y")]
    channels[0].update(change)
    with pytest.raises(ValueError, match=says):
        sdypy.from_sep005(channels)


def test_responses_of_wrong_shape_are_refused(frf):
    with pytest.raises(ValueError, match="lines, outputs, inputs"):
        Frf(frf.frequency, frf.H[:, :2], frf.outputs, frf.inputs)
    with pytest.raises(ValueError, match="do not rise"):
        Frf(frf.frequency[::-1], frf.H, frf.outputs, frf.inputs)
    with pytest.raises(plica.MissingData, match="no channel 'top.x'"):
        frf.channel("top.x", "mid.y")
    with pytest.raises(plica.MissingData, match="2 inputs"):
        frf.channel("mid.x")
