"""``tmmcalc check``."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sized
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmmcalc.cli.messages import put, show_error
from tmmcalc.cli.options import Set
from tmmcalc.core.errors import TmmError

if TYPE_CHECKING:
    from tmmcalc.gears.tables.pair import PairTable
    from tmmcalc.machine.tables.engine import EngineTable
    from tmmcalc.project import Spec


def command(
    specs: Annotated[list[Path], typer.Argument(help="Project specs (TOML).", metavar="SPEC", show_default=False)],
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Say nothing of specs without faults.")] = False,
    overrides: Set = None,
) -> None:
    """Check specs: every fault of every file, with its line, at once. Exit code 2 if there is any.

    Example: tmmcalc check variants/*.toml
    """
    from tmmcalc.project import load_spec

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
    from tmmcalc.rooms import TABLES

    others = {name: entry.describes for name, entry in TABLES.items() if entry.describes and name not in HELD}
    for table, told in (HELD | others).items():
        held = getattr(spec, table)
        if held:
            yield told if isinstance(told, str) else told(held)


def _engine(engine: EngineTable) -> str:
    cylinders = engine.cylinders
    return f"an engine of {_count(range(cylinders) if isinstance(cylinders, int) else cylinders, 'cylinder')}"


def _pairs(pair: PairTable) -> str:
    return "pairs of the train" if pair.of_train else f"{_count(pair.meshes or [pair], 'pair')} of gears"


def _count(listed: Sized, noun: str) -> str:
    return f"{len(listed)} {noun}{'s' if len(listed) != 1 else ''}"


_FOLLOWERS = {
    "translating": "a translating follower",
    "oscillating": "an oscillating follower",
    "flat": "a flat-faced follower",
}
_ARMS = {"spherical": "a spherical arm", "cylindrical": "a cylindrical arm", "angular": "an angular arm"}
# What is said of a table that a spec has; of a subject that does not stand here, what its manifest says.
HELD: dict[str, str | Callable[[Any], str]] = {
    "mechanism": lambda linkage: f"{_count(linkage.links, 'moving link')}, {_count(linkage.joints, 'joint')}",
    "synthesis": lambda synthesis: f"a synthesis, {synthesis.kind.replace('_', ' ')}",
    "dyad": lambda dyad: f"a dyad {dyad.kind}",
    "torque": "a torque diagram",
    "engine": _engine,
    "vibrator": "a vibratory device",
    "pendulum": "a pendulum-rotor",
    "rotor": lambda rotor: f"a rotor with {_count(rotor.unbalances, 'unbalance')}",
    "train": lambda train: f"a gear train, {' or '.join(train.layout)}",
    "gearing": lambda gearing: f"gearing, {gearing.layout or f'{len(gearing.meshes)} meshes'}",
    "open_pair": lambda pair: f"an open pair {pair.teeth[0]}/{pair.teeth[1]}",
    "pair": _pairs,
    "wheel": lambda wheel: f"a {'ring' if wheel.kind == 'internal' else 'wheel'} of {wheel.teeth} teeth",
    "cam": lambda cam: f"a cam with {_FOLLOWERS[cam.follower]}",
    "indexing": lambda drive: f"an indexing drive of {_count(range(drive.rollers), 'roller')}",
    "manipulator": lambda manipulator: f"a manipulator with {_ARMS[manipulator.arm]}",
    "contact": "an elastic contact",
    "reliability": "the life of a product",
    "tie_down": "a load that is tied down",
    "falling_ball": "a falling ball",
    "bearing": "a rolling bearing",
    "liner": "a cylinder liner",
    "transloader": "a grab transloader",
    "constraints": lambda constraints: _count(constraints, "constraint"),
}
