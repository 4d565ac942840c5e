"""Engines: one cylinder against its linkage, harmonics against closed series, known properties of arrangements."""

from __future__ import annotations

import cmath
import math
from typing import Any

import mpmath
import numpy as np
import pytest
from linkage.scenes import crank_slider
from numpy.typing import NDArray
from sparing import sparing

from machine.balance.balanced import chain_of
from tmmcalc import UsageError
from tmmcalc.linkage.loading import Body
from tmmcalc.machine.balance.arrangements import FIRING, Gear, in_line, vee
from tmmcalc.machine.balance.cylinders import Cylinder, cylinder_force, piston
from tmmcalc.machine.balance.engines import EngineBalance, corrected, engine_balance, shaft_weights
from tmmcalc.machine.balance.shaking import inertia_loads, shaking

Array = NDArray[Any]
TURN = 2 * math.pi
SPEED = 300.0
RADIUS, ROD, M_REC, M_ROT = 0.04, 0.14, 0.5, 0.6
GEAR = Gear(RADIUS, ROD, M_REC, M_ROT)
LAMBDA = RADIUS / ROD
W2 = SPEED**2
PHI = np.arange(720) * TURN / 720
SPACING = 0.1


def secondary(ratio: float) -> float:
    """A_2 of the piston's acceleration -r w^2 (cos a + A_2 cos 2a + ...), by its power series."""
    return ratio + ratio**3 / 4 + 15 * ratio**5 / 128 + 35 * ratio**7 / 512 + 2205 * ratio**9 / 49152


@pytest.mark.parametrize("offset", [0.0, 0.03, -0.05])
def test_the_piston_and_its_derivatives(offset: float) -> None:
    """Against differentiation in 40 digits."""
    mpmath.mp.dps = 40
    r, l, e = mpmath.mpf(RADIUS), mpmath.mpf(ROD), mpmath.mpf(offset)
    alpha = np.linspace(-3, 3, 13)
    found = piston(alpha, RADIUS, ROD, offset)
    for order in (0, 1, 2):
        exact = [
            float(mpmath.diff(lambda a: r * mpmath.cos(a) + mpmath.sqrt(l**2 - (r * mpmath.sin(a) - e) ** 2), a, order))
            for a in alpha
        ]
        np.testing.assert_allclose(found[order], exact, rtol=1e-13, atol=1e-16)


@pytest.mark.parametrize("speed", [SPEED, -SPEED])
@pytest.mark.parametrize("offset", [0.0, 0.03])
@pytest.mark.parametrize("axis", [0.0, 1.1])
def test_one_cylinder_shakes_like_its_linkage(speed: float, offset: float, axis: float) -> None:
    """The crank-slider of the linkage room with the rod as a body, its guide turned onto the cylinder's axis."""
    rod_mass, rod_center, piston_mass = 0.8, 0.05, 0.4
    at_piston = rod_mass * rod_center / ROD
    at_crank = rod_mass - at_piston
    cylinder = Cylinder(axis, axis + 0.7, 0.0, RADIUS, ROD, piston_mass + at_piston, at_crank, offset)
    bodies = (Body(2, rod_mass, 0.01, complex(rod_center)), Body(3, piston_mass, 0.0, 0j))
    chain = chain_of(crank_slider(RADIUS, ROD, offset))
    force, _ = inertia_loads(chain, bodies, PHI + 0.7, speed)
    found = cylinder_force(cylinder, PHI, speed)
    assert np.max(np.abs(found - force * cmath.exp(1j * axis))) < 1e-12 * np.max(np.abs(force))
    balance = engine_balance([cylinder], speed)
    reference = shaking(chain, bodies, PHI, speed)
    assert balance.force_size.rms == pytest.approx(reference.size.rms, rel=1e-12)
    assert balance.force_size.largest == pytest.approx(reference.size.largest, rel=1e-12)
    assert balance.error < 1e-13


@pytest.mark.parametrize("ratio", [0.02, 0.1, 0.15])
def test_amplitudes_of_one_cylinder(ratio: float) -> None:
    """Primary: m r w^2 in both senses, the rotating mass with the shaft; secondary by the series of A_2."""
    gear = Gear(RADIUS, RADIUS / ratio, M_REC, M_ROT)
    (one,) = in_line(1, SPACING, gear)
    first, second, fourth, third = engine_balance([one], SPEED, orders=(1, 2, 4, 3)).orders
    unit = M_REC * RADIUS * W2
    assert first.force[0] == pytest.approx((unit / 2 + M_ROT * RADIUS * W2) * 1j, rel=1e-13)
    assert first.force[1] == pytest.approx(unit / 2 * 1j, rel=1e-13)  # the axis points along +y at top dead centre
    assert second.largest_force == pytest.approx(unit * secondary(ratio), rel=5e-9)
    assert second.force[0] == pytest.approx(second.force[1], rel=1e-12)
    a4 = -(ratio**3 / 4 + 3 * ratio**5 / 16 + 35 * ratio**7 / 256)
    assert 2 * fourth.force[0].imag == pytest.approx(unit * a4, rel=1e-5)
    assert third.forces_balanced
    assert third.largest_force < 1e-12 * unit
    assert not second.forces_balanced


ARRANGEMENTS = {
    **{f"in line {n}": in_line(n, SPACING, GEAR) for n in FIRING},
    "in line 2, throws apart": in_line(2, SPACING, GEAR, throws=[0.0, math.pi]),
    "in line 4, two-stroke": in_line(4, SPACING, GEAR, strokes=2),
    "V2 90": vee(2, math.pi / 2, SPACING, GEAR),
    "V4 180": vee(4, math.pi, SPACING, GEAR),
    "V6 60 split": vee(6, math.pi / 3, SPACING, GEAR, split=math.pi / 3),
    "V6 90": vee(6, math.pi / 2, SPACING, GEAR),
    "V8 crossed": vee(8, math.pi / 2, SPACING, GEAR),
    "V8 flat": vee(8, math.pi / 2, SPACING, GEAR, throws=[0.0, math.pi, math.pi, 0.0]),
    "V10 72": vee(10, math.radians(72), SPACING, GEAR),
    "V12 60": vee(12, math.pi / 3, SPACING, GEAR),
    "boxer 2": vee(2, math.pi, SPACING, GEAR, split=math.pi, stagger=0.03),
    "boxer 4": vee(4, math.pi, SPACING, GEAR, split=math.pi, throws=[0.0, math.pi], stagger=0.03),
    "boxer 6": vee(6, math.pi, SPACING, GEAR, split=math.pi, stagger=0.03),
    "star 5": [Cylinder(k * TURN / 5, 0.0, 0.0, RADIUS, ROD, M_REC, M_ROT / 5) for k in range(5)],
    "skewed": [
        Cylinder(0.3 * k, 1.7 * k * k, 0.05 * k + 0.3, RADIUS, ROD + 0.01 * k, M_REC + 0.1 * k, M_ROT, 0.01 * k)
        for k in range(4)
    ],
}
every = pytest.mark.parametrize("cylinders", ARRANGEMENTS.values(), ids=ARRANGEMENTS)


def engine_forces(cylinders: list[Cylinder], reference: float | None = None) -> tuple[np.ndarray, np.ndarray]:
    """Shaking force and couple at `PHI`, cylinder by cylinder; the plane of the couples is the middle of the engine."""
    places = np.array([c.position_along_shaft for c in cylinders])
    middle = (places.min() + places.max()) / 2 if reference is None else reference
    forces = np.array([cylinder_force(c, PHI, SPEED) for c in cylinders])
    return forces.sum(axis=0), (places - middle) @ forces


@every
def test_orders_are_the_transform_of_the_exact_forces(cylinders: list[Cylinder]) -> None:
    balance = engine_balance(cylinders, SPEED, orders=range(1, 9))
    force, couple = engine_forces(cylinders)
    own = np.array([cylinder_force(c, PHI, SPEED) for c in cylinders])
    whole = np.abs(own).sum(axis=0).max()
    for order in balance.orders:
        for found, values in ((order.force, force), (order.couple, couple)):
            spectrum = np.fft.fft(values) / len(PHI)
            assert abs(found[0] - spectrum[order.order]) < 1e-14 * whole
            assert abs(found[1] - spectrum[-order.order]) < 1e-14 * whole
        spectra = np.abs(np.fft.fft(own) / len(PHI))
        alone = (spectra[:, order.order] + spectra[:, -order.order]).sum()
        assert order.force_alone == pytest.approx(alone, rel=1e-9, abs=1e-13 * whole)
        assert order.largest_force <= order.force_alone + 1e-13 * whole
    for size, values in ((balance.force_size, force), (balance.couple_size, couple)):
        largest = np.abs(values).max()
        assert size.rms == pytest.approx(np.sqrt(np.mean(np.abs(values) ** 2)), rel=1e-9, abs=1e-13 * whole)
        assert largest - 1e-13 * whole <= size.largest <= largest * (1 + 1e-3) + 1e-13 * whole


def table(balance: EngineBalance) -> dict[int, str]:
    """By order: F if a force is left, C if a couple is."""
    return {o.order: ("" if o.forces_balanced else "F") + ("" if o.couples_balanced else "C") for o in balance.orders}


@pytest.mark.parametrize(
    ("name", "left"),
    [
        ("in line 1", {1: "F", 2: "F", 4: "F", 6: "F"}),
        ("in line 2", {1: "F", 2: "F", 4: "F", 6: "F"}),
        ("in line 2, throws apart", {1: "C", 2: "F", 4: "F", 6: "F"}),
        ("in line 3", {1: "C", 2: "C", 4: "C", 6: "F"}),
        ("in line 4", {1: "", 2: "F", 4: "F", 6: "F"}),
        ("in line 4, two-stroke", {1: "C", 2: "", 4: "F", 6: ""}),
        ("in line 5", {1: "C", 2: "C", 4: "C", 6: "C"}),
        ("in line 6", {1: "", 2: "", 4: "", 6: "F"}),
        ("in line 8", {1: "", 2: "", 4: "F", 6: ""}),
        ("V4 180", {1: "C", 2: "", 4: "", 6: ""}),
        ("V6 60 split", {1: "C", 2: "C", 4: "C", 6: "F"}),
        ("V8 crossed", {1: "C", 2: "", 4: "F", 6: ""}),
        ("V8 flat", {1: "", 2: "F", 4: "F", 6: "F"}),
        ("V12 60", {1: "", 2: "", 4: "", 6: "F"}),
        ("boxer 2", {1: "C", 2: "C", 4: "C", 6: "C"}),
        ("boxer 4", {1: "", 2: "C", 4: "C", 6: "C"}),
        ("boxer 6", {1: "", 2: "", 4: "", 6: "C"}),
    ],
)
def test_what_arrangements_are_known_for(name: str, left: dict[int, str]) -> None:
    found = table(engine_balance(ARRANGEMENTS[name], SPEED))
    assert found == left


def test_amounts_of_known_arrangements() -> None:
    unit, turning = M_REC * RADIUS * W2, M_ROT * RADIUS * W2
    exact = engine_balance(in_line(1, SPACING, GEAR), SPEED).orders[1].largest_force
    four = engine_balance(ARRANGEMENTS["in line 4"], SPEED).orders[1]
    assert four.largest_force == pytest.approx(4 * exact, rel=1e-12)
    vee90 = engine_balance(ARRANGEMENTS["V2 90"], SPEED).orders
    assert abs(vee90[0].force[0]) == pytest.approx(unit + 2 * turning, rel=1e-12)
    assert abs(vee90[0].force[1]) < 1e-12 * unit  # a purely turning force: one counterweight takes it away
    assert vee90[1].largest_force == pytest.approx(math.sqrt(2) * exact, rel=1e-12)
    star = engine_balance(ARRANGEMENTS["star 5"], SPEED).orders[0]
    assert abs(star.force[0]) == pytest.approx(5 / 2 * unit + turning, rel=1e-12)
    assert abs(star.force[1]) < 1e-12 * unit
    three = engine_balance(ARRANGEMENTS["in line 3"], SPEED).orders
    assert abs(three[0].couple[0]) == pytest.approx(math.sqrt(3) * SPACING * (unit / 2 + turning), rel=1e-12)
    assert three[1].largest_couple == pytest.approx(math.sqrt(3) * SPACING * exact, rel=1e-12)
    crossed = engine_balance(ARRANGEMENTS["V8 crossed"], SPEED).orders[0]
    assert abs(crossed.couple[0]) == pytest.approx(math.sqrt(10) * SPACING * (unit + 2 * turning), rel=1e-12)
    assert abs(crossed.couple[1]) < 1e-12 * unit * SPACING
    flat = engine_balance(ARRANGEMENTS["V8 flat"], SPEED).orders[1]
    assert flat.largest_force == pytest.approx(4 * math.sqrt(2) * exact, rel=1e-12)


@every
@sparing("orders", [(1,), (1, -1), (1, -1, 2, -2)], every=3, first=1)
def test_shaft_weights_take_their_parts_away(cylinders: list[Cylinder], orders: tuple[int, ...]) -> None:
    """The weights as masses that turn in their planes, added to the exact forces."""
    balance = engine_balance(cylinders, SPEED)
    shafts = [shaft_weights(balance, k, (-0.05, 0.4 + 0.01 * k)) for k in orders]
    after = corrected(balance, shafts)
    force, couple = engine_forces(cylinders)
    whole = np.abs(np.array([cylinder_force(c, PHI, SPEED) for c in cylinders])).sum(axis=0).max()
    for shaft in shafts:
        for z, moment in zip(shaft.planes, shaft.moments, strict=True):
            own = (shaft.order * SPEED) ** 2 * moment * np.exp(1j * shaft.order * PHI)
            force, couple = force + own, couple + (z - balance.reference) * own
    for values, series in ((force, after.force), (couple, after.couple)):
        assert np.max(np.abs(series.at(PHI) - values)) < 1e-12 * whole
        spectrum = np.fft.fft(values) / len(PHI)
        assert max(abs(spectrum[k]) for k in orders) < 1e-13 * whole
    for order in after.orders:
        if order.order in orders and -order.order in orders:
            assert order.forces_balanced
            assert order.couples_balanced
    assert after.force_size.rms <= balance.force_size.rms * (1 + 1e-12)
    assert after.weights == tuple(shafts)


def test_the_half_of_the_reciprocating_mass_and_lanchester_shafts() -> None:
    one = engine_balance(in_line(1, SPACING, GEAR), SPEED)
    weights = shaft_weights(one, 1, (-0.05, 0.05)).moments
    assert sum(weights) == pytest.approx(-1j * RADIUS * (M_ROT + M_REC / 2), rel=1e-13)
    assert weights[0] == pytest.approx(weights[1], rel=1e-12)
    four = engine_balance(ARRANGEMENTS["in line 4"], SPEED)
    after = corrected(four, [shaft_weights(four, k, (0.0, 0.3)) for k in (2, -2)])
    assert after.force_size.rms == pytest.approx(
        math.sqrt(four.force_size.rms**2 - four.orders[1].largest_force ** 2 / 2), rel=1e-9
    )
    moment = sum(shaft_weights(four, 2, (0.0, 0.3)).moments)
    assert moment == pytest.approx(-1j * M_REC * RADIUS * secondary(LAMBDA) / 2, rel=1e-4)


def test_couples_follow_their_plane() -> None:
    cylinders = ARRANGEMENTS["skewed"]
    force, couple = engine_forces(cylinders)
    _, other = engine_forces(cylinders, reference=1.5)
    places = [c.position_along_shaft for c in cylinders]
    assert np.max(np.abs(couple - other - (1.5 - (min(places) + max(places)) / 2) * force)) < 1e-9
    shifted = engine_balance(cylinders, SPEED, reference=1.5)
    assert np.max(np.abs(shifted.couple.at(PHI) - other)) < 1e-12 * np.max(np.abs(other))
    here = engine_balance(cylinders, SPEED)
    ours, theirs = shaft_weights(here, 1, (0.0, 0.4)), shaft_weights(shifted, 1, (0.0, 0.4))
    assert ours.moments == pytest.approx(theirs.moments, rel=1e-11)  # the weights do not depend on it


def test_the_sense_and_the_speed() -> None:
    cylinders = ARRANGEMENTS["skewed"]
    one, back = engine_balance(cylinders, SPEED), engine_balance(cylinders, -3 * SPEED)
    assert back.force_size.largest == pytest.approx(9 * one.force_size.largest, rel=1e-12)
    np.testing.assert_allclose(
        shaft_weights(back, -1, (0, 1)).moments, shaft_weights(one, -1, (0, 1)).moments, rtol=1e-11
    )


def test_faulty_engines_are_refused() -> None:
    with pytest.raises(UsageError, match="no cylinders"):
        engine_balance([], SPEED)
    with pytest.raises(UsageError, match="not longer"):
        Cylinder(0, 0, 0, 0.1, 0.12, 1.0, offset=0.03)
    with pytest.raises(UsageError, match="crank radius 0 m"):
        Cylinder(0, 0, 0, 0.0, 0.12, 1.0)
    with pytest.raises(UsageError, match="-1 kg is negative"):
        Cylinder(0, 0, 0, 0.1, 0.3, -1.0)
    with pytest.raises(UsageError, match="no order 0"):
        engine_balance(ARRANGEMENTS["in line 1"], SPEED, orders=(0,))
    balance = engine_balance(ARRANGEMENTS["in line 1"], SPEED)
    with pytest.raises(UsageError, match="both planes lie at 1 m"):
        shaft_weights(balance, 1, (1.0, 1.0))
    with pytest.raises(UsageError, match="stands still"):
        shaft_weights(balance, 0, (0.0, 1.0))
