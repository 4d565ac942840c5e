"""Estimates of the law of motion against 50 digits on random programs: rows, extremes, constants."""

from __future__ import annotations

from dataclasses import replace

import pytest

from cams.exact import missed, motion_at, random_own
from cams.exact_peaks import extremes
from cams.scenes import briefly, judged, random_cam, some
from tmmcalc.cams.lawresult import solve_law
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.program import Phase, Program

FEW = 2


def the_law(random):
    """Rows, and the extremes of y', y'', y''' over the whole turn."""
    task, _ = random_cam(random, random.choice(["translating", "oscillating"]))
    found, rows = solve_law(task), task.positions
    which = some(random, len(rows.phi))
    exact = [motion_at(task.program, rows.phi[i], rows.piece[i]) for i in which]
    pairs = {}
    for order, name in enumerate(("displacement", "velocity", "acceleration", "jerk")):
        size = float(abs(found.motion[order]).max())
        if size:
            pairs[name] = found.error[name], missed(found.motion[order][which], [each[order] for each in exact], size)
    pairs["extremes"] = found.error["extremes"], max(_extremes_missed(task.program, found))
    return pairs


def _extremes_missed(program, found):
    for order in (1, 2, 3):
        low, high = extremes(program, lambda lib, phi, m, piece, order=order: m[order])
        size = max(abs(low[0]), abs(high[0]))
        for each in found.extremes:
            if each.order == order:
                off = abs(each.value - (high[0] if each.value > 0 else low[0]))
                yield float(off / size) if size else float(off)


def the_constants(random):
    """Cv, Ca, the braking with its lift, the jerk and the power of a law as a rise of 1 over 1."""
    names = list(LAWS)
    law = (
        LAWS[names[random.integers(len(names))]] if random.random() < 0.5 else random_own(random, f"{random.random()}")
    )
    stroke = 10 ** random.uniform(-3, 0)
    moves = (Phase("rise", 1.0, 0.0, stroke, law), Phase("return", 2.0, stroke, 0.0, law))
    task, _ = random_cam(random, "translating")
    found = solve_law(replace(task, program=Program(moves)))
    constants = found.phases[0].constants
    unit = Program((Phase("rise", 1.0, 0.0, 1.0, law),))
    (_, _), (cv, _) = extremes(unit, lambda lib, phi, m, piece: m[1])
    (least, _), (most, _) = extremes(unit, lambda lib, phi, m, piece: m[2])
    (low, _), (high, _) = extremes(unit, lambda lib, phi, m, piece: m[3])
    (_, _), (power, _) = extremes(unit, lambda lib, phi, m, piece: m[1] * m[2])
    pairs = [
        (constants.velocity, cv), (constants.acceleration, max(most, -least)), (constants.braking, least),
        (constants.power, power), (constants.largest_jerk, max(-low, high)),
    ]  # fmt: skip
    return {"constants": (found.error["constants"], max(float(abs(a / b - 1)) for a, b in pairs if b))}


@pytest.mark.parametrize("scene", [the_law, the_constants])
def test_estimates_in_a_few_scenes(scene):
    briefly(scene, 1, FEW)


@pytest.mark.slow
@pytest.mark.parametrize("scene", [the_law, the_constants])
def test_estimates(scene):
    judged(scene, 101)
