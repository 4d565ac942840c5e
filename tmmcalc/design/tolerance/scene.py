"""The study of a spec: its tolerances and constraints, its results by the batch engine."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.batch.reading import frame_of
from tmmcalc.batch.sweep import sweep
from tmmcalc.batch.task import BROKEN, Row, Task
from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.design.model import Model, solver_of
from tmmcalc.design.tolerance.sampling import sizes
from tmmcalc.design.tolerance.sources import Values
from tmmcalc.design.tolerance.study import Tolerated, ranges, study
from tmmcalc.design.tolerance.task import keys_of, sources_of
from tmmcalc.design.tolerance.yields import Rule
from tmmcalc.feasibility.quantities import limits, of_given
from tmmcalc.feasibility.tables.tasks.feasibility import to_feasibility
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import one
from tmmcalc.project.loader import Variants, read_text

if TYPE_CHECKING:
    from tmmcalc.project import Spec

REACH = 1.6  # of half the range of a key: samples lie within, but for one in a million
Told = Callable[[int, int], None]  # samples done, of these without a result


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


def tolerate(asked: Asked, told: Told = lambda done, failed: None, warn: Callable[[str], None] = print) -> Tolerated:
    """The study; raises UsageError for tolerances that do not fit, and the error of the spec as it is."""
    variants = Variants(read_text(asked.file), str(asked.file), asked.file.parent, asked.overrides)
    spec = variants.spec()
    constraints = [each.asked.text for each in to_feasibility(spec).constraints if each.given is None]
    band = _band(asked.band, spec)
    patterns = [*dict.fromkeys([*asked.of, *constraints, *band])]
    if not {*patterns} - {*band}:
        raise UsageError("no result is asked for", where="--of", remedy="name results, or add [[constraints]]")
    keys = keys_of(spec.tolerances, variants.data)
    frame = frame_of(asked.file, asked.overrides, keys, patterns)
    sources = sources_of(spec.tolerances, variants.data, frame.axes)
    model = Model(frame, solver_of(frame, sizes(asked.samples), asked.jobs, asked.scheduler, warn))
    near = model.over(range(len(keys)), *(model.nominal + end * REACH * ranges(sources) for end in (-1, 1)))
    rows = {_bare(name): at for at, name in enumerate(model.names)}
    last = [rows[name] for name in band]
    order = [at for at in range(len(model.names)) if at not in last] + last
    names = [model.names[at] for at in order]

    def by_places(task: Task, blocks: Iterable[Sequence[int]]) -> Iterator[list[Row]]:
        return near.rows((point, task.values(point)) for block in blocks for point in block)

    def solved(places: Values) -> tuple[Values, Sequence[str]]:
        task = replace(frame.at(places.tolist()), patterns=model.names)
        sheet = sweep(task, by_places, asked.out, fresh=asked.fresh, told=told).sheet
        if BROKEN in sheet.status:
            raise RuntimeError(sheet.reasons[sheet.status.index(BROKEN)])
        place = {name: at for at, name in enumerate(sheet.names)}
        columns = [sheet.values[:, place[name]] if name in place else np.full(len(places), np.nan) for name in names]
        return np.array(columns).T, sheet.reasons

    return study(
        names,
        model.keys,
        model.nominal,
        sources,
        lambda places: near(places).values[:, order],
        solved,
        _rule(spec, model, names),
        samples=sizes(asked.samples),
        seed=asked.seed,
        columns=range(len(names) - len(last)),
    )


def _bare(name: str) -> str:
    """A name without its unit."""
    return name.rpartition("[")[0] if name.endswith("]") and not name.endswith("@]") else name


def _band(column: str, spec: Spec) -> list[str]:
    """The names of a column at all positions of a turn."""
    if not column:
        return []
    if spec.mechanism is None or "." not in column or "@" in column:
        remedy = "name a column with its stage, e.g. --band kinematics.S_D"
        raise UsageError(f"{column!r} is no column over the positions of a mechanism", where="--band", remedy=remedy)
    return [f"{column}@{at}" for at in range(spec.mechanism.grid.positions)]


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
