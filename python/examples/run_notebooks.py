"""Runs notebooks without Jupyter: the cells in order, in one name space, their output kept.

    python3 run_notebooks.py                  runs all of this folder, writes nothing
    python3 run_notebooks.py --write A.ipynb  runs one and stores its output in it

What a cell prints, the value of its last expression and the figures it drew are its output.
"""
import argparse
import ast
import base64
import contextlib
import io
import os
import time
from pathlib import Path

import matplotlib
import nbformat

HERE = Path(__file__).resolve().parent


def run(path, write=False):
    """Executes a notebook; the exception of a cell that fails names it. The notebook, run."""
    matplotlib.use("agg")
    notebook = nbformat.read(path, as_version=4)
    names = {"__name__": "__main__"}
    _wide_tables()
    before = os.getcwd()
    os.chdir(HERE)
    try:
        for number, cell in enumerate(notebook.cells, 1):
            if cell.cell_type == "code":
                cell.outputs = outputs_of(cell.source, names, f"{path.name}, cell {number}")
                cell.execution_count = None
    finally:
        os.chdir(before)
    if write:
        nbformat.write(notebook, path)
    return notebook


def _wide_tables():
    """Tables are printed whole, so that the text of an output says all."""
    with contextlib.suppress(ImportError):
        import pandas
        pandas.set_option("display.width", 132, "display.max_columns", 20,
                          "display.max_colwidth", 48)


def outputs_of(source, names, where):
    """The outputs of a cell, as nbformat has them."""
    import matplotlib.pyplot as pyplot
    pyplot.close("all")  # what others drew
    tree = ast.parse(source)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    printed, value = io.StringIO(), None
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, where, "exec"), names)
        if last is not None:
            value = eval(compile(ast.Expression(last.value), where, "eval"), names)
    outputs = []
    if printed.getvalue():
        outputs.append(nbformat.v4.new_output("stream", text=printed.getvalue()))
    figures = [pyplot.figure(n) for n in pyplot.get_fignums()]
    if value is not None and not source.rstrip().endswith(";") and not figures:
        data = {"text/plain": repr(value)}
        if hasattr(value, "_repr_html_"):
            data["text/html"] = value._repr_html_()
        outputs.append(nbformat.v4.new_output("execute_result", data=data))
    for figure in figures:
        image = io.BytesIO()
        figure.savefig(image, format="png", dpi=80, metadata={"Software": None})
        data = {"image/png": base64.b64encode(image.getvalue()).decode(),
                "text/plain": "<Figure>"}
        outputs.append(nbformat.v4.new_output("display_data", data=data))
    pyplot.close("all")
    return outputs


if __name__ == "__main__":
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("notebooks", nargs="*", type=Path)
    arguments.add_argument("--write", action="store_true", help="store the outputs")
    given = arguments.parse_args()
    for file in given.notebooks or sorted(HERE.glob("*.ipynb")):
        begun = time.perf_counter()
        run(file.resolve(), given.write)
        print(f"{file.name}: {time.perf_counter() - begun:.1f} s")
