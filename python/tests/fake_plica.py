#!/usr/bin/python3
"""A program with `schema commands` and `--messages json`, for tests of what the package does with
them: stages with shares, problems, and an end by Ctrl-C that keeps what was finished."""
import json
import signal
import sys
import time
from pathlib import Path

OPTION = {"list": False, "delimiter": None, "required": False, "choices": None, "min": None,
          "max": None, "default": None, "help": ""}


def say(**message):
    print(json.dumps(message), file=sys.stderr, flush=True)


def stop(*_):
    say(kind="failure", code=130, text="stopped by Ctrl-C")
    Path(out, "stopped").write_text("kept")
    sys.exit(130)


words = sys.argv[1:]
if words == ["--version"]:
    print("plica 0.1.0\nwith nothing")
elif words == ["schema", "commands"]:
    run = {"help": "a run", "positionals": [{**OPTION, "name": "CASE", "kind": "path"}],
           "options": [{**OPTION, "name": "out", "kind": "path", "default": "out"},
                       {**OPTION, "name": "brand-new", "kind": "whole", "min": 1}]}
    print(json.dumps({"plica_version": "0.1.0", "commands": {"run": run}, "global": [
        {**OPTION, "name": "messages", "kind": "text", "choices": ["json", "text"]}]}))
else:
    assert words[-2:] == ["--messages", "json"]
    out = words[words.index("--out") + 1]
    Path(out).mkdir(parents=True, exist_ok=True)
    signal.signal(signal.SIGINT, stop)
    case = Path(words[1]).read_text()
    if "wrong" in case:
        for line in (2, 5):
            say(kind="error", file=words[1], line=line, key=f"key{line}", wrong="is wrong",
                allowed="right")
        sys.exit(1)
    say(kind="warning", text="a doubt")
    if "broken" in case:
        say(kind="failure", code=3, text="an error within")
        sys.exit(3)
    for k in range(3):
        say(kind="progress", seconds=k, title="t", stage=f"stage {k}", share=k / 3)
    Path(out, "begun").write_text("")
    while "slow" in case:
        time.sleep(0.05)
    if "unproved" in case:
        say(kind="failure", code=2, text="the proof failed: a mode is missing")
    Path(out, "results.json").write_text('{"plica_version": "0.1.0", "case": "fake"}')
    sys.exit(2 if "unproved" in case else 0)
