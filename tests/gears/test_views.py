"""What a page shows moving of gears: flanks that touch where it says, true ratios, planets in mesh."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tmmcalc.gears.meshing.halftooth import half_tooth
from tmmcalc.gears.meshing.members import both
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.gears.views.pair import Rolling
from tmmcalc.report.moving import Body, Track, View

PAIRS = {
    "external": PairTask((14, 27), 0.005, strategy="given", shifts=(0.5, 0.4)),
    "unshifted": PairTask((20, 40), 0.002, strategy="given", shifts=(0.0, 0.0)),
    "helical": PairTask((17, 31), 0.003, helix=math.radians(15), strategy="given", shifts=(0.3, 0.2)),
    "internal": PairTask((18, 57), 0.004, kind="internal", strategy="given", shifts=(0.2, 0.3)),
    "rack": PairTask((16, 0), 0.006, kind="rack", strategy="given", shifts=(0.3, 0.0)),
}


def value(track: Track, view: View, at: float) -> float:
    """A track that two places tell, there."""
    start, end = view.values
    assert len(view.values) == 2
    rate = (track.values[1] - track.values[0]) / (end - start)
    assert track.rates == pytest.approx(rate)
    return float(track.values[0] + rate * (at - start))


def pose(view: View, name: str, at: float) -> tuple[complex, complex]:
    """The origin of a body, and the direction of its axes; those that others bear go with them."""
    body = body_of(view, name)
    origin, turn = complex(value(body.x, view, at), value(body.y, view, at)), value(body.angle, view, at)
    axes = complex(math.cos(turn), math.sin(turn))
    if not body.on:
        return origin, axes
    there, around = pose(view, body.on, at)
    return there + around * origin, around * axes


def body_of(view: View, name: str) -> Body:
    return next(body for body in view.bodies if body.name == name)


@pytest.fixture(params=PAIRS)
def rolling(request: pytest.FixtureRequest) -> Rolling:
    return Rolling(solve_pair(PAIRS[request.param]))


def test_contact_points_lie_on_both_flanks(rolling: Rolling) -> None:
    """To a millionth of the module: on the polynomial through the points of a flank, whose course is smooth."""
    view, module = rolling.view("pair"), rolling.found.task.module
    seen = 0
    for j, (start, end) in rolling.contacts():
        for angle in np.linspace(start, end, 7):
            at = math.degrees(angle)
            contact, _ = pose(view, f"K{j}", at)
            assert contact == pytest.approx(rolling.contact(j, angle), abs=1e-9 * module)
            for name in "12":
                origin, axes = pose(view, name, at)
                flanks = [np.array(mark.points) for mark in body_of(view, name).marks if mark.kind == "flank"]
                own = (contact - origin) / axes
                assert min(distance(own, flank) for flank in flanks) < 1e-6 * module
                seen += 1
    assert seen >= 28


def distance(at: complex, flank: np.ndarray) -> float:
    """From a smooth curve through points, by Newton on the polynomial of all of them."""
    centre, size = flank.mean(), float(np.abs(flank - flank.mean()).max())
    if abs(at - centre) > 3 * size:
        return math.inf
    t = np.linspace(-1, 1, len(flank))
    curve = np.polynomial.Chebyshev.fit(t, (flank - centre) / size, len(flank) - 1)
    first, want = curve.deriv(), (at - centre) / size
    best = float(t[np.argmin(np.abs(flank - at))])
    for _ in range(20):
        best -= float(((curve(best) - want) * np.conj(first(best))).real / abs(first(best)) ** 2)
        best = min(max(best, -1.0), 1.0)
    return float(abs(curve(best) - want)) * size


def test_the_line_of_action_bears_the_contacts(rolling: Rolling) -> None:
    line = next(mark for mark in body_of(rolling.view("pair"), "action").marks if mark.kind == "bar").points
    along = (line[1] - line[0]) / abs(line[1] - line[0])
    for j, (start, end) in rolling.contacts():
        for angle in (start, end):
            away = (rolling.contact(j, angle) - line[0]) / along
            assert abs(away.imag) < 1e-9 * rolling.found.task.module
            assert -1e-9 < away.real / abs(line[1] - line[0]) < 1 + 1e-9


def test_the_end_is_like_the_beginning(rolling: Rolling) -> None:
    """A pitch further every tooth stands where its neighbour stood; contacts are there for the contact ratio."""
    view = rolling.view("pair")
    end = float(view.values[-1])
    assert end == pytest.approx(360 / rolling.found.task.teeth[0])
    for name in "12":
        (first, axes), (last, turned) = pose(view, name, 0.0), pose(view, name, end)
        flanks = [np.array(mark.points) for mark in body_of(view, name).marks if mark.kind == "flank"]
        middles = np.array([flank[len(flank) // 2] for flank in flanks])
        before, after = first + middles * axes, last + middles * turned
        near = [float(np.abs(after - place).min()) for place in before[1:-1]]
        assert max(near) < 1e-9 * rolling.found.task.module
    parts = sum(to - start for _, (start, to) in rolling.contacts())
    assert parts / rolling.turn == pytest.approx(rolling.found.shortened)


def test_the_ratio_is_true(rolling: Rolling) -> None:
    view, (first, second) = rolling.view("pair"), rolling.found.task.teeth
    end = float(view.values[-1])
    mate = body_of(view, "2")
    if rolling.found.task.kind == "rack":
        pitch = rolling.found.task.transverse_pitch
        assert value(mate.x, view, 0.0) - value(mate.x, view, end) == pytest.approx(pitch)
        return
    sense = 1 if rolling.found.task.kind == "internal" else -1
    assert value(mate.angle, view, end) == pytest.approx(sense * first / second * math.radians(end))


def test_sliding_is_that_of_the_specific_one(rolling: Rolling) -> None:
    """theta_1 = v_s/v_t1, with v_t1 = omega_1 rho_1 along the flank of wheel 1."""
    table = rolling.found.sliding
    for rho, theta in zip(table.rho1[table.active], table.theta1[table.active], strict=True):
        at = complex(rolling.pair.on_line(rho))
        along = rho / rolling.pair.pitch_point.imag
        assert abs(rolling.sliding(at)) / along == pytest.approx(abs(theta), abs=1e-9)


def test_working_flanks_are_those_of_the_theory(rolling: Rolling) -> None:
    """The ends of the drawn flanks are where the contact begins and ends."""
    found = rolling.found
    base = found.sizes[0].base
    flank = np.array(next(m for m in body_of(rolling.view("pair"), "1").marks if m.kind == "flank").points)
    rho = np.sqrt(np.abs(flank) ** 2 - base**2)
    assert sorted((rho[0], rho[-1])) == pytest.approx([found.line.begins, found.line.ends], rel=1e-9)
    assert half_tooth(both(found)[0]).base * found.task.module == pytest.approx(base)
