"""Cases: an edit changes one value and nothing else."""
import fcntl
import os
import re
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
import yaml
from conftest import CASES, SHIPPED

import plica
from plica import yaml_edit, yaml_text

TEXT = """\
# a comment at the head
case: a # its name
materials: {steel: {E: 193 GPa, nu: 0.3}} # one line
parts:
  bellows: # the wall
    type: bellows
    profile:
      - {shape: cuff, length: 2 mm}
      - {shape: U, count: 27, height: 8 mm} # the drawing
    wall:
      plies: [0.25 mm, 0.25 mm]
      bond: 0 # they slip

# sensors come here
sensors:
  - {name: mid, at: [0, 1, 2]}
  - name: tip
    at: [0, 2, 2]
analyses:
  static: true
"""


@pytest.fixture
def case(tmp_path):
    (tmp_path / "a.yaml").write_text(TEXT)
    return plica.Case(tmp_path / "a.yaml")


@pytest.mark.parametrize("path, value, old, new", [
    ("parts.bellows.profile[1].height", "8.5 mm", "height: 8 mm", "height: 8.5 mm"),
    ("parts.bellows.wall.bond", 0.5, "bond: 0 #", "bond: 0.5 #"),
    ("parts.bellows.wall.plies", ["0.2 mm"], "[0.25 mm, 0.25 mm]", "[0.2 mm]"),
    ("parts.bellows.wall.plies[1]", 2e-4, "0.25 mm]", "0.0002]"),
    ("materials.steel.E", "200 GPa +- 5 %", "E: 193 GPa", "E: 200 GPa +- 5 %"),
    ("materials.steel.rho", 8000, "nu: 0.3}", "nu: 0.3, rho: 8000}"),
    ("parts.bellows.wall.slip.chi", -0.5, "bond: 0 # they slip\n",
     "bond: 0 # they slip\n      slip: {chi: -0.5}\n"),
    ("sensors[tip].mass", "5 g", "    at: [0, 2, 2]\n", "    at: [0, 2, 2]\n    mass: 5 g\n"),
    ("sensors[0].at[2]", "3 mm", "[0, 1, 2]", "[0, 1, 3 mm]"),
    ("analyses.modes", {"count": 4}, "  static: true\n",
     "  static: true\n  modes: {count: 4}\n"),
    ("measured", "my test.yaml", "  static: true\n",
     "  static: true\nmeasured: my test.yaml\n"),
    ("materials.steel.E", "3 kN [0.3, 30]", "E: 193 GPa", 'E: "3 kN [0.3, 30]"'),
    ("parts.bellows.wall.bond", None, "      bond: 0 # they slip\n", ""),
    ("materials.steel.nu", None, ", nu: 0.3}", "}"),
    ("materials.steel.E", None, "{E: 193 GPa, nu", "{nu"),
    ("sensors[mid]", None, "  - {name: mid, at: [0, 1, 2]}\n", ""),
])
def test_an_edit_changes_one_value_and_nothing_else(case, path, value, old, new):
    case[path] = value
    assert case.text == TEXT.replace(old, new, 1)
    yaml.safe_load(case.text)


def test_values_are_read_as_written(case):
    assert case["parts.bellows.profile[1].height"] == "8 mm"
    assert case["parts.bellows.wall"] == {"plies": ["0.25 mm", "0.25 mm"], "bond": 0}
    assert case["sensors[tip]"] == {"name": "tip", "at": [0, 2, 2]}
    assert case["parts.bellows.profile"][0]["shape"] == "cuff"
    assert "materials.steel.E" in case and "materials.steel.G" not in case
    with pytest.raises(plica.MissingData, match="no hight; shape, count, height"):
        case["parts.bellows.profile[1].hight"]
    with pytest.raises(plica.MissingData, match=r"no place for 'parts.bellows.profile\[7\].x'"):
        case["parts.bellows.profile[7].x"] = 1
    for path, words in (("", "an empty path; such as parts"), ("a[1.b", r"'a\[1.b' is no path"),
                        (3, "a path is a text, not 3")):
        for wrong in (lambda: case[path], lambda: case.update({path: 1})):
            with pytest.raises(plica.OptionError, match=words):
                wrong()


@pytest.mark.parametrize("bom", ["", "\ufeff"], ids=["plain", "bom"])
@pytest.mark.parametrize("end", ["\n", "\r\n"], ids=["lf", "crlf"])
def test_byte_order_mark_and_line_ends_stay(tmp_path, bom, end):
    def written(text):
        return (bom + text.replace("\n", end)).encode()
    (tmp_path / "a.yaml").write_bytes(written(TEXT))
    case = plica.Case(tmp_path / "a.yaml")
    assert case["parts.bellows.profile[1].height"] == "8 mm" and case["case"] == "a"
    assert case["parts.bellows.wall"] == {"plies": ["0.25 mm", "0.25 mm"], "bond": 0}
    assert case.save(tmp_path / "b.yaml").read_bytes() == written(TEXT)
    case.copy().save(tmp_path / "b.yaml")
    assert (tmp_path / "b.yaml").read_bytes() == written(TEXT)
    case.update({"parts.bellows.profile[1].height": "8.5 mm", "parts.bellows.wall.bond": None,
                 "analyses.modes": {"count": 4}, "sensors[tip].mass": "5 g", "case": "b"})
    expected = TEXT.replace("height: 8 mm", "height: 8.5 mm").replace("case: a", "case: b") \
        .replace("      bond: 0 # they slip\n", "").replace("at: [0, 2, 2]", "at: [0, 2, 2]\n"
                                                            "    mass: 5 g") \
        + "  modes: {count: 4}\n"
    assert case.save(tmp_path / "b.yaml").read_bytes() == written(expected)
    with case.file() as file:
        assert file.read_bytes() == written(expected)


def test_the_program_runs_a_changed_case_of_windows(tmp_path):
    text = (CASES / "beam.yaml").read_text().replace("\n", "\r\n")
    (tmp_path / "a.yaml").write_bytes(("\ufeff" + text).encode())
    case = plica.Case(tmp_path / "a.yaml").update({"parts.beam.elements": 10, "parts.tip.mass": 1})
    assert case.check().data["model"]["nodes"] == 12


@pytest.mark.parametrize("text, line, words", [
    ("case: a\nparts: [1\nb: 2\n", 3, "YAML syntax: "),
    ("case: a\n\tb: 2\n", 2, "YAML syntax: "),
    ("case: a\nb: \x07\n", 2, "YAML syntax: "),
    ("a: 1\n---\nb: 2\n", 2, "YAML syntax: "),
    ("", 0, "the file is empty; a YAML map"), ("# only\n", 0, "the file is empty"),
    ("\njust text\n", 2, "is no map; a YAML map"), ("- a\n", 1, "is no map"),
])
def test_what_is_wrong_in_the_file_has_its_line(tmp_path, text, line, words):
    path = tmp_path / "a.yaml"
    path.write_text(text)
    case = plica.Case(path)
    for wrong in (lambda: case["parts.x"], lambda: case.update({"parts.x": 1}),
                  lambda: case.update({"parts.x": None}), lambda: "parts.x" in case):
        with pytest.raises(plica.CaseError, match=words) as caught:
            wrong()
        assert [(p.file, p.line) for p in caught.value.problems] == [(str(path), line)]
    assert case.text == text


def test_a_path_is_its_text_and_what_is_no_value_is_said(case):
    case["measured"] = Path("lab") / "a.yaml"
    assert case["measured"] == "lab/a.yaml" and "\nmeasured: lab/a.yaml\n" in case.text
    for value in ({1, 2}, 1j, b"8 mm", [object()]):
        with pytest.raises(plica.OptionError, match="is no value of a case: .*; a text with a"):
            case["case"] = value


@pytest.mark.parametrize("run", [plica.Case.run, plica.run])
def test_results_are_of_their_own_run(tmp_path, monkeypatch, run):
    monkeypatch.chdir(tmp_path)
    case = plica.Case(CASES / "beam.yaml")
    first = run(case, threads=1)
    kept, read = first.headline, run(case, "mine", threads=1)
    case["parts.tip.mass"] = "400 g"
    second = run(case, threads=1)
    assert second.headline != kept == first.headline == read.headline  # what was read stays
    for late in (lambda: first.table("modes"), lambda: first.mesh, lambda: first.stress):
        with pytest.raises(plica.BrokenFolder, match="out: another run has been written there"):
            late()
    sheet = case.reduce("mine", threads=1)
    assert len(read.table("modes")) and sheet.superelement and read.superelement
    unread = run(case, "mine", threads=1)
    run(case, "mine", threads=1)
    with pytest.raises(plica.BrokenFolder, match="give each run an `out` of its own"):
        unread.headline
    assert plica.results("mine").headline == second.headline  # the folder as it is


def test_two_at_once_into_one_folder(tmp_path):
    """The second is refused before it computes, and what the first wrote stays."""
    out = tmp_path / "out"
    first = plica.run(CASES / "beam.yaml", out, threads=1)
    with open(out / ".plica.lock", "w") as lock:
        fcntl.lockf(lock, fcntl.LOCK_EX)
        with pytest.raises(plica.CaseError, match=rf"out: another plica \(process {os.getpid()}\) "
                                                  "is writing here; wait until it has ended, or "):
            plica.run(CASES / "beam.yaml", out, threads=1)
    assert len(first.modes) == 3 and len(first.table("modes")) == 3


def test_of_many_at_once_into_one_folder_each_reads_its_own_or_none(tmp_path):
    def mass_of(grams):
        case = plica.Case(CASES / "beam.yaml").update({"parts.tip.mass": f"{grams} g"})
        try:
            return plica.run(case, tmp_path / "out", threads=1).headline["mass"]
        except (plica.CaseError, plica.BrokenFolder) as error:
            assert re.search("another plica|another run has been written", str(error))
            return None
    with ThreadPoolExecutor(6) as pool:
        found = list(pool.map(mass_of, range(100, 1300, 100)))
    steel = 0.4 * 0.03 * 0.006 * 7850
    assert any(found)
    for grams, mass in zip(range(100, 1300, 100), found):
        assert mass is None or mass == pytest.approx(grams / 1000 + steel, rel=1e-6)


def test_a_copy_is_its_own_and_the_file_stays(case):
    other = case.copy().update({"parts.bellows.wall.bond": 1, "case": "b"})
    assert other.changed and not case.changed and other.digest != case.digest
    assert case.path.read_text() == TEXT
    saved = other.save(case.path.with_name("b.yaml"))
    assert saved.read_text() == other.text


@pytest.mark.parametrize("file", sorted(p for p in SHIPPED.glob("*/*.yaml")
                                        if p.name == p.parent.name + ".yaml"), ids=lambda p: p.stem)
def test_every_shipped_case_can_be_edited_anywhere(file):
    """Each scalar replaced: the data change there and nowhere else, and so does the text."""
    text = file.read_text()
    before = yaml_text.load(text)
    places = list(scalars(before))
    for path, old in places[::max(1, len(places) // 12)]:
        edited = yaml_edit.replaced(text, path, "changed")
        assert yaml_text.value_at(edited, path) == "changed"
        assert yaml_text.load(yaml_edit.replaced(edited, path, old)) == before
        if isinstance(old, str) and "\n" not in text_of(text, path):
            assert len(edited.splitlines()) == len(text.splitlines())


def scalars(data, path=""):
    items = data.items() if isinstance(data, dict) else enumerate(data)
    for key, value in items:
        if not isinstance(key, int) and not re.fullmatch(r"[\w-]+", key):
            continue  # keys of variants are paths themselves
        here = f"{path}[{key}]" if isinstance(key, int) else f"{path}.{key}".lstrip(".")
        if isinstance(value, (dict, list)):
            yield from scalars(value, here)
        else:
            yield here, value


def text_of(text, path):
    node = yaml_text.find(text, path)[1]
    return text[node.start_mark.index:node.end_mark.index]


def test_a_case_that_is_not_there():
    with pytest.raises(plica.CaseError, match="nowhere.yaml: cannot be read"):
        plica.Case("nowhere.yaml")
    assert plica.Case(SHIPPED / "lap_beam").path.name == "lap_beam.yaml"


def test_a_changed_case_finds_its_files_and_keeps_its_name_in_errors(tmp_path):
    case = plica.Case(SHIPPED / "cantilever_masses")
    case["parts.m1.mass"] = "151 g"
    found = case.run(tmp_path / "out", threads=1, no_error_bars=True)
    assert len(found.comparison) > 3  # measured.yaml was beside the original
    case["parts.m1.mass"] = "151 mm"
    case["materials.steel.nu"] = 3
    with pytest.raises(plica.CaseError) as caught:
        case.check()
    assert [p.key for p in caught.value.problems] == ["materials.steel.nu", "parts.m1.mass"]
    assert all(p.file == str(case.path) for p in caught.value.problems)
    lines = TEXT.splitlines(), case.path.read_text().splitlines()
    assert "150 g" in lines[1][caught.value.problems[1].line - 1]


def test_beam_frequency_follows_its_depth(beam, tmp_path):
    case = plica.Case(CASES / "beam.yaml")
    case["parts.beam.section.depth"] = "12 mm"
    case["parts.tip.mass"] = 1e-9
    case["parts.beam.section.width"] = "30 mm"
    stiff = case.run(tmp_path, threads=1)
    length, depth = 0.4, 0.012
    first = 1.8751 ** 2 / (2 * 3.14159265 * length ** 2) * (210e9 / 7850 * depth ** 2 / 12) ** 0.5
    assert stiff.modes["frequency"][1] == pytest.approx(first, rel=5e-3)
