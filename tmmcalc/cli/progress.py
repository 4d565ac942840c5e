"""A sign of life on a terminal: the running stage and its time, once it takes longer than a moment."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager, nullcontext
from time import monotonic
from types import TracebackType
from typing import TYPE_CHECKING, Any, ParamSpec

from tmmcalc.cli.messages import show_news
from tmmcalc.core.progress import listening

if TYPE_CHECKING:
    from rich.progress import Progress as Bar

    from tmmcalc.pipeline.outcome import Event

Words = ParamSpec("Words")

PATIENCE = 0.5  # seconds before anything is shown: short commands stay quiet and do not load rich


class Progress:
    """Context in which stages run: ``start`` and ``done`` are told by the pipeline; ``show`` writes what has become."""

    def __init__(self, show: Callable[[Event], None] = show_news) -> None:
        self._tell = show
        self._lock = threading.Lock()
        self._timer: threading.Timer | None = None
        self._bar: Bar | None = None
        self._stage, self._words = "", "running"
        self._listening = listening(self._hear)

    def __enter__(self) -> Progress:
        self._listening.__enter__()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self._listening.__exit__(kind, error, at)
        self._stop()

    def start(self, stage: str) -> None:
        """A stage begins."""
        self._stop()
        self._words = "running"
        self._timer = threading.Timer(PATIENCE, self._show, [stage])
        self._timer.daemon = True
        self._timer.start()

    def done(self, event: Event) -> None:
        """A stage has ended, or something about it is to be said."""
        self._stop()
        self._tell(event)

    def _hear(self, part: float, words: str) -> None:
        """A stage tells how far it is."""
        self._words = f"{100 * part:.0f} %, {words}" if part < 1 else words
        with self._lock:
            if self._bar is not None:
                for task in self._bar.task_ids:
                    self._bar.update(task, description=f"{self._stage}: {self._words}")

    def _show(self, stage: str) -> None:
        from rich.console import Console
        from rich.progress import Progress as Bar
        from rich.progress import SpinnerColumn, TextColumn, TimeElapsedColumn

        with self._lock:
            if self._timer is None:
                return
            columns = (SpinnerColumn(), TextColumn("{task.description}", markup=False), TimeElapsedColumn())
            self._bar = Bar(*columns, console=Console(stderr=True), transient=True)
            self._stage = stage
            self._bar.add_task(f"{stage}: {self._words}")
            self._bar.start()

    def _stop(self) -> None:
        with self._lock:
            if self._timer is not None:
                self._timer.cancel()
                self._timer = None
            if self._bar is not None:
                self._bar.stop()
                self._bar = None


def seen(
    bar: AbstractContextManager[Callable[Words, None]], quiet: bool
) -> AbstractContextManager[Callable[Words, None]]:
    """One of the bars below, or none where all is quiet or no terminal would show it."""

    def unseen(*args: Words.args, **kwargs: Words.kwargs) -> None:
        """Nobody looks."""

    return nullcontext(unseen) if quiet or not sys.stderr.isatty() else bar


@contextmanager
def counted(what: str, total: int) -> Iterator[Callable[[int, int], None]]:
    """A bar that is told how many are done and how many of them failed, shown after a moment."""
    began = monotonic()
    with ExitStack() as stack:
        bar: list[tuple[Bar, Any]] = []

        def told(done: int, failed: int) -> None:
            if not bar and monotonic() - began > PATIENCE:
                bar.append(_bar(stack, what, total))
            for progress, task in bar:
                progress.update(task, completed=done, description=f"{what}, {failed} failed" if failed else what)

        yield told


@contextmanager
def growing(what: str) -> Iterator[Callable[[int, int], None]]:
    """A bar that is told how many are done of how many, which may become more, shown after a moment."""
    began = monotonic()
    with ExitStack() as stack:
        bar: list[tuple[Bar, Any]] = []

        def told(done: int, total: int) -> None:
            if not bar and monotonic() - began > PATIENCE:
                bar.append(_bar(stack, what, total))
            for progress, task in bar:
                progress.update(task, completed=done, total=total)

        yield told


@contextmanager
def told_with(what: str) -> Iterator[Callable[[int, str], None]]:
    """A spinner that is told how many are done, and what is to be said of them."""
    with described() as told:
        yield lambda done, words: told(f"{done} {what}: {words}")


@contextmanager
def described() -> Iterator[Callable[[str], None]]:
    """A spinner that is told what is being done, shown after a moment, with the time since the beginning."""
    began = monotonic()
    with ExitStack() as stack:
        shown: list[tuple[Bar, Any]] = []

        def told(words: str) -> None:
            if not shown and monotonic() - began > PATIENCE:
                shown.append(_spinner(stack, words))
            for progress, task in shown:
                progress.update(task, description=words)

        yield told


def _spinner(stack: ExitStack, words: str) -> tuple[Bar, Any]:
    from rich.console import Console
    from rich.progress import Progress as Bar
    from rich.progress import SpinnerColumn, TextColumn, TimeElapsedColumn

    columns = (SpinnerColumn(), TextColumn("{task.description}", markup=False), TimeElapsedColumn())
    bar = stack.enter_context(Bar(*columns, console=Console(stderr=True), transient=True))
    return bar, bar.add_task(words)


def _bar(stack: ExitStack, what: str, total: int) -> tuple[Bar, Any]:
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeRemainingColumn
    from rich.progress import Progress as Bar

    columns = (TextColumn("{task.description}", markup=False), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    bar = stack.enter_context(Bar(*columns, console=Console(stderr=True), transient=True))
    return bar, bar.add_task(what, total=total)
