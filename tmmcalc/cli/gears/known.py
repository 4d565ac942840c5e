"""What is chosen of a spec before anything is computed: pairs and wheels by their names, a train by its row."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.cli.job import Job
    from tmmcalc.project import Spec

Row = Annotated[
    int | None,
    typer.Option(
        "--choose",
        metavar="N",
        min=1,
        help="Of a [train]: row N, from 1, of gears compare in place of the train that is chosen; without [strength] "
        "tooth set N of gears synth.",
        show_default=False,
    ),
]


def of_row(job: Job, scene: Spec, row: int | None) -> tuple[Job, Spec]:
    """The job and its spec with a row of the trains chosen, in place of the one that criteria choose."""
    if row is None or scene.train is None or scene.strength is None:
        return job, scene
    chosen = replace(job, overrides=[*job.overrides, f"criteria.choose={row}"])
    return chosen, chosen.spec()


def of_pairs(job: Job, scene: Spec, row: int | None) -> tuple[Job, Spec]:
    """The same for pairs of gears; raises `UsageError` for pairs that are written out."""
    if row is not None and scene.pair is not None and not scene.pair.of_train:
        raise UsageError(
            "the pairs of the spec are written out, no train gives them", where="--choose", remedy="name one by --pair"
        )
    return of_row(job, scene, row)


def of_wheel(scene: Spec, choose: int | None, pair: str | None, wheel: str | None) -> bool:
    """Whether a command is about the wheel without a mate; raises `UsageError` for flags that are about pairs."""
    if scene.wheel is None or scene.pair is not None or scene.open_pair is not None:
        return False
    for flag, value in (("--choose", choose), ("--pair", pair)):
        if value is not None:
            raise UsageError("the spec has a wheel without a mate, no pairs", where=flag, remedy="leave it out")
    check_wheel(scene, wheel)
    return True


def check_pair(scene: Spec, pair: str | None) -> None:
    """Raise `UsageError` for a pair that no run of this spec has."""
    wheels = None if pair is None else _wheels(scene)
    if wheels is not None:
        from tmmcalc.gears.facts.meshes import places

        places([name for name, _ in wheels], pair, "pair")


def check_wheel(scene: Spec, wanted: str | None) -> None:
    """Raise `UsageError` for a wheel that no run of this spec has, by its name or as PAIR/NAME."""
    if wanted is None:
        return
    single = scene.wheel
    pairs = [("", (single.name,))] if single and not scene.pair and not scene.open_pair else _wheels(scene)
    if pairs is None:
        return
    apart = scene.pair is not None and scene.pair.of_train
    labels = [wheel if apart or not pair else f"{pair}/{wheel}" for pair, wheels in pairs for wheel in wheels]
    if not any(wanted in (label, label.rpartition("/")[2]) for label in labels):
        told = ", ".join(dict.fromkeys(labels))
        raise UsageError(f"there is no wheel {wanted!r}", where="--wheel", remedy=f"wheels: {told}")


def _wheels(scene: Spec) -> list[tuple[str, tuple[str, ...]]] | None:
    """The pairs with their wheels; None: it depends on which layout is chosen, or there are none."""
    if scene.pair is None and scene.open_pair is None:
        return None
    of_train = scene.pair is not None and scene.pair.of_train
    if of_train and (scene.train is None or len(scene.train.layout) != 1):
        return None
    from tmmcalc.gears.tables.tasks.pair import to_pairs

    task = to_pairs(scene)
    on_crank = () if task.on_crank is None else (task.on_crank,)
    written = [(pair.name, pair.wheels) for pair in (*task.pairs, *on_crank)]
    if not of_train or scene.train is None:
        return written
    from tmmcalc.gears.scheme import layout_of

    meshes = layout_of(scene.train.layout[0]).meshes
    return [*((f"{mesh.first}-{mesh.second}", (mesh.first, mesh.second)) for mesh in meshes), *written]
