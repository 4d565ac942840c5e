"""The records of a stress test: ladders, their rungs, and what became of every stage on each.

The observed error of a stage is the largest difference of its quantities from those of an equivalent scene (in other
units, mirrored, begun elsewhere, on another grid), relative to the largest magnitude of the same unit in that stage.
The equivalent scene is written in other digits, so that it differs by what the arithmetic loses and by what the last
digit of the data does. Beside it stand the stage's own estimates of both, and the condition number of the rung.
"""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.core.records import record

LIMITS = (1e-9, 1e-6, 1e-3)  # observed errors at which accuracy counts as degraded
SETTLED = 16 * 2.0**-52  # what the last digit of the data may do to a stage that says nothing of it
OK, WARNING, DISPUTED, ERROR, FAULT = "ok", "warning", "disputed", "error", "fault"


@record
class Met:
    """What became of one stage on one rung."""

    stage: str
    # ok, warning, disputed (the scene beside it ends with an error), error (a named one of the program), fault (of the
    # program itself)
    status: str
    code: int = 0  # exit code of its class
    message: str = ""  # first warning, or the error
    error: float | None = None  # observed, relative; None: nothing to compare
    quantity: str = ""  # of which it is observed
    estimate: float | None = None  # largest of its own estimates, relative; None: it gives none
    last_digit: float | None = None  # largest of what it says of the last digit of the data; None: nothing
    skipped: tuple[str, ...] = ()  # quantities that could not be compared, each with the reason

    @property
    def covered(self) -> float | None:
        """What the stage lets expect: its estimate and what the last digit of the data does."""
        return (
            None if self.estimate is None else self.estimate + (SETTLED if self.last_digit is None else self.last_digit)
        )

    @property
    def told(self) -> bool:
        """Whether what the stage lets expect is as large as the observed error, or a warning or an error says it."""
        if self.status == DISPUTED:
            return False
        if self.error is None or self.status != OK:
            return True
        return self.covered is not None and self.covered >= self.error


@record
class Rung:
    """One scene of a ladder."""

    setting: str  # in words
    size: float  # of what is varied
    condition: float | None  # condition number; None: the scene could not be built so far
    met: tuple[Met, ...]  # by stage, in the order of the pipeline
    note: str = ""  # why it has nothing beside it
    answer: str = ""  # of a shipped scene: what was compared with its known answer


@record
class Loss:
    """What a stage loses on a ladder: its first rung with a comparison beside its worst."""

    stage: str
    ordinary: float  # observed error on the first rung
    rung: Rung  # the worst
    met: Met  # there


@record
class Degraded:
    """The first rung at which the observed error of a stage is beyond a limit."""

    stage: str
    limit: float
    rung: Rung
    told: bool  # whether the estimate, a warning or an error told it


@record
class Ladder:
    """A row of scenes from ordinary to extreme."""

    name: str
    title: str
    condition: str  # what the condition number is
    against: str  # what the observed error is measured against
    rungs: tuple[Rung, ...]

    def stages(self) -> tuple[str, ...]:
        """All stages that were met, in the order of the pipeline."""
        return tuple(dict.fromkeys(met.stage for rung in self.rungs for met in rung.met))

    def track(self, stage: str) -> tuple[tuple[Rung, Met], ...]:
        """What became of a stage, rung by rung."""
        return tuple((rung, met) for rung in self.rungs for met in rung.met if met.stage == stage)

    def losses(self) -> Iterator[Loss]:
        """The worst of every stage that has something to compare."""
        for stage in self.stages():
            compared = [(met.error, rung, met) for rung, met in self.track(stage) if met.error is not None]
            if compared:
                _, rung, met = max(compared, key=lambda each: each[0])
                yield Loss(stage, compared[0][0], rung, met)

    def degraded(self) -> Iterator[Degraded]:
        """Where every stage passes every limit, if it does."""
        for stage in self.stages():
            for limit in LIMITS:
                beyond = ((rung, met) for rung, met in self.track(stage) if (met.error or 0.0) > limit)
                found = next(beyond, None)
                if found is not None:
                    yield Degraded(stage, limit, found[0], found[1].told)


@record
class Stress:
    """All ladders of a scene; those that it has not, with the reason."""

    ladders: tuple[Ladder, ...]
    without: tuple[tuple[str, str], ...]

    @property
    def disputed(self) -> tuple[tuple[str, Rung, Met], ...]:
        """Where a stage has a result that it has not in the equivalent scene, and does not warn."""
        return self._ending(DISPUTED)

    @property
    def faults(self) -> tuple[tuple[str, Rung, Met], ...]:
        """Where the program itself failed: an exception without a name, or a number that is none."""
        return self._ending(FAULT)

    def _ending(self, status: str) -> tuple[tuple[str, Rung, Met], ...]:
        return tuple(
            (ladder.name, rung, met)
            for ladder in self.ladders
            for rung in ladder.rungs
            for met in rung.met
            if met.status == status
        )
