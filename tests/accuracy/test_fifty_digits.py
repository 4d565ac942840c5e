"""What is computed beside 50 digits of mpmath: dyads by their closure equations, involutes, laws of cams."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from cams.exact import law_at
from mpmath import mp, mpc, mpf
from random_mechanisms import KINDS, build
from reference import solve
from sparing import sparing

from tmmcalc import Kinematics, TmmError, solve_kinematics
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.gears.involute.function import inverse_involute, involute
from tmmcalc.linkage.model import FRAME, Mechanism

WORST = 25.0  # amplification of a scene that is compared
SMALL = 0.3  # [rad] below it the involute is a series
CANCELS = 2e-14  # of a law: near its end a polynomial cancels terms of up to 84
NEWTON = 5  # from double precision: digits double
APART = mpf(10) ** -15  # of the input, for derivatives by differences; what they leave is of its square


@cache
def _scene(kind: str) -> tuple[Mechanism, Kinematics, np.ndarray]:
    """A crank with one dyad that is far from a dead point, solved, with rough body coordinates (n, links, 3)."""
    for seed in range(50):
        scene = build(np.random.default_rng(seed), [kind], prismatic_input=False, positions=3)
        try:
            result = solve_kinematics(scene.mechanism)
        except TmmError:
            continue
        if max(quality.amplification for quality in result.qualities) < WORST:
            return scene.mechanism, result, solve(scene.mechanism, scene.start, result.x).bodies
    raise AssertionError(f"no regular scene of {kind}")


def _closed(mechanism: Mechanism, rough: np.ndarray, x: mpf) -> dict[int, tuple[mpc, mpf]]:
    """Place and angle of every link at the crank's angle x, from the closure of all joints at once."""
    links = [link.id for link in mechanism.links]

    def bodies(q: tuple[mpf, ...]) -> dict[int, tuple[mpc, mpf]]:
        found = {k: (mpc(q[3 * i], q[3 * i + 1]), q[3 * i + 2]) for i, k in enumerate(links)}
        return {**found, FRAME: (mpc(0), mpf(0))}

    def left(*q: mpf) -> list[mpf]:
        at, open_ = bodies(q), []
        for joint in mechanism.joints:
            (r, a), (s, b) = (at[k] for k in joint.links)
            first, second = (mpc(p) for p in joint.points)
            apart = r + first * mp.expj(a) - s - second * mp.expj(b)
            if joint.kind == "revolute":
                open_ += [apart.real, apart.imag]
                continue
            along, guide = (mpc(d) * mp.expj(angle) for d, angle in zip(joint.directions, (a, b), strict=True))
            open_ += [(mp.conj(guide) * apart).imag, (mp.conj(guide) * along).imag / abs(along)]
        driver = mechanism.joint(mechanism.input.joint)
        open_.append(at[next(k for k in driver.links if k != FRAME)][1] - x)
        return open_

    q = mp.matrix([mpf(value) for value in rough.ravel().tolist()])
    for _ in range(NEWTON):
        q -= mp.lu_solve(mp.jacobian(lambda *each: left(*each), q), mp.matrix(left(*q)))
    assert mp.norm(mp.matrix(left(*q))) < mpf(10) ** -50
    return bodies(tuple(q))


def _point(mechanism: Mechanism, name: str, at: dict[int, tuple[mpc, mpf]]) -> mpc:
    link = next(link for link in (*mechanism.links, mechanism.frame) if name in link.points)
    place, angle = at[link.id]
    return place + mpc(link.points[name]) * mp.expj(angle)


@sparing("kind", KINDS, every=3)
def test_dyads(kind: str) -> None:
    """Positions, velocities and accelerations of all points, within what the program estimates of them."""
    mechanism, result, bodies = _scene(kind)
    trace, missed = result.trace, [0.0, 0.0, 0.0]
    with mp.workdps(60):
        for n in range(1, len(result.x), 2):
            x = mpf(float(result.x[n]))
            three = [_closed(mechanism, bodies[n], x + side * APART) for side in (-1, 0, 1)]
            for k, name in enumerate(trace.point_names):
                low, here, high = (_point(mechanism, name, at) for at in three)
                exact = here, (high - low) / (2 * APART), (high - 2 * here + low) / APART**2
                for order, found in enumerate((trace.r, trace.dr, trace.ddr)):
                    missed[order] = max(missed[order], float(abs(mpc(complex(found[k, n])) - exact[order])))
    sizes = [float(np.max(np.abs(values))) for values in (trace.r, trace.dr, trace.ddr)]
    errors = [a / b for a, b in zip(missed, sizes, strict=True)]
    estimates = (result.error.position, result.error.velocity, result.error.acceleration)
    assert all(error <= estimate for error, estimate in zip(errors, estimates, strict=True)), errors
    assert max(errors) < 1e-14 * WORST


def test_involute_and_its_inverse() -> None:
    angles = np.concatenate((10.0 ** np.arange(-6.0, -1.0), np.linspace(0.05, 1.55, 61)))
    values, back = involute(angles), inverse_involute(involute(angles))
    with mp.workdps(50):
        for angle, value, again in zip(angles.tolist(), values.tolist(), back.tolist(), strict=True):
            exact = mp.tan(mpf(angle)) - mpf(angle)
            # the rounding of the angle, times the slope; from 0.3 on that of the tangent, of which the angle is taken
            condition = float(angle * mp.tan(angle) ** 2 / exact + (mp.tan(angle) / exact if angle >= SMALL else 0))
            assert abs(value / exact - 1) < 2e-16 * (1 + condition)
            root = mp.findroot(lambda a, value=value: mp.tan(a) - a - mpf(value), mpf(angle))
            assert abs(again / root - 1) < 1e-15


@pytest.mark.parametrize("name", sorted(LAWS))
def test_laws_of_cams(name: str) -> None:
    """s and its three derivatives on every piece of the law, relative to their largest values."""
    law = LAWS[name]
    for piece, (low, high) in enumerate(zip(law.breaks, law.breaks[1:], strict=False)):
        k = np.linspace(low, high, 23)[1:-1]
        found = law.at(k, np.full(k.shape, piece))
        with mp.workdps(50):
            exact = [law_at(law, mpf(float(each)), piece) for each in k]
            for order in range(4):
                size = max(*(float(abs(row[order])) for row in exact), 1.0)
                missed = max(abs(mpf(float(a)) - row[order]) for a, row in zip(found[order], exact, strict=True))
                assert missed < CANCELS * size, (piece, order)
