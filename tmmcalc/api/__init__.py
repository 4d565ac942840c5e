"""The Python API: one function a capability, on specs or on plain tasks; each room has its module."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tmmcalc.api.results import Run
    from tmmcalc.pipeline.outcome import Event
    from tmmcalc.project import Spec


def run(
    spec: Spec | str | Path,
    *,
    target: str | None = None,
    out: str | Path | None = None,
    fresh: bool = False,
    from_stage: str | None = None,
    csv: bool | None = None,
    columns: Sequence[str] = (),
    skip: Sequence[str] = (),
    settings: Mapping[str, Mapping[str, Any]] | None = None,
    on_event: Callable[[Event], None] | None = None,
) -> Run:
    """Run the pipeline up to ``target`` (None: every stage that the spec has), with files in ``out`` if given.

    ``spec`` is a spec, or the path of its file, which is read as by ``load_spec`` and may fail as there.
    A stage whose stored inputs are unchanged is loaded; ``fresh`` recomputes all, ``from_stage`` that one
    and the following. ``csv`` None writes CSV files up to 2000 rows, ``columns`` are names and wildcards of those
    that they have (empty: all). ``skip`` leaves stages out, with all that read them. ``settings`` are options of
    methods by stage. Without ``target`` the files in ``out`` of stages that the spec has no more are removed, as far as
    an earlier run wrote them.
    """
    from tmmcalc.api.results import Run
    from tmmcalc.pipeline.outcome import Watch
    from tmmcalc.pipeline.runner import run as _run
    from tmmcalc.project import load_spec

    folder = Path(out) if out is not None else None
    found = _run(
        load_spec(spec) if isinstance(spec, str | Path) else spec,
        target=target,
        out=folder,
        fresh=fresh,
        from_stage=from_stage,
        csv=csv,
        columns=columns,
        skip=skip,
        settings=settings,
        watch=None if on_event is None else Watch(event=on_event),
    )
    return Run(**vars(found))


def settle(spec: Spec, stage: str, *, choose: int | None = None, file: str | Path = "") -> str:
    """The text of the spec with what a stage found in its place, as ``--spec`` writes it; everything else is kept.

    ``stage`` is synthesis, cam_synthesis, cam_optimum, flywheel, train or criteria; ``choose`` the number of one of
    several solutions, from 1. The text is to stand in ``file``: paths of other files count from its folder.

    Raises `UsageError` for another stage, where nothing was sought, and where it is not said which solution is meant.
    """
    from tmmcalc.core.errors import UsageError
    from tmmcalc.core.plan import known_stage
    from tmmcalc.project.found import settled_text
    from tmmcalc.rooms import STAGES

    found = known_stage(stage, STAGES).part("found")
    if found is None:
        finding = ", ".join(name for name, each in STAGES.items() if each.part("found") is not None)
        raise UsageError(f"{stage} seeks nothing that a spec could have", where="settle", remedy=f"stages: {finding}")
    place = Path(file) if str(file) else Path(spec._written.folder if spec._written else ".") / "spec.toml"
    return settled_text(spec, place, found(spec, solved(spec, stage), choose)).text


def solved(spec: Spec, stage: str) -> Any:
    """The result of one stage; raises `UsageError` if the scene leaves it out."""
    return run(spec, target=stage).results[stage]
