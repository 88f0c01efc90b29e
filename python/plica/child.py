"""A run of the program: its progress, and how it ends."""
from __future__ import annotations

import signal
import subprocess
import threading
import time

from .bar import Bar
from .messages import Said, listen

GRACE = 30.0  # seconds that a run may take to write what it finished after Ctrl-C
_running: set[subprocess.Popen[str]] = set()
_interrupted: set[subprocess.Popen[str]] = set()
_lock = threading.Lock()


def call(words: list[str], title: str, json_lines: bool, progress: bool) -> Said:
    """Runs the program to its end. KeyboardInterrupt ends it first: it keeps what it finished."""
    said = Said()
    with Bar(title, progress) as bar, _start(words) as child:
        assert child.stderr is not None
        listening = (child.stderr, said, [] if json_lines else words, bar.show)
        threads = [threading.Thread(target=_read_output, args=(child, said), daemon=True),
                   threading.Thread(target=listen, args=listening, daemon=True)]
        try:
            with _lock:
                _running.add(child)
            for thread in threads:
                thread.start()
            while child.poll() is None:
                bar.tick()
                time.sleep(0.02)
            for thread in threads:
                thread.join()
        except BaseException:
            end(child)
            raise
        finally:
            with _lock:
                _running.discard(child)
                _interrupted.discard(child)
        said.code = child.returncode
    return said


def _start(words: list[str]) -> subprocess.Popen[str]:
    """In a session of its own, so that Ctrl-C reaches it through `end` alone, and once."""
    return subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True, encoding="utf-8",
                            errors="backslashreplace", start_new_session=True)


def end(child: subprocess.Popen[str]) -> None:
    """Ctrl-C, then after GRACE seconds, or on another Ctrl-C, the end."""
    _interrupt(child)
    try:
        child.wait(GRACE)
    except (subprocess.TimeoutExpired, KeyboardInterrupt):
        child.kill()
        child.wait()


def end_all() -> None:
    """Ends every run that is under way, in whatever thread it was begun."""
    with _lock:
        children = list(_running)
    for child in children:
        _interrupt(child)
    for child in children:
        end(child)


def _interrupt(child: subprocess.Popen[str]) -> None:
    """Once: a second Ctrl-C would end the program before it has written."""
    with _lock:
        if child in _interrupted:
            return
        _interrupted.add(child)
    child.send_signal(signal.SIGINT)


def _read_output(child: subprocess.Popen[str], said: Said) -> None:
    assert child.stdout is not None
    said.printed = child.stdout.read()
