"""Trailing rod of a V-engine on the master rod, for equally high top dead centres of both pistons (2.25a).

        D [ ]        left cylinder at beta, right cylinder along x; O: axis of the crank, OA = r, AB = l, AC = l_C
      l_4 /          crank on the left axis, phi = beta: AC and CD lie on that axis too,
      C                sin(phi_2) = -r sin(beta)/l,  phi_2 + alpha = beta,  alpha = beta + arcsin(r sin(beta)/l)
     / ` . l         O to D is r + l_C + l_4 there, and r + l at the top of the right piston: l_4 = l - l_C
O---A------` .[B]    y of C from the left axis: r sin(phi - beta) + l_C sin(phi_2 + alpha - beta), below l_4
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.linkage.model import Grid, Output
from tmmcalc.linkage.results import DeadCentre
from tmmcalc.linkage.synthesis.builders import Operation, VEngine, v_engine
from tmmcalc.linkage.synthesis.designs import SPEED, ClosedForm, closed_form
from tmmcalc.linkage.synthesis.results import PRESSURE, Check, Size, Synthesis
from tmmcalc.linkage.synthesis.simulation import SAMPLES, Simulation, check, simulate, tilts
from tmmcalc.linkage.synthesis.strokes import TURN
from tmmcalc.linkage.synthesis.task import SynthesisTask, TrailingRodTask

RULE = "the sizes follow one from another"
KIND = "trailing_rod"
TYPED = 1e-6  # of a size that is given: so near to the one found it is that one, typed with its digits
MASTER, TRAILING = 2, 4  # the rods among the links


def solve(task: SynthesisTask) -> Synthesis:
    """The trailing rod for the angle between the cylinders; raises `NoSolutionError` where the crank cannot turn."""
    asked: TrailingRodTask = task.asked
    exact = exact_of(asked)
    alpha = exact[0] if asked.lug_angle is None else asked.lug_angle
    length = exact[1] if asked.length is None else asked.length
    sizes = VEngine(asked.crank, asked.rod, asked.lug, alpha, length, asked.v_angle)
    _check_reach(sizes)
    return closed_form(task, KIND, RULE, [_closed(task, sizes, exact)])


def exact_of(asked: TrailingRodTask) -> tuple[float, float]:
    """Angle of the lug [rad] and length of the trailing rod [m] for equally high top dead centres."""
    return asked.v_angle + math.asin(asked.crank * math.sin(asked.v_angle) / asked.rod), asked.rod - asked.lug


def _check_reach(sizes: VEngine) -> None:
    """The trailing rod reaches the axis of its cylinder in every position of the crank."""
    phi = TURN * np.arange(SAMPLES) / SAMPLES
    rod = -np.arcsin(sizes.crank / sizes.rod * np.sin(phi))
    away = sizes.crank * np.sin(phi - sizes.angle) + sizes.lug * np.sin(rod + sizes.lug_angle - sizes.angle)
    k = int(np.argmax(np.abs(away)))
    far = float(abs(away[k]))
    if far >= sizes.length:
        raise NoSolutionError(
            f"the trailing rod, {1e3 * sizes.length:.6g} mm, does not reach the axis of its cylinder: its pin is "
            f"{1e3 * far:.6g} mm off at phi = {math.degrees(phi[k]):.4g} deg of the crank",
            where=f"synthesis.{KIND}",
            value=sizes.length,
            limit=far,
            remedy="write a smaller lug or crank, or a longer rod; a length or lug_angle that is given may be left out",
        )


def _closed(task: SynthesisTask, found: VEngine, exact: tuple[float, float]) -> ClosedForm:
    speed = SPEED if task.crank_speed is None else task.crank_speed
    outputs = Output("B"), Output("D", direction=found.angle)
    mechanism = v_engine(found, Operation(speed, math.pi, Grid(task.positions, extremes=True), outputs))
    simulation = simulate(mechanism)
    sizes = (
        Size("r", found.crank, "m", "crank OA"),
        Size("l", found.rod, "m", "master rod AB"),
        Size("l_C", found.lug, "m", "lug AC of the master rod"),
        Size("alpha", found.lug_angle, "rad", "lug AC from the master rod AB"),
        Size("l_4", found.length, "m", "trailing rod CD"),
        Size("beta", found.angle, "rad", "left cylinder from the right one"),
    )
    tops, bottoms = zip(*(_ends(simulation, k) for k in (0, 1)), strict=True)
    rods = _largest(simulation, MASTER, 0.0), _largest(simulation, TRAILING, found.angle)
    checks = (
        *_checks(task.asked, simulation, tops, bottoms),
        check("largest pressure angle of the master rod", rods[0], "rad"),
        check("largest pressure angle of the trailing rod", rods[1], "rad"),
    )
    merits = {PRESSURE.key: math.degrees(max(rods)), "r/l": found.crank / found.rod}
    defects = tuple(_defects(found, exact, tops))
    return ClosedForm("V-engine with a trailing rod", sizes, checks, merits, mechanism, simulation, (), defects)


def _ends(simulation: Simulation, piston: int) -> tuple[DeadCentre, DeadCentre]:
    """Top and bottom dead centre of a piston: the farthest from the crank's axis and the nearest."""
    centres = simulation.result.summaries[piston].dead_centres
    return max(centres, key=lambda each: each.value), min(centres, key=lambda each: each.value)


def _largest(simulation: Simulation, rod: int, guide: float) -> float:
    """Largest pressure angle [rad] of a rod against a guide at this angle."""
    return max(tilt.largest for tilt in tilts(simulation, rod, complex(math.cos(guide), math.sin(guide))))


def _checks(
    asked: TrailingRodTask, simulation: Simulation, tops: tuple[DeadCentre, ...], bottoms: tuple[DeadCentre, ...]
) -> Iterator[Check]:
    """Strokes and dead centres; those of the left piston have targets where nothing of its rod is given."""
    free = asked.lug_angle is None and asked.length is None
    top, (right, left) = asked.crank + asked.rod, tops
    yield check("S", simulation.stroke, "m", 2 * asked.crank)
    yield check("S of the left piston", left.value - bottoms[1].value, "m")
    yield check("top of the right piston", right.value, "m", top)
    yield check("top of the left piston", left.value, "m", top if free else None)
    at = asked.v_angle + math.remainder(left.x - asked.v_angle, TURN)
    yield check("crank at the top of the left piston", at, "rad", asked.v_angle if free else None)
    yield check("crank at the bottom of the left piston", bottoms[1].x % TURN, "rad")


def _defects(found: VEngine, exact: tuple[float, float], tops: tuple[DeadCentre, ...]) -> Iterator[str]:
    """What sizes that are given do to the top dead centres."""
    right, left = tops
    if abs(math.remainder(found.lug_angle - exact[0], TURN)) > TYPED:
        yield (
            f"the lug stands at {math.degrees(found.lug_angle):.6g} deg, not at alpha = {math.degrees(exact[0]):.6g} "
            f"deg: the left piston is at its top with the crank at {math.degrees(left.x) % 360:.5g} deg, "
            f"not on the axis of its cylinder, {math.degrees(found.angle):.5g} deg"
        )
    if abs(found.length - exact[1]) > TYPED * found.rod:
        yield (
            f"the trailing rod has {1e3 * found.length:.6g} mm, not l - l_C = {1e3 * exact[1]:.6g} mm: the top of the "
            f"left piston is {1e3 * left.value:.6g} mm from the crank's axis, that of the right one "
            f"{1e3 * right.value:.6g} mm"
        )
