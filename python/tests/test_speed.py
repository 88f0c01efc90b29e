"""A thousand folders of results in one table: little more than to read their JSON."""
import json
import shutil
import time

import pytest

import plica


def test_a_thousand_results_in_one_table(bellows, tmp_path):
    for k in range(1000):
        folder = tmp_path / f"{k:04d}"
        folder.mkdir()
        shutil.copy(bellows.path / "results.json", folder)
    begun = time.process_time()
    table = plica.collect(tmp_path)
    seconds = time.process_time() - begun
    text = (bellows.path / "results.json").read_text()
    begun = time.process_time()
    for _ in range(1000):
        json.loads(text)
    parsing = time.process_time() - begun
    print(f"1000 results of {len(text)} bytes: {seconds:.2f} s, of it JSON {parsing:.2f} s")
    assert table.shape[0] == 1000 and table["proved"].all()
    assert table["f1"][0] == pytest.approx(bellows.modes["frequency"][1])
    assert seconds < 2 * parsing


def test_nothing_to_collect(tmp_path):
    with pytest.raises(plica.BrokenFolder, match="no results.json below"):
        plica.collect(tmp_path)
