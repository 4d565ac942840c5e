"""Names of pairs and wheels that the spec tells before anything is computed; a wrong one is refused at once."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def check_pair(scene: Spec, pair: str | None, **_: object) -> None:
    """Raise `UsageError` for a pair that no run of this spec has."""
    wheels = None if pair is None else _wheels(scene)
    if wheels is not None:
        from tmmcalc.gears.facts.meshes import places

        places([name for name, _ in wheels], pair, "pair")


def check_wheel(scene: Spec, wanted: str | None) -> None:
    """Raise `UsageError` for a wheel that no run of this spec has, by its name or as PAIR/NAME."""
    pairs = None if wanted is None else _wheels(scene)
    if pairs is None:
        return
    apart = scene.pair is not None and scene.pair.of_train
    labels = [wheel if apart or not pair else f"{pair}/{wheel}" for pair, wheels in pairs for wheel in wheels]
    if not any(wanted in (label, label.rpartition("/")[2]) for label in labels):
        told = ", ".join(dict.fromkeys(labels))
        raise UsageError(f"there is no wheel {wanted!r}", where="--wheel", remedy=f"wheels: {told}")


def _wheels(scene: Spec) -> list[tuple[str, tuple[str, ...]]] | None:
    """The pairs with their wheels; None: it depends on which layout is chosen, or there are none."""
    if scene.pair is None:
        return None
    if scene.pair.of_train:
        if scene.train is None or len(scene.train.layout) != 1:
            return None
        from tmmcalc.gears.scheme import layout_of

        meshes = layout_of(scene.train.layout[0]).meshes
        return [(f"{mesh.first}-{mesh.second}", (mesh.first, mesh.second)) for mesh in meshes]
    from tmmcalc.gears.tables.tasks.pair import to_pairs

    return [(task.name, task.wheels) for task in to_pairs(scene).pairs]
