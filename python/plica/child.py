"""A run of the program: its progress, how it ends, and Ctrl-C for all that go side by side."""
from __future__ import annotations

import signal
import subprocess
import threading
import time
from contextlib import contextmanager
from typing import Any, Iterator
from weakref import WeakKeyDictionary

from .bar import Bar
from .messages import Said, listen

GRACE = 30.0  # seconds that a run may take to write what it finished after Ctrl-C
QUEUED = 5.0  # seconds: what a thread begins so soon after Ctrl-C was waiting for its turn
ENDED_BY_CTRL_C = (130, -signal.SIGINT)
_running: set[subprocess.Popen[str]] = set()
_interrupted: set[subprocess.Popen[str]] = set()
_stopped: WeakKeyDictionary[threading.Thread, float] = WeakKeyDictionary()  # and since when
_lock = threading.RLock()  # the handler may come while its own thread holds it


def call(words: list[str], title: str, progress: bool) -> Said:
    """Runs the program to its end. KeyboardInterrupt ends it first: it keeps what it finished."""
    said = Said()
    _refuse()
    alone = _in_main() or signal.getsignal(signal.SIGINT) is _on_ctrl_c
    with Bar(title, progress) as bar, _start(words, alone) as child:
        assert child.stderr is not None
        threads = [threading.Thread(target=_read_output, args=(child, said), daemon=True),
                   threading.Thread(target=listen, args=(child.stderr, said, bar.show),
                                    daemon=True)]
        try:
            with _lock:
                _running.add(child)
            for thread in threads:
                thread.start()
            _refuse()  # Ctrl-C while it was started
            while child.poll() is None:
                if child in _interrupted:
                    raise KeyboardInterrupt
                bar.tick()
                time.sleep(0.02)
            for thread in threads:
                thread.join()
            if child in _interrupted:
                raise KeyboardInterrupt
            if not alone and child.returncode in ENDED_BY_CTRL_C:  # by the terminal
                stop_waiting()
                raise KeyboardInterrupt
        except BaseException:
            end(child)
            raise
        finally:
            with _lock:
                _running.discard(child)
                _interrupted.discard(child)
                if threading.current_thread() in _stopped:
                    _stopped[threading.current_thread()] = time.monotonic()
        said.code = child.returncode
    return said


def _in_main() -> bool:
    return threading.current_thread() is threading.main_thread()


def _start(words: list[str], alone: bool) -> subprocess.Popen[str]:
    """alone: in a session of its own, so that Ctrl-C reaches it through `end` or the handler alone,
    and once; else it has it from the terminal."""
    return subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True, encoding="utf-8",
                            errors="backslashreplace", start_new_session=alone)


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


def _interrupt(child: subprocess.Popen[str]) -> bool:
    """Once: a second Ctrl-C would end the program before it has written."""
    with _lock:
        if child in _interrupted:
            return False
        _interrupted.add(child)
    child.send_signal(signal.SIGINT)
    return True


def stop_waiting() -> None:
    """What the threads of now have still to begin does not begin; new threads are free."""
    with _lock:
        for thread in threading.enumerate():
            if thread is not threading.main_thread():
                _stopped[thread] = time.monotonic()


def _refuse() -> None:
    """KeyboardInterrupt in a thread in whose queue Ctrl-C found this call."""
    with _lock:
        since = _stopped.pop(threading.current_thread(), None)
        if since is None or time.monotonic() - since > QUEUED:
            return
        _stopped[threading.current_thread()] = time.monotonic()
    raise KeyboardInterrupt("Ctrl-C came before this run began")


def _on_ctrl_c(number: int, frame: Any) -> None:
    """Tells every run, in whatever thread, and on another Ctrl-C ends them; then as ever."""
    stop_waiting()
    for child in list(_running):
        if not _interrupt(child):
            child.kill()
    signal.default_int_handler(number, frame)


def _handle() -> bool:
    """Puts the handler in the place of Python's own; True where it was there. What somebody else
    put there stays."""
    if not _in_main() or signal.getsignal(signal.SIGINT) is not signal.default_int_handler:
        return False
    signal.signal(signal.SIGINT, _on_ctrl_c)
    return True


@contextmanager
def handling() -> Iterator[None]:
    """The handler where Python's own has come back since, as in every cell of a notebook."""
    handled = _handle()
    try:
        yield
    finally:
        if handled:
            signal.signal(signal.SIGINT, signal.default_int_handler)


def _read_output(child: subprocess.Popen[str], said: Said) -> None:
    assert child.stdout is not None
    said.printed = child.stdout.read()


_handle()  # here, as threads may not, and the first run may be in one
