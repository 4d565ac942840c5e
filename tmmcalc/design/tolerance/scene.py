"""The study of a spec: its tolerances and constraints, its results by the batch engine."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.batch.choice import heavy
from tmmcalc.batch.reading import frame_of
from tmmcalc.batch.sweep import sweep
from tmmcalc.batch.task import BROKEN, Row, Task
from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.design.model import BLOCK, Answers, Model, Told, solver_of
from tmmcalc.design.sensitivity import sensitivity
from tmmcalc.design.sizes import scales, varied
from tmmcalc.design.tolerance.balance import Law
from tmmcalc.design.tolerance.sampling import sizes
from tmmcalc.design.tolerance.sources import Values
from tmmcalc.design.tolerance.study import Tolerated, ranges, study
from tmmcalc.design.tolerance.task import sources_of, varying
from tmmcalc.design.tolerance.yields import Rule
from tmmcalc.feasibility.quantities import limits, of_given
from tmmcalc.feasibility.tables.tasks.feasibility import to_feasibility
from tmmcalc.naming.language import parse
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import one
from tmmcalc.pipeline.runner import run
from tmmcalc.project.loader import Variants, read_text

if TYPE_CHECKING:
    from tmmcalc.project import Spec

MANY = 2**13  # places that are worth starting processes
BAND = "--band"
REACH = 1.6  # of half the range of a key: samples lie within, but for one in a million


@record
class Asked:
    """What is asked of a spec, and who computes it."""

    file: Path
    overrides: tuple[str, ...] = ()
    of: tuple[str, ...] = ()  # names of results; those of the constraints come beside them
    band: str = ""  # a column of a table over positions, with its stage
    samples: int = 2**14
    seed: int = 1
    jobs: int | None = None
    scheduler: str | None = None
    out: Path | None = None  # the samples; what an earlier run has done is not done again
    fresh: bool = False
    balance: Law | None = "cost"  # by which all tolerances are balanced at equal yield


def tolerate(asked: Asked, told: Told = lambda done: None, warn: Callable[[str], None] = print) -> Tolerated:
    """The study; raises UsageError for tolerances that do not fit, and the error of the spec as it is."""
    variants = Variants(read_text(asked.file), str(asked.file), asked.file.parent, asked.overrides)
    spec = variants.spec()
    constraints = [each.asked.text for each in to_feasibility(spec).constraints if each.given is None]
    wanted = [*dict.fromkeys([*asked.of, *constraints])]
    if not wanted:
        raise UsageError("no result is asked for", where="--of", remedy="name results, or add [[constraints]]")
    course = _band(asked.band, spec)
    keys = varying(spec.tolerances, variants.data)
    frame = frame_of(asked.file, asked.overrides, keys, [*dict.fromkeys([*wanted, *course])])
    _check(frame)
    sources = sources_of(spec.tolerances, variants.data, frame.axes, partial(_pressed, spec))
    model = _model(frame, asked.band, {*course} - {*wanted})
    many = solver_of(frame, sizes(asked.samples), asked.jobs, asked.scheduler, warn)
    lines = sensitivity(asked.file, wanted, keys, asked.overrides, scheduler=asked.scheduler, tell=warn)
    names = [*lines.names, *(name for name in model.names if name not in lines.names)]
    order = [model.names.index(name) for name in names]
    # processes are no use to the few places at a time of a search, unless each takes long
    near = (model.by(many) if heavy(frame) else model).over(
        range(len(keys)), *(model.nominal + end * REACH * ranges(sources) for end in (-1, 1))
    )
    bare = {parse(name).text: at for at, name in enumerate(names)}

    every = near.by(many)

    def solved(places: Values) -> tuple[Values, Sequence[str]]:
        answers = every(places, told) if asked.out is None else _kept(every, frame, places, asked, told)
        return answers.values[:, order], answers.reasons

    return study(
        names,
        model.keys,
        model.nominal,
        model.found[order],
        sources,
        [[each.slope for each in lines.partials if each.name == name] for name in lines.names],
        lambda places: (every if len(places) > MANY else near)(places).values[:, order],
        solved,
        _rule(spec, model, names),
        samples=sizes(asked.samples),
        seed=asked.seed,
        band=[bare[parse(name).text] for name in course],
        law=asked.balance,
    )


def _pressed(spec: Spec, joint: str, link: int) -> complex:
    """The direction of the reaction on a link in its own axes, where the reaction is largest over the motion."""
    found = run(spec, target=("forces",)).results
    if "forces" not in found:
        rule = f"no force is known in {joint}: the spec has no loads, masses or springs"
        raise UsageError(rule, where="tolerances", remedy='write direction = "any", or an angle')
    forces = found["forces"]
    at = next(j for j, pair in enumerate(forces.pairs) if pair.joint == joint)
    size = np.abs(forces.reaction[at])
    row = int(np.argmax(size))
    if size[row] == 0:
        raise UsageError(f"{joint} has no reaction", where="tolerances", remedy='write direction = "any"')
    label = forces.labels[row].rstrip("-")
    turned = math.radians(one(parse(f"kinematics.angle_{link}@{label}"), found).value) if link else 0.0
    force = complex(forces.reaction[at][row]) * (1 if link == max(forces.pairs[at].links) else -1)
    return force / size[row] * cmath.exp(-1j * turned)


def _check(frame: Task) -> None:
    """Raise UsageError for a key that takes no small change, such as a number of teeth."""
    for axis, reason in zip(frame.axes, varied(frame, scales(frame.axes)), strict=True):
        if reason:
            raise UsageError(f"{axis.key} takes no small change: {reason}", where="tolerances", remedy="leave it out")


def _kept(model: Model, frame: Task, places: Values, asked: Asked, told: Told) -> Answers:
    """The results at places, which are kept in a table; what an earlier run has done is not done again."""
    task = replace(frame.at(places.tolist()), patterns=model.names, block=BLOCK)

    def solve(task: Task, blocks: Iterable[Sequence[int]]) -> Iterator[list[Row]]:
        left = {point for block in blocks for point in block}
        numbers = dict.fromkeys(point // BLOCK for point in left)
        # whole blocks, so that digits do not depend on what is done already
        every = (at for number in numbers for at in range(number * BLOCK, min((number + 1) * BLOCK, task.count)))
        for rows in model.rows((at, task.values(at)) for at in every):
            yield [row for row in rows if row.point in left]

    sheet = sweep(task, solve, asked.out, fresh=asked.fresh, told=lambda done, failed: told(done)).sheet
    if BROKEN in sheet.status:
        raise RuntimeError(sheet.reasons[sheet.status.index(BROKEN)])
    place = {name: at for at, name in enumerate(sheet.names)}
    columns = [sheet.values[:, place[name]] if name in place else np.full(len(places), np.nan) for name in model.names]
    return Answers(np.array(columns).T, sheet.reasons)


def _model(frame: Task, band: str, course: Collection[str]) -> Model:
    """The results of the frame; raises UsageError for a band that is no column as such, and not for its rows."""
    try:
        return Model(frame, brief=True, where=lambda name: BAND if name in course else "--of")
    except UsageError as error:
        if error.where != BAND:
            raise
        remedy = error.remedy.replace("@0", "")
        raise UsageError(f"no column is called {band!r}", where=BAND, remedy=remedy) from None


def _band(column: str, spec: Spec) -> list[str]:
    """The names of a column at all positions of a turn."""
    if not column:
        return []
    try:
        name = parse(column)
    except UsageError as error:
        raise UsageError(error.message, where=BAND, remedy=error.remedy) from None
    if spec.mechanism is None or not name.stage or not name.fact or name.wild:
        remedy = "name a column with its stage, e.g. --band kinematics.S_D"
        raise UsageError(f"{column!r} is no column over the positions of a mechanism", where=BAND, remedy=remedy)
    unit = f"[{name.unit}]" if name.unit else ""
    return [f"{name.text}@{at}{unit}" for at in range(spec.mechanism.grid.positions)]


def _rule(spec: Spec, model: Model, names: Sequence[str]) -> Rule | None:
    """The constraints on columns of the results, with limits in their units; None without any."""
    task = to_feasibility(spec)
    if not task.constraints:
        return None
    scene = Scene(model.run.spec, model.run.results)
    limited, given = {}, {}
    for each in task.constraints:
        if each.given is not None:
            value, unit = of_given(each)
            low, high = limits(each, unit)
            given[each.name] = (low is None or value >= low) and (high is None or value <= high)
        else:
            found = one(each.asked, model.run.results, scene)
            limited[each.name] = names.index(found.key), limits(each, found.unit)
    return Rule(task.combined, limited, given)
