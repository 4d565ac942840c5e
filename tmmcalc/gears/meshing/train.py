"""The meshes of the chosen train as pairs: their teeth, modules and widths, and the centre distances that they share.

A tooth set fixes the centre distance of each mesh, a_w = m (z2 +- z1)/2 cos(alpha)/cos(alpha_w)/cos(beta) with the
operating angle alpha_w of the set. In an unfolded train every mesh is free to have another. Around a common axis all
meshes have one centre distance: the first may free it, the others take what results. In 2A-AA each keeps its own.

In an internal pair the pinion is first and the ring second, whichever the layout names first.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from math import cos, isclose

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.gears.meshing.planets import solve_chain
from tmmcalc.gears.meshing.refusal import error_of_all, millimetres
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.gears.meshing.task import NEITHER, PairsTask, PairTask
from tmmcalc.gears.scheme import Layout, Mesh, layout_of
from tmmcalc.gears.selection.results import Selection, pooled

WHERE = "pairs of the train"
SAME = 1e-9  # relative difference of centre distances that counts as none
Solve = Callable[[PairTask], MeshPair]


def solve_meshes(task: PairsTask, selection: Selection, solve: Solve) -> Pairs:
    """Every mesh of the winner, each by ``solve``.

    Raises `NoSolutionError` with every mesh that cannot be made, `UsageError` for a strategy that asks for a centre
    distance which the train does not leave free.
    """
    layout = layout_of(selection.winner.layout)
    asked = _asked(task, selection, layout)
    own, solve = _distances(asked, selection), _once(solve)
    if not layout.branched:
        tasks, remark = _free(asked, own), ""
    elif layout.paired:
        tasks, remark = _kept(asked, own, layout)
    else:
        tasks, remark = _shared(task, asked, own, layout, solve)
    pairs, remarks = _solved(tasks, layout, solve, remark)
    if any(abs(shift) > SAME for pair in pairs for shift in pair.shifts):
        remarks.append("the train's modules, face widths, inertia and efficiency were found for teeth without shifts")
    return Pairs(pairs, selection.winner.name, tuple(filter(None, (remark, _helical(pairs, own), *remarks))))


def _helical(pairs: Sequence[MeshPair], own: Sequence[float]) -> str:
    """What helical teeth change of a train that was found for spur ones; ``own`` as `_distances` gives them."""
    changed = [
        Phrase(
            "{name} {distance} instead of {usual}",
            name=pair.task.name,
            distance=millimetres(pair.distance),
            usual=millimetres(usual * cos(pair.task.helix)),
        )
        for pair, usual in zip(pairs, own, strict=True)
        if pair.task.helix
    ]
    if not changed:
        return ""
    return Phrase(
        "the train's modules, face widths and centre distances were found for spur teeth; with the helix angle "
        "the centre distances are {changed}",
        changed=changed,
    )


def _once(solve: Solve) -> Solve:
    """The same function, which does not solve a task again."""
    known: dict[PairTask, MeshPair] = {}

    def remembered(task: PairTask) -> MeshPair:
        if task not in known:
            known[task] = solve(task)
        return known[task]

    return remembered


def name_of(mesh: Mesh) -> str:
    """The mesh as the spec names it, such as 2'-3."""
    return f"{mesh.first}-{mesh.second}"


def chains(layout: Layout) -> tuple[tuple[int, ...], ...]:
    """The meshes by number, those that share a wheel together.

    >>> chains(layout_of("AII"))
    ((0, 1), (2,))
    """
    found: list[list[int]] = []
    for k, mesh in enumerate(layout.meshes):
        before = layout.meshes[k - 1] if k else None
        if before is not None and before.second == mesh.first:
            found[-1].append(k)
        else:
            found.append([k])
    return tuple(tuple(each) for each in found)


def _asked(task: PairsTask, selection: Selection, layout: Layout) -> tuple[PairTask, ...]:
    """What is asked of each mesh, with its teeth, module and width; centre distances still as they are asked for."""
    names = [name_of(mesh) for mesh in layout.meshes]
    strange = [name for name in task.own if name not in names]
    if strange or task.usual is None:
        what = f"the train {layout.key} has no mesh {strange[0]}" if strange else "nothing is asked of the meshes"
        raise UsageError(what, where=WHERE, remedy=f"meshes: {', '.join(names)}")
    winner = selection.winner
    teeth = dict(zip(layout.wheels, winner.teeth, strict=True))
    found = []
    for mesh, name in zip(layout.meshes, names, strict=True):
        wheels = (mesh.second, mesh.first) if mesh.first in layout.rings else (mesh.first, mesh.second)
        base = task.own.get(name, task.usual)
        found.append(
            replace(
                base,
                name=name,
                wheels=wheels,
                teeth=(teeth[wheels[0]], teeth[wheels[1]]),
                kind="internal" if mesh.internal else "external",
                module=winner.modules[mesh.stage],
                face_width=winner.widths[mesh.stage] if base.face_width is None else base.face_width,
                cutter=base.cutter if mesh.internal else None,
            )
        )
    return tuple(found)


def _distances(asked: tuple[PairTask, ...], selection: Selection) -> list[float]:
    """Centre distances [m] by the operating angles of the tooth set."""
    variant, row = selection.winner.variant, int(pooled(selection.variants).row[selection.winner.place])
    angles = [float(angle) for angle in selection.variants[variant].sets.angles[row]]
    return [reference(task) * cos(task.rack.angle) / cos(angle) for task, angle in zip(asked, angles, strict=True)]


def reference(task: PairTask) -> float:
    """a [m], the centre distance without shifts."""
    one, two = task.teeth
    return task.module * (two - one if task.kind == "internal" else one + two) / (2 * cos(task.helix))


def _frees(task: PairTask, distance: float) -> bool:
    """Whether a strategy may end at another centre distance than this."""
    if task.strategy == "given_aw":
        return task.distance is not None and not isclose(task.distance, distance, rel_tol=SAME)
    return task.strategy not in ("zero", "equal_shift") or not isclose(reference(task), distance, rel_tol=SAME)


def _at(task: PairTask, distance: float) -> PairTask:
    """The same with the centre distance written out; zero and equal shift have it already."""
    return replace(task, distance=distance) if task.strategy == "given_aw" else task


def _free(asked: tuple[PairTask, ...], own: list[float]) -> list[PairTask]:
    """Meshes of their own centre distances; by the teeth unless they ask for another."""
    return [_at(task, distance) if task.distance is None else task for task, distance in zip(asked, own, strict=True)]


def _kept(asked: tuple[PairTask, ...], own: list[float], layout: Layout) -> tuple[list[PairTask], str]:
    """Every mesh at the centre distance of its teeth."""
    for task, distance in zip(asked, own, strict=True):
        if _frees(task, distance):
            raise _refused(task, f"every mesh of {layout.key} keeps the centre distance of its teeth", distance)
    told = ", ".join(f"{task.name} {millimetres(distance)}" for task, distance in zip(asked, own, strict=True))
    tasks = [_at(task, distance) for task, distance in zip(asked, own, strict=True)]
    return tasks, Phrase("every mesh keeps the centre distance of its teeth: {told}", told=told)


def _shared(
    task: PairsTask, asked: tuple[PairTask, ...], own: list[float], layout: Layout, solve: Solve
) -> tuple[list[PairTask], str]:
    """All meshes at one centre distance: that of the teeth, or the one at which the first ends."""
    first, distance, why = asked[0], max(own), "as its teeth have it"
    if _frees(first, distance):
        distance, why = solve(first).distance, Phrase("as mesh {name} asks", name=first.name)
    else:
        first = _at(first, distance)
    tasks = [first]
    for each in asked[1:]:
        usual = task.usual
        if (
            usual is not None
            and _choice(each) == _choice(usual)
            and (each.strategy != "zero" or _frees(each, distance))
        ):
            each = replace(each, strategy="given_aw", shifts=NEITHER, distance=None)
        if _frees(each, distance):
            raise _refused(
                each, f"all meshes of {layout.key} have one centre distance, and {first.name} sets it", distance
            )
        tasks.append(_at(each, distance))
    return tasks, Phrase(
        "all meshes have the centre distance {distance}, {why}", distance=millimetres(distance), why=why
    )


def _choice(task: PairTask) -> tuple[object, ...]:
    return task.strategy, task.shifts, task.distance


def _refused(task: PairTask, rule: str, distance: float) -> UsageError:
    by = millimetres(task.distance) if task.strategy == "given_aw" and task.distance else f"strategy {task.strategy}"
    return UsageError(
        f"mesh {task.name} asks for its own centre distance ({by}), but {rule}",
        where=WHERE,
        value=task.distance,
        limit=distance,
        remedy=f"for this mesh the strategy given_aw without a centre distance, which is then {millimetres(distance)}",
    )


def _solved(tasks: list[PairTask], layout: Layout, solve: Solve, remark: str) -> tuple[tuple[MeshPair, ...], list[str]]:
    """The pairs, chain by chain, and what there is to say; all meshes that cannot be made are told together."""
    pairs: list[MeshPair] = []
    remarks: list[str] = []
    errors: list[NoSolutionError] = []
    for chain in chains(layout):
        found, said, wrong = solve_chain([tasks[k] for k in chain], solve)
        pairs += found
        remarks += said
        errors += wrong
    if errors:
        every = error_of_all(errors, len(tasks))
        told = "\n".join(filter(None, (every.message, remark)))
        raise NoSolutionError(told, where=every.where, value=every.value, limit=every.limit, remedy=every.remedy)
    return tuple(pairs), remarks
