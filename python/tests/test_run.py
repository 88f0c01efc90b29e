"""Runs: options of the program, errors, progress, Ctrl-C, side by side."""
import inspect
import json
import pickle
import re
import shutil
import stat
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from conftest import CASES, HERE

import plica
from plica import arguments, bar, child, program


def test_options_are_those_that_the_help_of_the_program_lists(executable):
    """All of every command, and none that the program does not take."""
    for name in program.schema()["commands"]:
        text = subprocess.run([executable, name, "--help"], capture_output=True, text=True,
                              check=True).stdout
        listed = set(re.findall(r"^ +(?:-\w,)?--([A-Za-z][A-Za-z-]*)", text, re.MULTILINE))
        named = {option.name for option in plica.options(name).values()}
        assert named - {"messages"} == listed - {"help"}, name


def test_functions_show_the_options_of_the_program_as_their_keywords(use, fake, executable):
    for function, name in ((plica.run, "run"), (plica.Case.fit, "fit"), (plica.compare, "compare")):
        shown = inspect.signature(function).parameters
        own = set(plica.options(name)) - {"messages"}
        assert own <= set(shown) and "options" not in shown and "progress" in shown
    assert list(inspect.signature(plica.run).parameters)[:2] == ["case", "out"]
    assert "yield_" in plica.options("ejma")  # a word of Python's own
    assert inspect.signature(plica.run).parameters["no_variants"].annotation == "bool | None"
    use(fake)  # another program, other options
    assert "brand_new" in inspect.signature(plica.run).parameters
    assert "no_variants" not in inspect.signature(plica.run).parameters


FOR_SHELLS = {"completion", "manual"}  # what a terminal asks for


def test_every_command_of_the_program_is_a_function(executable):
    """And every option of it reaches the program: a flag, a choice, a number, a text."""
    for name in set(program.schema()["commands"]) - FOR_SHELLS:
        assert callable(getattr(plica, name)) and name in plica.__all__, name
        command = program.command(name)
        for keyword, option in command.options.items():
            number = 3 if option.min is None else int(option.min)
            value = {"flag": True, "whole": number, "number": float(number)}.get(option.kind, "a")
            value = option.choices[0] if option.choices else value
            found = arguments.words(command, {keyword: value})
            assert found[0] == f"--{option.name}" and found[1:] in ([], [str(value)]), keyword


def test_starter_files_and_schemas(tmp_path):
    for kind in plica.options("init")["kind"].choices:
        if kind != "measured":
            case = plica.init(tmp_path / kind / f"{kind}.yaml", kind=kind) \
                if (tmp_path / kind).mkdir() is None else None
            assert "valid" in case.check().text
    with pytest.raises(plica.OptionError, match="kind='hose'; bellows or decoupler"):
        plica.init(tmp_path / "a.yaml", kind="hose")
    with pytest.raises(plica.CaseError, match="decoupler.yaml"):
        plica.init(tmp_path / "decoupler" / "decoupler.yaml")  # is there
    assert "parts" in plica.schema()["properties"]
    assert plica.schema("commands") == program.schema()


def test_unknown_and_wrong_options():
    beam = CASES / "beam.yaml"
    for options, says in [
            ({"thread": 2}, "did you mean 'threads'"), ({"threads": -1}, "from 0 to 256"),
            ({"threads": 1.5}, "a whole number"), ({"threads": True}, "a whole number"),
            ({"no_variants": 3}, "True or False"),
            ({"geometry": ["stl", "step"]}, "msh or uff"),
            ({"threads": [1, 2]}, "a whole number"),
            ({"write_deck": "abaqus"}, "plica.write_deck")]:
        with pytest.raises(plica.OptionError, match=says):
            plica.run(beam, **options)
    with pytest.raises(plica.OptionError, match=r"json prints and writes no results; plica.results"
                                                r"\(out\).ejma"):
        plica.ejma(beam, json=True)
    with pytest.raises(plica.OptionError, match="begins like an option"):
        plica.run("-beam.yaml")
    assert "no_variants" in plica.options("run")
    assert "--" not in str(program.command("run"))


def test_options_reach_the_program(tmp_path):
    plica.run(CASES / "beam.yaml", tmp_path / "a", geometry=["stl", "obj"], threads=1,
              no_variants=False, model=None)
    assert (tmp_path / "a" / "part.obj").is_file() or list((tmp_path / "a").glob("*.obj"))
    deck = plica.write_deck(CASES / "beam.yaml", tmp_path / "b", "nastran")
    assert deck.read_text().strip()
    with pytest.raises(plica.CaseError, match="model"):
        plica.run(CASES / "beam.yaml", tmp_path / "c", model="pipe")


def test_a_case_with_errors_gives_all_of_them(tmp_path):
    text = (CASES / "beam.yaml").read_text().replace("nu: 0.3", "nu: 3").replace("E: ", "EE: ")
    (tmp_path / "bad.yaml").write_text(text)
    for command in (plica.run, plica.check, plica.reduce):
        with pytest.raises(plica.CaseError) as caught:
            command(tmp_path / "bad.yaml")
        problems = caught.value.problems
        assert {p.key for p in problems} == {"materials.steel.nu", "materials.steel.EE"}
        assert all(p.line == 4 and p.file.endswith("bad.yaml") for p in problems)
        assert "did you mean 'E'" in "".join(p.allowed for p in problems)
        said = str(caught.value).splitlines()  # all of them, each with its place
        assert len(said) == 2 and all("bad.yaml:4: materials.steel." in line for line in said)
    with pytest.raises(plica.CaseError, match="nowhere.yaml: file not found") as caught:
        plica.run("nowhere.yaml")
    assert caught.value.problems[0].file == "nowhere.yaml"


def test_problems_of_the_case_and_of_its_test_come_at_once(tmp_path):
    text = (CASES / "beam.yaml").read_text()
    (tmp_path / "lab.yaml").write_text(
        "specimen: beam\nmass: {value: heavy}\nmodes: [{shape: big}]\n")
    (tmp_path / "bad.yaml").write_text(text.replace("E: ", "EE: ") + "measured: lab.yaml\n")
    (tmp_path / "good.yaml").write_text(text + "measured: lab.yaml\n")
    of_test = {("lab.yaml", "mass.value"), ("lab.yaml", "modes[0].shape"),
               ("lab.yaml", "modes[0].frequency")}
    for command in (plica.run, plica.check, plica.fit, plica.diagnose):
        for file, more in (("bad.yaml", {("bad.yaml", "materials.steel.EE")}),
                           ("good.yaml", set())):
            with pytest.raises(plica.CaseError) as caught:
                command(tmp_path / file)
            assert {(Path(p.file).name, p.key) for p in caught.value.problems} == of_test | more
            assert str(caught.value).count("\n") == len(caught.value.problems) - 1
    (tmp_path / "bad.yaml").write_text(text.replace("E: ", "EE: ") + "measured: none.yaml\n")
    with pytest.raises(plica.CaseError) as caught:
        plica.run(tmp_path / "bad.yaml")
    assert [p.key for p in caught.value.problems] == ["materials.steel.EE", "measured"]


def test_a_check_reads_the_responses_of_the_test_too(tmp_path):
    shutil.copytree(HERE.parent.parent / "cases" / "bolted_lap", tmp_path / "lap")
    (tmp_path / "lap" / "z_3.csv").write_text("frequency [Hz]\n1\n")
    with pytest.raises(plica.CaseError, match="z_3.csv"):
        plica.check(tmp_path / "lap" / "bolted_lap.yaml")


def test_a_run_says_its_share(executable, tmp_path):
    """Of all stages, with the error bars and variants that follow; it does not fall."""
    for case, options in ((CASES / "beam.yaml", []), (CASES / "levels.yaml", []),
                          (CASES / "bellows.yaml", [])):
        done = subprocess.run([executable, "run", case, "--out", tmp_path / case.stem, "--messages",
                               "json", *options], capture_output=True, text=True, check=True)
        said = [json.loads(line) for line in done.stderr.splitlines()]
        shares = [m["share"] for m in said if m["kind"] == "progress"]
        assert shares[0] is None and None not in shares[2:], shares
        known = [share for share in shares if share is not None]
        assert known == sorted(known) and len(set(known)) >= 3 and 0.9 < known[-1] < 1
        assert [m["kind"] for m in said].count("written") == 1


def test_a_check_of_a_good_case():
    assert "valid" in plica.check(CASES / "beam.yaml").text
    assert "valid" in plica.Case(CASES / "beam.yaml").check().text


def test_a_verdict_that_failed_leaves_its_results(tmp_path):
    """No mode lies in the band: exit code 2, and the files are there."""
    pipe = plica.Case(HERE.parent / "examples" / "cases" / "pipe.yaml")
    with pytest.raises(plica.NumericalVerdict, match="the results are in") as caught:
        pipe.reduce(tmp_path, cutoff=4000)  # not even the first frequency of the free part is met
    results = plica.results(caught.value.folder)
    assert not results.certificate["passed"] and results.superelement.boundary == 12


def test_a_model_too_large_for_the_machine(monkeypatch, tmp_path):
    monkeypatch.setenv("PLICA_MEMORY", "0.01")
    case = plica.Case(CASES / "beam.yaml")
    for work in (case.check, lambda: case.run(tmp_path)):
        with pytest.raises(plica.TooLarge, match="GB; PLICA_MEMORY is 0.01 GB") as caught:
            work()
        assert caught.value.code == 4


def test_how_a_newer_program_ends(use, fake, tmp_path):
    use(fake)
    for word, error, says in [("unproved", plica.NumericalVerdict, "a mode is missing"),
                              ("broken", plica.ProgramFailed, "ended with 3: an error within")]:
        (tmp_path / f"{word}.yaml").write_text(word)
        with pytest.raises(error, match=says):
            plica.run(tmp_path / f"{word}.yaml", tmp_path / word)


def test_no_program(use, monkeypatch, tmp_path):
    with pytest.raises(plica.NoExecutable, match="/nowhere/plica"):
        use("/nowhere/plica")
    program._named.clear()
    monkeypatch.setenv("PLICA", "")
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(plica.NoExecutable, match="on PATH; install"):
        plica.run(CASES / "beam.yaml")


def test_a_program_of_another_version(use, tmp_path):
    """By what it says as data, whatever it prints for people; or it says nothing such."""
    says = [('{"plica_version": "0.7.2", "commands": {}}', "Plica 0.7.2, this package reads 0.1"),
            ('{"plica_version": "new"}', "'new' is no version"),
            ("plica 0.1.0", "does not say which version"), ("[1]", "does not say which version"),
            (r"\377\376 hello", "does not say which version")]
    for k, (text, error) in enumerate(says):
        path = tmp_path / f"plica{k}"
        path.write_text(f"#!/bin/sh\nprintf '{text}'\n")
        path.chmod(stat.S_IRWXU)
        with pytest.raises(plica.VersionError, match=error):
            use(path)


def test_what_is_no_program(use, tmp_path):
    """A folder, a file that may not be run, one that is none: each with what would be right."""
    (tmp_path / "text").write_text("words\n")
    for path in (tmp_path, tmp_path / "text"):
        with pytest.raises(plica.NoExecutable, match="is no program that can be run; the path of "):
            use(path)
    (tmp_path / "text").chmod(stat.S_IRWXU)
    with pytest.raises(plica.NoExecutable, match="text: cannot be run: "):
        use(tmp_path / "text")


def test_a_bar_without_tqdm_is_a_word(monkeypatch):
    monkeypatch.setitem(sys.modules, "tqdm", None)
    with pytest.warns(UserWarning, match="no bar of progress: .*apt install python3-tqdm"):
        assert bar.Bar("t", True).bar is None


def test_side_by_side_gives_the_same_numbers(tmp_path, beam):
    def one(k):
        return plica.run(CASES / "beam.yaml", tmp_path / str(k), threads=1)
    with ThreadPoolExecutor(2) as pool:
        for results in pool.map(one, range(4)):
            assert list(results.modes["frequency"]) == list(beam.modes["frequency"])


def test_messages_progress_and_new_options_of_a_newer_program(use, fake, tmp_path):
    use(fake)
    assert "brand_new" in plica.options("run")
    good = tmp_path / "good.yaml"
    good.write_text("case: a\n")
    assert plica.run(good, tmp_path / "o", brand_new=3, progress=True).case == "fake"
    shown = []
    shown_bar = bar.Bar("t", True)
    shown_bar.show("modes", 0.5)
    assert shown_bar.bar.n == 0.5 and " 50%" in str(shown_bar.bar)
    shown_bar.show("stress", None)
    assert re.fullmatch(r"t: \|#         \| 00:\d\d, stress", str(shown_bar.bar).strip())
    shown_bar.begun -= 1
    shown_bar.shown -= 1
    shown_bar.tick()
    assert re.fullmatch(r"t: \| {4,7}# {2,5}\| 00:\d\d, stress", str(shown_bar.bar).strip())
    shown_bar.__exit__()
    said = child.call([str(fake), "run", str(good), "--out", str(tmp_path / "p"), "--messages",
                       "json"], "t", False)
    assert said.warnings == ["a doubt"] and said.code == 0 and not shown
    (tmp_path / "wrong.yaml").write_text("wrong\n")
    with pytest.raises(plica.CaseError) as caught:
        plica.run(tmp_path / "wrong.yaml", tmp_path / "q")
    assert [(p.line, p.key) for p in caught.value.problems] == [(2, "key2"), (5, "key5")]


ERRORS = [
    plica.CaseError([plica.Problem("a.yaml", 2, "k", "is wrong", "right"),
                     plica.Problem("a.yaml", 0, "", "is short")], "and more"),
    plica.CaseError([], "no place"), plica.NumericalVerdict("a mode is missing", Path("o")),
    plica.ProgramFailed("ended with 3", 3), plica.TooLarge("9 GB", 4),
    *(kind("a text") for kind in (plica.PlicaError, plica.NoExecutable, plica.VersionError,
                                  plica.BrokenFolder, plica.MissingData, plica.MissingPackage,
                                  plica.OptionError))]


def test_errors_come_whole_out_of_other_processes():
    kinds = {v for v in vars(plica).values() if isinstance(v, type) and issubclass(v, Exception)}
    assert kinds == {type(error) for error in ERRORS}
    for error in ERRORS:
        error.add_note("a note")
        again = pickle.loads(pickle.dumps(error))
        assert type(again) is type(error) and str(again) == str(error)
        assert vars(again) == vars(error) and again.args == error.args
