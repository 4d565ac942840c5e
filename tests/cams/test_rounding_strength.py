"""Estimates of the requirements, rows and what their margins are made of, against 50 digits on random cams."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from mpmath import mpf

from cams.exact import missed, motion_at
from cams.exact_forces import Loaded
from cams.exact_peaks import EXACT
from cams.exact_strength import Judged
from cams.loaded import random_loaded
from cams.scenes import briefly, judged, some
from tmmcalc.cams.strength.solve import solve_strength
from tmmcalc.cams.task import Requirements

FEW = 1
ROWS = ("curvature", "run", "stress", "reduced", "bending", "pressure")


def required(random):
    """A loaded cam with all requirements; sizes of pin and stem are of the order of the follower's."""
    task, follower, rate = random_loaded(random)
    size, given = follower.start if follower.kind != "oscillating" else follower.rocker, random.random() < 0.3
    needs = Requirements(
        width=0.1 * size, contact=4e8, rolling_arm=1e-3 * size, roller_friction=random.uniform(0.05, 0.3),
        pin_friction=0.1, pin=0.3 * follower.roller, span=2 * size, bending=1e8, deflection=1e-5,
        guide_pressure=5e6, roller_inertia=1e-5 * size**5 if given else None,
    )  # fmt: skip
    if random.random() < 0.5 and follower.roller:
        needs = replace(needs, pin=None, pin_pressure=10 ** random.uniform(5, 8))
    return (
        replace(task, guide=replace(task.guide, stem=0.1 * size, land=0.1 * size), requirements=needs),
        follower,
        rate,
    )


def the_rows(random):
    task, follower, rate = required(random)
    found, rows = solve_strength(task, follower), task.positions
    exact = Judged(Loaded(task, follower, rate))
    which = some(random, len(rows.phi), 12)
    at = [(EXACT, mpf(float(rows.phi[i])), motion_at(task.program, rows.phi[i], rows.piece[i]), rows.piece[i])
          for i in which]  # fmt: skip
    pairs, formulas = {}, {name: getattr(exact, name) for name in ROWS}
    if found.slip is not None:
        formulas["slip"] = exact.slip(*exact.factors())
    for name, formula in formulas.items():
        values = getattr(found, name)
        if values is None or not np.any(values):
            continue
        true = [formula(*each) for each in at]
        if name in ("slip", "stress"):
            true = [each if values[i] else mpf(0) for each, i in zip(true, which, strict=True)]
        pairs[name] = found.error[name], missed(values[which], true, float(np.max(np.abs(values))))
    return pairs


def the_margins(random):
    """Every value and limit that is an extreme, or made of one."""
    task, follower, rate = required(random)
    found = solve_strength(task, follower)
    exact = Judged(Loaded(task, follower, rate))
    return {"extremes": (found.error["extremes"], max(map(float, _missed(task, found, exact))))}


def _missed(task, found, exact):
    named = {each.name: each for each in found.margins}
    low, high = exact.ends(exact.curvature)
    size = max(abs(low), abs(high))
    if found.convex:
        convex = 1 / high if not exact.flat else exact.ends(lambda *x: 1 / exact.curvature(*x))[0]
        yield abs(found.convex - convex) * (1 / convex**2 / size if not exact.flat else 1 / convex)
    if found.concave is not None:
        yield abs(1 / found.concave + low) / size
    for name, formula in (("bending of the stem", exact.bending), ("pressure in the guide", exact.pressure),
                          ("contact stress", exact.stress)):  # fmt: skip
        value = named[name].value
        if value:
            yield abs(value / exact.ends(formula)[1] - 1)
    if found.unit is not None:
        yield abs(found.unit.pin / exact.pin - 1)
    for value, true in zip((found.shaft.strength, found.shaft.stiffness), exact.shafts(), strict=True):
        yield abs(value / true - 1)
    slip = named["no slip"].value
    if slip:
        yield abs(slip / exact.ends(exact.slip(*exact.factors()))[1] - 1)


SCENES = (the_rows, the_margins)


@pytest.mark.parametrize("scene", SCENES)
def test_estimates_in_a_few_scenes(scene):
    briefly(scene, 8, FEW)


@pytest.mark.slow
@pytest.mark.parametrize("scene", SCENES)
def test_estimates(scene):
    judged(scene, 108)
