"""A thousand folders of results in one table: their heads are read, not what lies behind them."""
import json
import shutil
import time

import numpy as np
import pytest

import plica
from plica.collect import KEYS
from plica.head import BLOCK, head_of


def test_a_thousand_results_in_one_table(bellows, tmp_path):
    """A tenth of the time that it takes to parse them: what is at their end is not read."""
    for k in range(1000):
        folder = tmp_path / f"{k:04d}"
        folder.mkdir()
        shutil.copy(bellows.path / "results.json", folder)
    begun = time.process_time()
    table = plica.collect(tmp_path)
    seconds = time.process_time() - begun
    text = (bellows.path / "results.json").read_text()
    begun = time.process_time()
    for _ in range(100):
        json.loads(text)
    parsing = 10 * (time.process_time() - begun)
    print(f"1000 results of {len(text)} bytes in one table: {seconds:.2f} s of a processor, to "
          f"parse them {parsing:.2f} s")
    assert table.shape[0] == 1000 and table["proved"].all()
    assert table["f1"][0] == pytest.approx(bellows.modes["frequency"][1])
    assert table["k_axial"][999] == bellows.static.axial
    assert table.attrs["units"]["f_axial"] == "Hz" and table.attrs["units"]["k_axial"] == "N/m"
    assert len(text) > 100_000 and seconds < 0.5 * parsing


def test_a_head_is_what_the_whole_file_says(bellows, tmp_path):
    path = bellows.path / "results.json"
    whole = json.loads(path.read_text())
    assert head_of(path, KEYS) == {k: whole[k] for k in KEYS}
    assert head_of(path, {*KEYS, "timing", "nowhere"}).keys() == {*KEYS, "timing"}
    order = list(whole)
    assert max(order.index(k) for k in KEYS) < order.index("stress_places")
    # Keys behind more than a block, in which letters of two bytes are cut somewhere.
    for shift in range(3):
        (tmp_path / "a.json").write_text(json.dumps(
            {"a": "x" * shift + "é" * BLOCK, "b": [1.5, {"c": 2}], "d": 12345},
            ensure_ascii=False), encoding="utf-8")
        assert head_of(tmp_path / "a.json", {"b", "d"}) == {"b": [1.5, {"c": 2}], "d": 12345}
    (tmp_path / "a.json").write_text("{}")
    assert head_of(tmp_path / "a.json", {"a"}) == {}


@pytest.mark.parametrize("text, says", [
    ("", "it is cut"), ('{"case": "a", "model": {', "it is cut"), ("[1, 2]}", "there is no {"),
    ('{"case" 1}', "there is no :"), ('{"case": tru}', "Expecting value"), ("{1: 2}", "no \""),
])
def test_a_damaged_head_is_broken(tmp_path, text, says):
    (tmp_path / "results.json").write_text(text)
    with pytest.raises(plica.BrokenFolder, match=f"results.json: is damaged: .*{says}.*run the"):
        plica.collect([tmp_path])


def test_what_cannot_be_collected(bellows, tmp_path):
    with pytest.raises(plica.BrokenFolder, match="no results.json below"):
        plica.collect(tmp_path)
    data = json.loads((bellows.path / "results.json").read_text())
    path = tmp_path / "results.json"
    path.write_text(json.dumps({**data, "plica_version": "0.9.1"}))
    with pytest.raises(plica.VersionError, match="Plica 0.9.1, this package reads 0.1"):
        plica.collect(tmp_path)
    del data["headline"]
    path.write_text(json.dumps(data))
    with pytest.raises(plica.BrokenFolder, match="results.json: has no 'headline'; run the"):
        plica.collect(tmp_path)
    path.unlink()
    (tmp_path / "levels.json").write_text("{}")
    with pytest.raises(plica.MissingData, match="has no results.json; `plica run"):
        plica.collect([tmp_path])
    assert np.isnan(plica.collect([bellows.path]).get("f9", np.nan))
