"""What is told of a run on standard error: its stages, live on a terminal, and what is kept when it is interrupted."""

from __future__ import annotations

import sys
from collections.abc import Callable
from contextlib import nullcontext
from typing import TYPE_CHECKING

from tmmcalc.cli.messages import say, show_damage, show_event, show_news
from tmmcalc.core.progress import tell
from tmmcalc.pipeline.outcome import RunResult, Watch

if TYPE_CHECKING:
    from contextlib import AbstractContextManager
    from pathlib import Path
    from types import TracebackType

    from tmmcalc.project import Spec


class StageWatch(Watch):
    """Tells of the stages of a run whose files go into ``folder``; ``ended`` gives what the run gives in the end."""

    def __init__(
        self, folder: Path | None, ended: Callable[[Spec, RunResult], RunResult], *, quiet: bool, verbose: bool
    ) -> None:
        self._folder, self._ended = folder, ended
        show_one = show_damage if quiet else show_event if verbose else show_news
        self._live: AbstractContextManager[object] = nullcontext()
        if quiet or not sys.stderr.isatty():
            super().__init__(lambda stage: tell(0.0, stage), show_one)
            return
        from tmmcalc.cli.progress import Progress

        self._live = progress = Progress(show_one)
        super().__init__(progress.start, progress.done)

    def __enter__(self) -> StageWatch:
        self._live.__enter__()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        """If the run is interrupted say what is kept."""
        self._live.__exit__(kind, error, at)
        if isinstance(error, KeyboardInterrupt) and self._folder is not None and self._folder.is_dir():
            say(f"stopped: finished stages are kept in {self._folder}; the same command loads them", "yellow")

    def end(self, spec: Spec, result: RunResult) -> RunResult:
        """What the run gives in the end."""
        return self._ended(spec, result)
