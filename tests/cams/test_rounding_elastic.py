"""Estimates of the vibration against Duhamel's integral in closed form at 50 digits on random cams."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from mpmath import mp, mpf

from cams.exact import missed
from cams.exact_vibration import Steady, residual
from cams.scenes import briefly, judged, random_cam, some
from tmmcalc.cams.elastic import solve_elastic
from tmmcalc.cams.task import Elastic, Loads, Spring

FEW = 2


def the_vibration(random):
    task, follower = random_cam(random, str(random.choice(["translating", "flat"])))
    omega, mass = 10 ** random.uniform(0, 2.5), 10 ** random.uniform(-3, 1)
    train = Elastic(
        mass * (omega * 10 ** random.uniform(-0.3, 2.0)) ** 2, float(random.choice([0.003, 0.02, 0.1, 0.5]))
    )
    task = replace(task, loads=Loads(omega, mass, spring=Spring("none")), elastic=train)
    found = solve_elastic(task, follower)
    exact = Steady(task.program, omega, mp.sqrt(mpf(train.stiffness) / mpf(mass)), train.damping)
    error = found.error
    inside = np.min(np.abs(found.phi[:, None] - task.program.edges), axis=1) > 1e-9
    which = np.flatnonzero(inside)[some(random, int(np.sum(inside)), 20)]
    true = [exact.at(mpf(float(each))) for each in found.phi[which]]
    pairs = {}
    for k, (name, values) in enumerate((("stretch", found.stretch), ("response", found.response))):
        size = float(np.max(np.abs(values)))
        pairs[name] = error[name], missed(values[which], [each[k] for each in true], size)
    ends = [(each.residual, each.steady) for each in found.phases]
    off = [abs(a - b) for told, both in zip(ends, exact.phases(), strict=True) for a, b in zip(told, both, strict=True)]
    pairs["residual"] = error["residual"], float(max(off) / exact.amplitude)
    law = next(phase.law for phase in task.program.phases if phase.law is not None)
    few = some(random, len(found.ratios), 12)
    values = found.spectra[0].residual
    true = [residual(law, float(found.ratios[i]), train.damping) for i in few]
    pairs["spectra"] = error["spectra"], missed(values[few], true, float(np.max(values)))
    return pairs


def test_estimates_in_a_few_scenes():
    briefly(the_vibration, 10, FEW)


@pytest.mark.slow
def test_estimates():
    judged(the_vibration, 110)
