"""Meshes and shapes: our reader beside meshio's, the arrays that pyvista gets."""
import os
import subprocess
import sys

import meshio
import numpy as np
import pytest
from conftest import CASES

import plica
from plica.mesh import Mesh


def test_vtu_is_read_as_meshio_reads_it(bellows):
    for name in ("modes.vtu", "stress.vtu"):
        ours = plica.vtu.read_vtu(bellows.path / name)
        theirs = meshio.read(bellows.path / name)
        np.testing.assert_array_equal(ours.points, theirs.points)
        np.testing.assert_array_equal(ours.quads, theirs.get_cells_type("quad"))
        assert set(ours.point_data) == set(theirs.point_data)
        for field, values in ours.point_data.items():
            np.testing.assert_array_equal(values, theirs.point_data[field])


def test_shapes_are_mass_normalised_arrays_over_nodes(bellows):
    assert bellows.shapes.shape == (4, len(bellows.mesh.points), 3)
    axial = bellows.shapes[0]
    assert np.abs(axial[:, 1]).max() > 5 * np.abs(axial[:, 0]).max()
    ends = np.ptp(bellows.mesh.points[:, 1])
    held = bellows.mesh.points[:, 1] < 1e-9 * ends
    assert np.abs(axial[held]).max() < 1e-9 * np.abs(axial).max()


def test_meshio_gets_all_cells_and_fields(bellows, beam, tmp_path):
    mesh = bellows.mesh.meshio()
    assert mesh.cells[0].type == "quad" and len(mesh.point_data) == 4
    mesh.write(tmp_path / "m.vtu")
    assert len(meshio.read(tmp_path / "m.vtu").points) == len(bellows.mesh.points)
    assert beam.mesh.meshio().cells[0].type == "line"


def test_pyvista_gets_cells_led_by_their_number_of_corners():
    mesh = Mesh(np.zeros((5, 3)), np.array([0, 1, 2, 3, 3, 4, 0, 1, 2]), np.array([4, 6, 9]),
                np.array([9, 3, 5]), {}, {})
    np.testing.assert_array_equal(mesh.padded_cells(), [4, 0, 1, 2, 3, 2, 3, 4, 3, 0, 1, 2])


def test_without_pyvista_the_error_says_how_to_get_it(beam):
    if plica.optional.have("pyvista"):
        grid = beam.mesh.pyvista()
        assert grid.n_points == len(beam.mesh.points)
    else:
        with pytest.raises(plica.MissingPackage, match="pip install pyvista"):
            beam.mesh.pyvista()


ALONE = """
import sys
for name in ("pandas", "xarray", "h5py", "scipy", "matplotlib", "yaml", "meshio", "tqdm"):
    sys.modules[name] = None
import plica
r = plica.results(sys.argv[1])
assert r.responses["y"].frf.H.shape[1] == 3 and r.shapes.shape[0] == 4
assert r.superelement.dense("K").shape[0] > 12 and r.static.axial > 0
assert plica.run(sys.argv[2], sys.argv[3], threads=1, progress=True).headline["mass"] > 0
for ask in (lambda: r.modes, lambda: r.responses["y"].array, lambda: r.plot(), lambda: r.simulated,
            lambda: r.superelement.K, lambda: plica.Case(sys.argv[2])["case"]):
    try:
        ask()
    except plica.MissingPackage as error:
        print(error)
    else:
        raise AssertionError(ask)
"""


def test_numpy_alone_is_enough_and_the_rest_is_said(bellows, tmp_path):
    path = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run([sys.executable, "-c", ALONE, bellows.path, CASES / "beam.yaml",
                           tmp_path], capture_output=True, text=True, env=path)
    assert done.returncode == 0, done.stderr
    assert len(done.stdout.splitlines()) == 6 and "apt install python3-xarray" in done.stdout


def test_missing_packages_are_named(monkeypatch, bellows):
    for name in plica.optional.DEBIAN:
        with monkeypatch.context() as patch:
            patch.setitem(sys.modules, name, None)
            with pytest.raises(plica.MissingPackage, match="apt install python3-"):
                plica.optional.need(name, "this")
    with monkeypatch.context() as patch:
        patch.setitem(sys.modules, "pandas", None)
        fresh = plica.results(bellows.path)
        assert len(fresh.folder.table("modes")["frequency"]) == 4  # numpy alone
        with pytest.raises(plica.MissingPackage, match="python3-pandas"):
            fresh.modes
