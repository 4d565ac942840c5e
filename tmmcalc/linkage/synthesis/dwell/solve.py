"""Six-bars of class IV with a dwell: by three positions, by lengths, or the best ones of a search; each analysed."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.core.errors import AccuracyError, AssemblyError, NoSolutionError, SingularityError, UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.plane import Real
from tmmcalc.core.progress import tell
from tmmcalc.core.quantity import keyed, quantity_of
from tmmcalc.linkage.synthesis.designs import CLOSED, SPEED, largest_residual, remarks
from tmmcalc.linkage.synthesis.dwell.advice import advice
from tmmcalc.linkage.synthesis.dwell.analysis import analysed
from tmmcalc.linkage.synthesis.dwell.correction import corrected
from tmmcalc.linkage.synthesis.dwell.criteria import NAMES as CRITERIA
from tmmcalc.linkage.synthesis.dwell.criteria import achieved
from tmmcalc.linkage.synthesis.dwell.exact import Figures, figures
from tmmcalc.linkage.synthesis.dwell.mechanism import Setting, loading_of, mechanism_of
from tmmcalc.linkage.synthesis.dwell.parameters import NAMES, USUAL, drawn, given
from tmmcalc.linkage.synthesis.dwell.results import Dwell
from tmmcalc.linkage.synthesis.dwell.sizes import scale_of, sizes_of
from tmmcalc.linkage.synthesis.dwell.task import DwellTask
from tmmcalc.linkage.synthesis.dwell.turn import patient_turn
from tmmcalc.linkage.synthesis.ready import ready_spec
from tmmcalc.linkage.synthesis.results import Check, Design, SearchStep, Size, Synthesis
from tmmcalc.linkage.synthesis.simulation import check
from tmmcalc.linkage.synthesis.task import SynthesisTask

if TYPE_CHECKING:
    from tmmcalc.linkage.synthesis.dwell.constraints import Rule

WHERE = "synthesis.dwell"
STEPS = 360  # of the turn of a linkage that is analysed
ERROR = quantity_of(Dwell, "dwell_ratio").shown("%")[0]
FREE = ("n", "left")  # which have usual values where nothing is sought


def solve(task: SynthesisTask) -> Synthesis:
    """The linkages, the best first; raises `NoSolutionError` with the reason if none works."""
    asked: DwellTask = task.asked
    if task.crank_speed is not None and task.crank_speed < 0:
        asked = replace(asked, clockwise=True)
    rows, counters, rule, course = _rows(task, asked)
    remarked: list[tuple[Design, list[str]]] = []
    for k, row in enumerate(rows):
        tell(0.95, f"analysis {k + 1} of {len(rows)}")
        try:
            remarked.append(_design(task, asked, row))
        except (NoSolutionError, SingularityError, AssemblyError):
            if k + 1 == len(rows) and not remarked:
                raise
    remarked.sort(key=lambda found: found[0].merits.get("cost", found[0].merits[ERROR]))
    designs = [design for design, _ in remarked]
    notes = remarked[0][1]
    residual = max(_residual(design) for design in designs)
    if residual > CLOSED:
        raise AccuracyError(
            f"the simulated mechanism misses a target by {residual:.3g}",
            where=f"{WHERE}, post-check",
            value=residual,
            limit=CLOSED,
            remedy="keep clear of sizes at which the crank only just turns",
        )
    if task.crank_speed is None:
        notes.append(Phrase("note: no speed is given: the ready spec turns its crank at {speed:g} rad/s", speed=SPEED))
    if asked.frame is None and asked.stroke is None:
        notes.append("note: no length gives the scale: l_OB = 1 m")
    return Synthesis("dwell", rule, tuple(designs), residual, tuple(notes), counters, course)


def _rows(task: SynthesisTask, asked: DwellTask) -> tuple[Real, dict[str, int], str, tuple[SearchStep, ...]]:
    """Parameters (k, 9) of the linkages that are analysed, what a search counted, the rule of choice, the search."""
    if asked.optimum is not None:
        from tmmcalc.linkage.synthesis.dwell.optimum import search

        rule = _rule(task, asked)
        found = search(asked, asked.optimum, task.seed, task.solutions, rule)
        weights = ", ".join(f"{w:g} {name}" for w, name in zip(asked.optimum.weights, CRITERIA, strict=True) if w)
        counters = {"linkages tried": found.tried, "worked": found.worked}
        counters |= {f"refused: {reason}": count for reason, count in found.refused.items() if count}
        if rule is not None:
            counters["kept the constraints"] = rule.kept
            counters |= {f"failed {name}": count for name, count in rule.failing.items()}
        return found.rows, counters, f"the least sum of {weights}", found.course
    values = given(asked)
    missing = [name for name in NAMES if values[name] is None and name not in FREE]
    if missing and asked.lengths is None:
        raise UsageError(
            f"nothing gives {', '.join(missing)}",
            where=WHERE,
            remedy="give it, or add [synthesis.dwell.optimum], which seeks what is not given",
        )
    sides = [0.0, 1.0] if asked.output == "rocker" and values["left"] is None else [values["left"] or 0.0]
    usual = {name: USUAL if values[name] is None else values[name] for name in NAMES}
    rows = np.array([list((usual | {"left": side}).values()) for side in sides], dtype=float)
    _refuse(drawn(asked, rows).faults, len(rows))
    return rows, {}, "the dwell's largest deviation as a part of the stroke", ()


def _rule(task: SynthesisTask, asked: DwellTask) -> Rule | None:
    """What the user's constraints ask of a candidate of the search; None without them."""
    if task.constraints is None:
        return None
    from tmmcalc.linkage.synthesis.dwell.constraints import Rule

    return Rule(task.constraints, asked)


def _refuse(faults: dict[str, np.ndarray], count: int) -> None:
    """Raise the reason if every candidate is refused."""
    refused = np.any(list(faults.values()), axis=0)
    if refused.sum() == count:
        reasons = [reason for reason, flags in faults.items() if flags.any()]
        raise NoSolutionError(
            f"the linkage does not work: {'; '.join(reasons)}",
            where=WHERE,
            remedy="change the positions of the bar BC, or let [synthesis.dwell.optimum] seek some of the parameters",
        )


def _design(task: SynthesisTask, asked: DwellTask, row: Real) -> tuple[Design, list[str]]:
    """The design of one row of parameters, with its remarks."""
    values = dict(zip(NAMES, row.tolist(), strict=True))
    linkages, n, met = drawn(asked, row[None, :]).linkages, values["n"], True
    if asked.exact:
        linkages, n, met = corrected(asked, linkages, n, values["left"] >= 0.5)
    turn = patient_turn(linkages, STEPS)
    _refuse(turn.faults, 1)
    found = figures(turn, asked)
    scale = float(scale_of(asked, np.array([found.stroke]))[0])
    growing = (_far(found) < 0) == (asked.working == "towards")
    speed = abs(task.crank_speed or SPEED) * (-1 if asked.clockwise else 1)
    mechanism = mechanism_of(linkages, Setting(scale, speed, task.positions, growing))
    dwell = analysed(asked, turn, found, mechanism, scale)
    own_n = None if asked.pivot is not None else n
    columns = {name: np.array([value]) for name, value in (values | {"n": n}).items()}
    listed = sizes_of(asked, linkages, columns, np.array([scale]))
    sizes = tuple(Size(each.symbol, float(each.values[0]), each.unit, each.meaning) for each in listed)
    loading = loading_of(linkages, asked.resistance, growing)
    text = ready_spec(mechanism, task.title or "six-bar with a dwell", tuple(remarks(sizes)), loading.loads)
    design = Design(
        f"six-bar of class IV, {asked.output}",
        sizes,
        tuple(_checks(asked, found, dwell, met)),
        _merits(dwell),
        tuple(_defects(task, found)),
        text,
        dwell=dwell,
    )
    notes = list(advice(asked, found, own_n))
    if not met:
        notes.append(
            "warning: swing or working angle cannot be met exactly on this linkage: the rules of n and l_OF are kept"
        )
    return design, notes


def _far(found: Figures) -> float:
    return max((value for value, _ in found.reversals), key=abs)


def _checks(asked: DwellTask, found: Figures, dwell: Dwell, met: bool) -> Iterator[Check]:
    """What the simulation gives, beside its target where one was asked for and could be met."""
    targets = {"stroke h": asked.stroke}
    if asked.exact and met and asked.pivot is None:
        targets |= {"swing": asked.swing, "stroke towards the dwell": asked.working_angle}
    size, rest, far = (np.array([v]) for v in (found.stroke, found.dwell[0], found.far))
    told = achieved(asked, size, rest, far, np.array([dwell.stroke / found.stroke]))
    for name, (values, unit) in told.items():
        yield check(name, float(values[0]), unit, targets.get(name))


def _merits(dwell: Dwell) -> dict[str, float]:
    merits = keyed(dwell, "dwell_ratio[%]")
    merits |= dict(zip(CRITERIA, dwell.criteria, strict=True))
    return merits if dwell.cost is None else merits | keyed(dwell, "cost")


def _defects(task: SynthesisTask, found: Figures) -> Iterator[str]:
    steepest = found.largest["delta"][0]
    if math.pi / 2 - steepest < task.transmission:
        yield (
            Phrase(
                "transmission: the least angle is {found:.4g} deg, below {limit:.4g} deg",
                found=90 - math.degrees(steepest),
                limit=math.degrees(task.transmission),
            )
        )


def _residual(design: Design) -> float:
    """The largest residual against targets and between methods."""
    if design.dwell is None:
        return largest_residual(design)
    found = design.dwell.agreement
    return max(largest_residual(design), found.motion, found.forces, found.virtual_work, found.positions)
