"""Every notebook runs, and its stored output and page are there."""
import subprocess
import sys
from pathlib import Path

import nbformat
import pytest
from conftest import HERE

EXAMPLES = HERE.parent / "examples"
sys.path.insert(0, str(EXAMPLES))
import run_notebooks  # noqa: E402

NOTEBOOKS = sorted(EXAMPLES.glob("*.ipynb"))


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda p: p.stem)
def test_notebook_runs(path, tmp_path, monkeypatch):
    monkeypatch.setenv("PLICA_OUT", str(tmp_path))
    ran = run_notebooks.run(path)
    stored = nbformat.read(path, as_version=4)
    for now, then in zip(ran.cells, stored.cells):
        if now.cell_type == "code":  # the same kinds of output; numbers are asserted in the cells
            assert [kind(o) for o in now.outputs] == [kind(o) for o in then.outputs]


def kind(output):
    return output.output_type, sorted(output.get("data", {}))


def test_a_cell_that_fails_is_named(tmp_path):
    notebook = nbformat.v4.new_notebook()
    notebook.cells = [nbformat.v4.new_code_cell("x = 1\nx"), nbformat.v4.new_code_cell("1 / 0")]
    nbformat.write(notebook, tmp_path / "bad.ipynb")
    with pytest.raises(ZeroDivisionError) as caught:
        run_notebooks.run(tmp_path / "bad.ipynb")
    assert "bad.ipynb, cell 2" in str(caught.traceback[-1].path)


def test_pages_are_what_the_notebooks_say():
    assert len(NOTEBOOKS) == 5
    subprocess.run([sys.executable, EXAMPLES / "to_markdown.py", "--check"], check=True)
    for path in NOTEBOOKS:
        assert "/tmp" not in Path(path.with_suffix(".md")).read_text()
