"""``tmmcalc check``."""

from __future__ import annotations

from collections.abc import Iterator, Sized
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.messages import put, show_error
from tmmcalc.cli.options import Set
from tmmcalc.errors import TmmError

if TYPE_CHECKING:
    from tmmcalc.spec import Spec

_EXTRAS = {
    "contact": "an elastic contact",
    "reliability": "the life of a product",
    "tie_down": "a load that is tied down",
    "falling_ball": "a falling ball",
    "bearing": "a rolling bearing",
}
_FOLLOWERS = {
    "translating": "a translating follower",
    "oscillating": "an oscillating follower",
    "flat": "a flat-faced follower",
}


def command(
    specs: Annotated[list[Path], typer.Argument(help="Project specs (TOML).", metavar="SPEC", show_default=False)],
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Say nothing of specs without faults.")] = False,
    overrides: Set = None,
) -> None:
    """Check specs: every fault of every file, with its line, at once. Exit code 2 if there is any.

    Example: tmmcalc check variants/*.toml
    """
    from tmmcalc.spec import load_spec

    code = 0
    for file in specs:
        try:
            spec = load_spec(file, overrides or ())
        except TmmError as error:
            show_error(error)
            code = error.exit_code
            continue
        if not quiet:
            put(f"{file}: ok ({'; '.join(_held(spec))})\n")
    raise typer.Exit(code)


def _held(spec: Spec) -> Iterator[str]:
    """What a spec is about."""
    if spec.mechanism is not None:
        yield f"{_count(spec.mechanism.links, 'moving link')}, {_count(spec.mechanism.joints, 'joint')}"
    if spec.synthesis is not None:
        yield f"a synthesis, {spec.synthesis.kind.replace('_', ' ')}"
    if spec.torque is not None:
        yield "a torque diagram"
    if spec.engine is not None:
        cylinders = spec.engine.cylinders
        count = cylinders if isinstance(cylinders, int) else len(cylinders)
        yield f"an engine of {count} cylinder{'s' if count > 1 else ''}"
    if spec.vibrator is not None:
        yield "a vibratory device"
    if spec.pendulum is not None:
        yield "a pendulum-rotor"
    if spec.rotor is not None:
        yield f"a rotor with {_count(spec.rotor.unbalances, 'unbalance')}"
    if spec.train is not None:
        yield f"a gear train, {' or '.join(spec.train.layout)}"
    if spec.gearing is not None:
        yield f"gearing, {spec.gearing.layout or f'{len(spec.gearing.meshes)} meshes'}"
    if spec.pair is not None:
        yield (
            "pairs of the train"
            if spec.pair.of_train
            else _count(spec.pair.meshes or [spec.pair], "pair") + " of gears"
        )
    if spec.cam is not None:
        yield f"a cam with {_FOLLOWERS[spec.cam.follower]}"
    for name, what in _EXTRAS.items():
        if getattr(spec, name) is not None:
            yield what
    if spec.indexing is not None:
        yield f"an indexing drive of {_count(range(spec.indexing.rollers), 'roller')}"


def _count(listed: Sized, noun: str) -> str:
    return f"{len(listed)} {noun}{'s' if len(listed) != 1 else ''}"
