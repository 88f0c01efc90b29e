"""Superelements: every file says the same, and the documented layouts of pyNastran and pyYeti."""
import re
import shutil
import sys

import numpy as np
import pytest
import scipy.linalg

import plica
from plica.exchange import pynastran, pyyeti


def read_op4(path):
    """A dense ASCII OUTPUT4 file, (form, matrix) by name, after Nastran's description of it."""
    lines = iter(path.read_text().splitlines())
    found = {}
    for head in lines:
        columns, rows, form = (int(head[k:k + 8]) for k in (0, 8, 16))
        matrix = np.zeros((rows, columns))
        while True:
            start = next(lines)
            column, first, count = (int(start[k:k + 8]) for k in (0, 8, 16))
            values = []
            while len(values) < count:
                line = next(lines)
                values += [float(line[k:k + 23]) for k in range(0, len(line), 23)]
            if column > columns:
                break
            matrix[first - 1:first - 1 + count, column - 1] = values
        found[head[32:40].strip()] = (form, matrix)
    return found


def nastran_real(field):
    return float(re.sub(r"(?<=[\d.])([+-]\d+)$", r"e\1", field.replace("D", "e")))


def read_dmig(path):
    """{name: {(row label, column label): value}} of the long fields of a deck."""
    found, column = {}, None
    for line in path.read_text().splitlines():
        fields = [line[8 + 16 * k:24 + 16 * k].strip() for k in range(4)]
        if line.startswith("DMIG*"):
            name, column = fields[0], (int(fields[1]), int(fields[2]))
        elif line.startswith("*") and column:
            row = (int(fields[0]), int(fields[1]))
            found.setdefault(name, {})[row, column] = nastran_real(fields[2])
        else:
            column = None
    return found


def test_hdf5_and_matrix_market_say_the_same(bellows):
    h5 = plica.read_superelement(bellows.path / "superelement.h5")
    text = plica.read_superelement(bellows.path / "superelement.json")
    assert h5.node_names == text.node_names == ("left", "right")
    assert h5.coordinates == text.coordinates
    for letter in "KMC":
        np.testing.assert_array_equal(h5.dense(letter), text.dense(letter))
    np.testing.assert_array_equal(h5.recovery["mid"].rows, text.recovery["mid"].rows)
    assert len(h5.loads) == 6 and h5.loads.keys() == text.loads.keys()
    for name, force in h5.loads.items():
        np.testing.assert_array_equal(force, text.loads[name])
    assert h5.stresses["mid"].rows.shape == (12, len(h5.coordinates)) and text.stresses == {}


def test_without_h5py_the_text_files_are_read(bellows, monkeypatch):
    monkeypatch.setitem(sys.modules, "h5py", None)
    with pytest.warns(UserWarning, match="superelement.h5: has stress rows and places .*h5py"):
        found = plica.read_superelement(bellows.path)
    assert found.boundary == 12 and found.stresses == {}
    with pytest.warns(UserWarning, match="which need h5py"):
        assert plica.results(bellows.path).superelement.boundary == 12


def test_it_is_a_craig_bampton_superelement(bellows):
    s = bellows.superelement
    K, M = s.K.toarray(), s.M.toarray()
    assert s.boundary == 12 and s.modal == len(K) - 12
    np.testing.assert_allclose(K, K.T)
    assert np.abs(K[:12, 12:]).max() == 0
    rigid = s.rigid_motions()
    assert np.abs(rigid.T @ K @ rigid).max() < 1e-9 * np.abs(K).max()
    mass = rigid.T @ M @ rigid
    assert mass[0, 0] == pytest.approx(bellows.data["model"]["mass"], rel=1e-6)
    held = np.sqrt(scipy.linalg.eigvalsh(K[12:, 12:], M[12:, 12:])) / (2 * np.pi)
    np.testing.assert_allclose(np.sort(s.fixed_frequencies), held, rtol=1e-12)
    assert list(s.nodes["name"]) == ["left", "right"] and s.nodes.attrs["units"]["x"] == "m"


def test_its_modes_are_those_of_the_part(bellows):
    s = bellows.superelement
    lowest = np.sort(s.fixed_frequencies)[:4]
    np.testing.assert_allclose(lowest, bellows.modes["frequency"], rtol=1e-6)


def test_response_of_the_superelement_is_that_of_the_run(bellows):
    """Both ends on the table: q of (K + iwC - w^2 M) q = f, then the row of the sensor."""
    s, frf = bellows.superelement, bellows.responses["y"].frf
    modal = slice(s.boundary, None)
    K, M, C = (s.dense(letter)[modal, modal] for letter in "KMC")
    force = s.loads["base y per m/s2"][modal]
    row = s.recovery["mid"].rows[1, modal]
    lines = [(f, H) for f, H in zip(frf.frequency, frf.channel("mid.y")) if f < 1200]
    assert len(lines) > 50
    for f, H in lines:  # the run has four modes, the last of them at 1.7 kHz
        w = 2 * np.pi * f
        q = np.linalg.solve(K + 1j * w * C - w ** 2 * M, force)
        assert abs(1 - w ** 2 * row @ q - H) < 0.01 * max(1, abs(H))


def test_op4_of_the_program_is_what_pynastran_would_be_given(bellows):
    file, ours = read_op4(bellows.path / "superelement.op4"), \
        pynastran.to_op4(bellows.superelement)
    assert file.keys() == ours.keys()
    for name, (form, matrix) in ours.items():
        assert form == file[name][0] == (2 if name == "OTMPLICA" else 6)
        np.testing.assert_array_equal(matrix, file[name][1])
    back = pynastran.from_op4(file)
    np.testing.assert_array_equal(back["K"], bellows.superelement.dense("K"))


def test_dmig_of_the_program_is_what_pynastran_would_be_given(bellows):
    file = read_dmig(bellows.path / "superelement.bdf")
    s = bellows.superelement
    ours = pynastran.to_dmig(s)
    for name in ("KPLICA", "MPLICA"):
        entry = ours[name]
        assert set(entry) == {"name", "ifo", "tin", "tout", "polar", "ncols", "GCj", "GCi", "Real"}
        assert entry["ifo"] == 6 and entry["tin"] == 2
        triangle = dict(zip(zip(entry["GCi"], entry["GCj"]), entry["Real"]))
        assert triangle.keys() == file[name].keys()
        for label, value in triangle.items():
            rest = file[name + "L"].get(label, 0)
            assert file[name][label] + rest == pytest.approx(value, rel=1e-15)
    labels = pynastran.labels(s)
    assert labels[0] == (101, 1) and labels[12] == (1001, 0)
    order = np.random.default_rng(1).permutation(len(labels))
    K = s.dense("K")[np.ix_(order, order)]
    rows = {i: labels[k] for i, k in enumerate(order)}
    np.testing.assert_array_equal(pynastran.from_dmig(K, rows, labels), s.dense("K"))


def test_pyyeti_frames_go_there_and_back(bellows):
    s = bellows.superelement
    frames = pyyeti.to_dmig(s)
    assert frames["KPLICA"].index.names == ["id", "dof"]
    assert frames["KPLICA"].loc[(101, 2), (101, 2)] == s.dense("K")[1, 1]
    left_out = {name: frame.loc[frame.any(axis=1), frame.any(axis=0)]
                for name, frame in frames.items()}
    back = pyyeti.from_dmig(left_out, s)
    for letter in "KMC":
        np.testing.assert_array_equal(back[letter], s.dense(letter))
    cb = pyyeti.to_craig_bampton(s)
    assert np.abs(cb["kcb"][np.ix_(cb["bset"], cb["qset"])]).max() == 0


def test_pyyeti_gets_the_places_of_the_boundary(bellows):
    """A row a coordinate, six a grid: the layout of its USET tables; rigid motions as it makes
    them of the table are those of the superelement."""
    s = bellows.superelement
    uset = pyyeti.to_uset(s)
    assert list(uset.columns) == ["nasset", "x", "y", "z"] and len(uset) == s.boundary
    assert uset.index.names == ["id", "dof"] and set(uset["nasset"]) == {2097154}
    place, system, origin, *axes = uset.loc[102][["x", "y", "z"]].to_numpy()
    np.testing.assert_array_equal(place, s.places[1])
    np.testing.assert_array_equal([system, origin, *axes],
                                  [[0, 1, 0], [0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    cb = pyyeti.to_craig_bampton(s)
    moved = s.rigid_motions()[:s.boundary]
    grounded = cb["kcb"][:s.boundary, :s.boundary] @ moved
    assert np.abs(grounded).max() < 1e-6 * np.abs(cb["kcb"]).max()


def test_what_is_broken_is_said(bellows, tmp_path):
    (tmp_path / "superelement.h5").write_bytes(b"no HDF5")
    with pytest.raises(plica.BrokenFolder, match="superelement.h5"):
        plica.read_superelement(tmp_path)
    with pytest.raises(plica.MissingData, match="no matrix D"):
        bellows.superelement.D


@pytest.mark.parametrize("listed", [True, False])
def test_a_cut_matrix_is_broken(bellows, tmp_path, listed):
    folder = tmp_path / "copy"
    shutil.copytree(bellows.path, folder)
    if not listed:
        (folder / "plica_files.json").unlink()
    file = folder / "superelement_k.mtx"
    file.write_bytes(file.read_bytes()[:-5])
    with pytest.raises(plica.BrokenFolder, match="superelement_k.mtx: is (damaged|cut)"):
        plica.read_superelement(folder / "superelement.json")


def test_a_lost_hdf5_is_broken(bellows, tmp_path):
    shutil.copytree(bellows.path, tmp_path / "copy")
    (tmp_path / "copy" / "superelement.h5").unlink()
    with pytest.raises(plica.BrokenFolder, match="superelement.h5: is missing"):
        plica.read_superelement(tmp_path / "copy")


def test_a_lost_matrix_and_a_damaged_document_are_broken(bellows, tmp_path):
    folder = tmp_path / "copy"
    shutil.copytree(bellows.path, folder)
    (folder / "superelement_c.mtx").unlink()
    with pytest.raises(plica.BrokenFolder, match="superelement_c.mtx is missing"):
        plica.read_superelement(folder / "superelement.json")
    for text in ("{}", "[]", '{"nodes": 3}'):
        (tmp_path / "superelement.json").write_text(text)
        with pytest.raises(plica.BrokenFolder, match="superelement.json: is damaged"):
            plica.read_superelement(tmp_path)
