"""Ctrl-C: what runs ends, what it finished stays, what waits does not begin."""
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from conftest import CASES

import plica


THREADS = """
import signal, sys, plica
from concurrent.futures import ThreadPoolExecutor
plica.use(sys.argv[1])
if sys.argv[4] == "terminal":  # as in a cell of a notebook: the handler of the import is gone
    signal.signal(signal.SIGINT, signal.default_int_handler)
run = lambda k: plica.run(sys.argv[2], f"{sys.argv[3]}/m{k}").case
with ThreadPoolExecutor(2) as pool:
    futures = [pool.submit(run, k) for k in range(4)]
    try:
        print([future.result() for future in futures])
    except KeyboardInterrupt:
        print("interrupted", flush=True)
print([type(future.exception()).__name__ for future in futures])
open(sys.argv[2], "w").write("quick")
with ThreadPoolExecutor(2) as pool:  # new threads are free
    print(pool.submit(run, 5).result())
"""


@pytest.mark.parametrize("how", ["process", "terminal", "twice"])
def test_ctrl_c_ends_what_goes_side_by_side_and_what_waits_does_not_begin(fake, tmp_path, how):
    """Sent to the process alone, or as by a terminal to all; a second one ends what hangs."""
    if how == "twice":
        fake.write_text(fake.read_text().replace("signal.SIGINT, stop", "signal.SIGINT, 1"))
    (tmp_path / "slow.yaml").write_text("slow")
    parent = subprocess.Popen([sys.executable, "-c", THREADS, str(fake),
                               str(tmp_path / "slow.yaml"), str(tmp_path / "o"), how],
                              stdout=subprocess.PIPE, text=True, start_new_session=True,
                              env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})
    for _ in range(200):
        if len(list(tmp_path.glob("o/*/begun"))) == 2:
            break
        time.sleep(0.05)
    time.sleep(0.2)
    send = os.killpg if how == "terminal" else os.kill
    send(parent.pid, signal.SIGINT)
    if how == "twice":
        assert parent.stdout.readline() == "interrupted\n"
        send(parent.pid, signal.SIGINT)
        assert parent.wait(timeout=20) != 0
    else:
        said = parent.communicate(timeout=20)[0].splitlines()
        assert said == ["interrupted", str(4 * ["KeyboardInterrupt"]), "fake"]
        assert len(list(tmp_path.glob("o/*/stopped"))) == 2
    assert not {"m2", "m3"} & {path.name for path in (tmp_path / "o").iterdir()}
    assert _seconds_of_work(fake.name, tmp_path) == 0


def test_a_handler_of_ones_own_stays():
    code = ("import signal; mine = lambda *_: 0; signal.signal(signal.SIGINT, mine); import plica;"
            "assert signal.getsignal(signal.SIGINT) is mine; from plica import child\n"
            "with child.handling(): assert signal.getsignal(signal.SIGINT) is mine\n"
            "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
            "with child.handling(): assert signal.getsignal(signal.SIGINT) is child._on_ctrl_c\n"
            "assert signal.getsignal(signal.SIGINT) is signal.default_int_handler")
    subprocess.run([sys.executable, "-c", code], check=True,
                   env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})


INTERRUPTED = """
import sys, plica
plica.use(sys.argv[1])
if sys.argv[4] == "sweep":
    plica.sweep(sys.argv[2], {"a": [1, 2]}, sys.argv[3], collect=lambda r: {}, threads=None,
                no_variants=None, no_error_bars=None)
else:
    plica.run(sys.argv[2], sys.argv[3])
"""


@pytest.mark.parametrize("how", ["run", "sweep"])
def test_ctrl_c_ends_the_child_which_keeps_what_it_finished(fake, tmp_path, how):
    (tmp_path / "slow.yaml").write_text("case: slow\na: 0\n")
    out = tmp_path / "o"
    text = fake.read_text().replace('{**OPTION, "name": "brand-new"', ", ".join(
        '{**OPTION, "name": "%s", "kind": "flag"}' % name
        for name in ("threads", "no-variants", "no-error-bars")) + ', {**OPTION, "name": "x"')
    fake.write_text(text)
    parent = subprocess.Popen([sys.executable, "-c", INTERRUPTED, str(fake),
                               str(tmp_path / "slow.yaml"), str(out), how],
                              stderr=subprocess.PIPE, env={**os.environ, "PYTHONPATH": os.pathsep
                                                           .join(sys.path)})
    count = 1 if how == "run" else 2
    for _ in range(200):
        if len(list(tmp_path.glob("o/**/begun"))) == count:
            break
        time.sleep(0.05)
    time.sleep(0.2)
    parent.send_signal(signal.SIGINT)
    said = parent.communicate(timeout=20)[1].decode()
    assert "KeyboardInterrupt" in said
    assert len(list(tmp_path.glob("o/**/stopped"))) == count


def test_the_real_program_is_ended_as_well(tmp_path):
    case = plica.Case(CASES / "bellows.yaml")
    height = "parts.bellows.profile[1].height"
    case["variants"] = [{"name": f"v{k}", "set": {height: 8e-3 + k * 1e-5}} for k in range(400)]
    case.save(tmp_path / "long.yaml")
    code = ("import sys, plica, plica.bar; plica.bar.Bar.show = "
            "lambda bar, stage, share: print(stage, flush=True)\n"
            "plica.run(sys.argv[1], sys.argv[2], threads=1)")
    parent = subprocess.Popen([sys.executable, "-c", code, str(tmp_path / "long.yaml"),
                               str(tmp_path / "o")], stdout=subprocess.PIPE, text=True,
                              stderr=subprocess.DEVNULL,
                              env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})
    name = Path(plica.executable()).name
    meshes = (stage for stage in parent.stdout if stage == "mesh\n")
    assert [next(meshes), next(meshes)]  # that of a variant: the run itself is finished
    assert _seconds_of_work(name, tmp_path) > 0
    parent.send_signal(signal.SIGINT)
    assert parent.wait(timeout=60) != 0
    assert _seconds_of_work(name, tmp_path) == 0  # it is gone
    results = plica.results(tmp_path / "o")
    assert len(results.modes) == 4 and any("stopped" in w for w in results.data["warnings"])


def _seconds_of_work(name, folder):
    """Of processors, of the program `name` that works on files in a folder."""
    for process in Path("/proc").glob("[0-9]*"):
        try:
            words = (process / "cmdline").read_bytes().split(b"\0")
            if words[0].endswith(name.encode()) and str(folder).encode() in b" ".join(words):
                times = (process / "stat").read_text().rpartition(")")[2].split()
                return (int(times[11]) + int(times[12])) / os.sysconf("SC_CLK_TCK")
        except OSError:
            continue
    return 0
