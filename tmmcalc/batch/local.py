"""Local processes by joblib."""

from __future__ import annotations

import os
import signal
import threading
import time
from collections.abc import Iterator
from concurrent.futures import BrokenExecutor, Executor
from contextlib import contextmanager
from importlib import import_module

from tmmcalc.batch.executors import Workers
from tmmcalc.core.errors import UsageError

KEPT = 300.0  # seconds that processes wait for more


def processes(jobs: int, kept: bool = False) -> Workers:
    """``jobs`` processes; raises UsageError if joblib is not installed.

    ``kept``: they stay when what was asked is done, for who asks again and again, until this process ends.
    """
    try:
        import_module("joblib")
    except ImportError:
        from tmmcalc.core.installation import install

        raise UsageError(
            "several processes need joblib, which is not installed",
            where="--jobs",
            remedy=f"{install('parallel')}, or leave --jobs out",
        ) from None
    return Workers(lambda: _pool(jobs, kept), lambda: jobs, (BrokenExecutor,))


def available() -> bool:
    """Whether joblib is installed."""
    from importlib.util import find_spec

    return find_spec("joblib") is not None


def cores() -> int:
    """Processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@contextmanager
def _pool(jobs: int, kept: bool) -> Iterator[Executor]:
    from joblib.externals.loky import get_reusable_executor

    # each process has one thread for linear algebra, leaves interrupts to its parent, and does not outlive it
    own = {"env": {"OPENBLAS_NUM_THREADS": "1"}, "initializer": _follow, "initargs": (os.getpid(),)}
    pool = get_reusable_executor(jobs, timeout=KEPT if kept else 10, **own)
    done = False
    try:
        yield pool
        done = True
    finally:
        if not (done and kept):
            pool.shutdown(wait=True, kill_workers=True)


def _follow(parent: int) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with, args=(parent,), daemon=True).start()


def _end_with(parent: int) -> None:
    """End this process soon after its parent, which may have been killed and told nobody."""
    while os.getppid() == parent:
        time.sleep(1.0)
    os._exit(1)
