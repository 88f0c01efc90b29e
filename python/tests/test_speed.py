"""A thousand folders of results in one table in two seconds of a processor."""
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
    size = (bellows.path / "results.json").stat().st_size
    print(f"1000 results of {size} bytes: {seconds:.2f} s")
    assert table.shape[0] == 1000 and table["proved"].all()
    assert table["f1"][0] == pytest.approx(bellows.modes["frequency"][1])
    assert seconds < 2


def test_nothing_to_collect(tmp_path):
    with pytest.raises(plica.BrokenFolder, match="no results.json below"):
        plica.collect(tmp_path)
