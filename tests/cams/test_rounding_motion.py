"""Laws of motion and pitch curves against 50 digits on random cams: formulas and their precision."""

from __future__ import annotations

import numpy as np
import pytest
from mpmath import mpf
from sparing import sparing

from cams.exact import law_at, missed, motion_at, pitch_at
from cams.scenes import KINDS, random_cam, some
from tmmcalc.cams.follower import contact_path, curvature
from tmmcalc.cams.laws.catalogue import LAWS


@pytest.mark.parametrize("name", LAWS)
def test_laws_and_their_derivatives(name):
    """To the last digits: all pieces at random places and at their ends."""
    law, random = LAWS[name], np.random.default_rng(3)
    for piece in range(law.count):
        low, high = law.breaks[piece : piece + 2]
        k = np.concatenate(([low], random.uniform(low, high, 40), [high]))
        found = law.at(k, np.full(len(k), piece))
        exact = [law_at(law, each, piece) for each in map(mpf, k.tolist())]
        for order in range(4):
            size = max(1.0, float(np.max(np.abs(law.at(np.linspace(0, 1, 99))[order]))))
            assert missed(found[order], [each[order] for each in exact], size) < 1e-13


@sparing("kind", KINDS, every=3)
def test_points_and_curvature(kind):
    random = np.random.default_rng(5)
    for _ in range(12):
        task, follower = random_cam(random, kind)
        rows = task.positions
        path = contact_path(follower, rows.phi, task.motion)
        which = some(random, len(rows.phi))
        exact = [pitch_at(follower, rows.phi[i], motion_at(task.program, rows.phi[i], rows.piece[i])) for i in which]
        assert missed(path[0][which], [each[0] for each in exact]) < 1e-13
        if kind != "flat":
            assert missed(curvature(path)[which], [each[2] for each in exact]) < 1e-12
