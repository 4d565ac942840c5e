"""Counterweights on several links: closed conditions of the four-bar and the crank-slider, exactness, what is left."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable

import numpy as np
import pytest
from linkage.scenes import crank_slider, four_bar, slotted, yoke
from scipy.optimize import least_squares
from sparing import sparing
from transforms import moved, with_axes

from machine.balance.balanced import SCENES, TURN, Array, Scene, chain_of, scene
from tmmcalc import AssemblyError, NoSolutionError, UsageError
from tmmcalc.linkage.loading import Body
from tmmcalc.machine.balance.moments import sufficient_links
from tmmcalc.machine.balance.redistribution import Place, Redistribution, redistribute
from tmmcalc.machine.balance.shaking import inertia_loads

SPEED = 8.0
X = np.arange(48) * TURN / 48
L1, L2, L3, L0 = 0.1, 0.3, 0.25, 0.3 + 0.12j


def solved(case: Scene, *places: Place, speed: float = SPEED, acceleration: float = 0.0) -> Redistribution:
    return redistribute(case.chain, case.bodies, places, X, speed, acceleration)


def moment(body: Body, about: complex = 0j) -> complex:
    return body.mass * (body.center - about)


def centre_of_mass(case: Scene, bodies: tuple[Body, ...]) -> Array:
    """The common centre over a turn, from positions alone."""
    x = np.linspace(0, TURN, 721)
    motions = case.chain.evaluate(x, order=0).motions
    total = sum(b.mass * motions[b.link].point(b.center).r for b in bodies)
    return total / sum(b.mass for b in bodies)


def rests(case: Scene, result: Redistribution) -> bool:
    centre = centre_of_mass(case, (*case.bodies, *result.counterweights))
    return bool(np.max(np.abs(centre - centre[0])) < 1e-14)


@pytest.mark.parametrize("variant", [1, -1])
@pytest.mark.parametrize("speed", [SPEED, -SPEED])
@pytest.mark.parametrize("choice", [{"mass": 3.0}, {"radius": 0.07}])
def test_the_conditions_of_berkof_and_lowen(variant: int, speed: float, choice: dict[str, float]) -> None:
    """q_1 = -(m_1 s_1 + m_2 l_1 (1 - s_2 / l_2)), q_3 = -(m_3 s_3 + m_2 l_3 s_2 / l_2), s complex from the pins."""
    case = scene(four_bar(L1, L2, L3, L0, variant))
    b1, b2, b3 = case.bodies
    result = solved(case, Place(1, **choice), Place(3, **choice), speed=speed, acceleration=-5.0)
    w1, w3 = result.counterweights
    assert moment(w1) == pytest.approx(-(moment(b1) + b2.mass * L1 * (1 - b2.center / L2)), rel=1e-12)
    assert moment(w3) == pytest.approx(-(moment(b3) + b2.mass * L3 * b2.center / L2), rel=1e-12)
    assert result.exact
    assert rests(case, result)
    assert result.left < 1e-13
    assert result.after.size.largest < 1e-12 * result.before.scale
    assert result.sufficient == ((1, 2), (1, 3), (2, 3))
    for weight in (w1, w3):
        for name, value in choice.items():
            found = weight.mass if name == "mass" else abs(weight.center)
            assert found == pytest.approx(value, rel=1e-12)
    assert "links 1 and 3 keep the centre of mass at rest" in result.message
    assert result.added == w1.mass + w3.mass


@pytest.mark.parametrize("offset", [0.0, 0.04])
@pytest.mark.parametrize("radius", [0.05, 0.4])
def test_crank_and_rod_of_a_crank_slider(offset: float, radius: float) -> None:
    """The rod's weight brings rod and slider to the crank pin, the crank's brings all of it to the pivot."""
    l1, l2 = 0.1, 0.35
    case = scene(crank_slider(l1, l2, offset))
    b1, b2, b3 = case.bodies
    result = solved(case, Place(1, radius=0.08), Place(2, radius=radius))
    w1, w2 = result.counterweights
    at_rod = -(moment(b2) + b3.mass * l2)
    assert moment(w2) == pytest.approx(at_rod, rel=1e-12)
    assert w2.mass == pytest.approx(abs(at_rod) / radius, rel=1e-12)
    assert moment(w1) == pytest.approx(-(moment(b1) + (b2.mass + b3.mass + w2.mass) * l1), rel=1e-12)
    assert result.exact
    assert rests(case, result)
    assert result.sufficient == ((1, 2),)


def test_the_crank_alone_is_the_counterweight_of_least_squares() -> None:
    case = scene(crank_slider(0.1, 0.35))
    result = solved(case, Place(1, mass=2.0), acceleration=3.0)
    c1 = result.before.series.coefficient(1)
    assert moment(result.counterweights[0]) == pytest.approx(-c1 / (SPEED**2 - 3.0j), rel=1e-12)
    assert not result.exact
    assert result.after.size.rms == pytest.approx(math.sqrt(result.before.size.rms**2 - abs(c1) ** 2), rel=1e-12)
    assert "link 1 do not balance" in result.message
    assert "links 1 and 2 would" in result.message


@sparing("name", ["four-bar", "shaper", "slotted", "rotating slot", "v-engine"], every=5)
@pytest.mark.parametrize("links", [(1,), (2,), (1, 2), (3,), (1, 3)])
def test_what_is_left_is_the_least(name: str, links: tuple[int, ...]) -> None:
    """The static moments of chosen masses against scipy on the mean square of the force itself."""
    case = SCENES[name]()
    known = {link.id for link in case.mechanism.links}
    places = [Place(k, mass=1.5) for k in links if k in known]
    x = np.arange(256) * TURN / 256
    result = redistribute(case.chain, case.bodies, places, x, SPEED, 20.0)
    pins = [w.center - moment(w) / w.mass for w in result.counterweights]
    motions = case.chain.evaluate(x).motions
    given, _ = inertia_loads(case.chain, case.bodies, x, SPEED, 20.0)

    def left(q: Array) -> Array:
        force = given.copy()
        for j, w in enumerate(result.counterweights):
            place = motions[w.link].point(pins[j] + complex(q[2 * j], q[2 * j + 1]) / w.mass)
            force -= w.mass * (place.a * SPEED**2 + place.v * 20.0)
        return np.concatenate((force.real, force.imag)) / result.before.scale

    other = least_squares(left, np.zeros(2 * len(places)), xtol=1e-15, ftol=1e-15, gtol=1e-15)
    rms = math.sqrt(2 * other.cost / 256) * result.before.scale
    assert result.after.size.rms <= rms * (1 + 1e-9) + 1e-12 * result.before.scale
    assert result.after.size.rms == pytest.approx(rms, rel=1e-6, abs=1e-7 * result.before.scale)
    assert result.exact == (result.after.size.rms < 1e-9 * result.before.scale)


@sparing("make", SCENES.values(), ids=SCENES, every=4)
def test_the_sets_that_suffice_do_and_smaller_ones_do_not(make: Callable[[], Scene]) -> None:
    case = make()
    sets = sufficient_links(case.chain, case.bodies)
    for some in sets[:4]:
        result = solved(case, *(Place(k, mass=2.0) for k in some))
        assert result.exact
        assert rests(case, result)
        assert result.after.size.largest < 1e-11 * result.after.scale
        for k in some:
            less = solved(case, *(Place(j, mass=2.0) for j in some if j != k))
            assert not less.exact
    turning = [b.link for b in case.bodies]
    everything = solved(case, *(Place(k, mass=2.0) for k in turning))
    assert everything.exact == bool(sets)


def test_links_that_cannot_be_balanced_by_weights_on_links() -> None:
    case = scene(yoke(0.1), Body(1, 1.0, 0.0, 0.05 + 0j), Body(3, 4.0, 0.0, 0j))
    assert sufficient_links(case.chain, case.bodies) == ()
    result = solved(case, Place(1, mass=2.0), Place(2, mass=1.0), Place(3, mass=0.5))
    assert not result.exact
    assert "no counterweights on links can" in result.message
    assert moment(result.counterweights[1]) == moment(result.counterweights[2]) == 0  # links that do not turn
    without = solved(case, Place(1, mass=2.0))
    assert without.after.size.rms == pytest.approx(without.before.size.rms / math.hypot(1 + 2 * 0.05 / 0.4, 1), rel=0.2)


def test_a_balanced_mechanism_needs_nothing() -> None:
    case = scene(four_bar(L1, L2, L3, L0), Body(1, 2.0, 0.1, 0j), Body(3, 2.0, 0.1, 0j))
    assert sufficient_links(case.chain, case.bodies) == ((),)
    result = solved(case, Place(1, radius=0.1), Place(3, radius=0.1))
    assert result.exact
    assert result.added < 1e-12


@pytest.mark.parametrize("radius", [0.35, 0.6])
def test_radii_where_the_weights_own_mass_counts(radius: float) -> None:
    """Coupler and rocker alone: the weight on the coupler rides on the crank pin and has to balance that as well."""
    case = scene(four_bar(L1, L2, L3, L0))
    result = solved(case, Place(2, radius=radius), Place(3, radius=0.2))
    w2, w3 = result.counterweights
    assert result.exact
    assert rests(case, result)
    assert abs(w2.center) == pytest.approx(radius, rel=1e-12)
    assert abs(w3.center) == pytest.approx(0.2, rel=1e-12)
    assert min(w2.mass, w3.mass) > 0


def test_radii_that_no_masses_go_with() -> None:
    """All that the crank carries has to be lifted by the coupler's weight beyond B, which a short arm cannot."""
    case = scene(four_bar(L1, L2, L3, L0), Body(1, 1.0, 0.0, -0.05 + 0j), Body(2, 1.0, 0.0, 1.5 * L2 + 0j))
    fits = solved(case, Place(2, radius=0.3), Place(3, radius=0.3))
    assert fits.exact
    case = scene(four_bar(L1, L2, L3, L0), Body(1, 1.0, 0.0, 0.05 + 0j), Body(2, 1.0, 0.0, 0.3 * L2 + 0j))
    with pytest.raises(NoSolutionError, match=r"links 2 at 0\.2 m, 3 at 0\.2 m"):
        solved(case, Place(2, radius=0.2), Place(3, radius=0.2))


def test_more_links_than_needed_take_the_least_weights() -> None:
    case = scene(four_bar(L1, L2, L3, L0))
    three = solved(case, *(Place(k, mass=2.0) for k in (1, 2, 3)))
    assert three.exact
    assert rests(case, three)
    two = solved(case, Place(1, mass=2.0), Place(3, mass=2.0))

    def forces(result: Redistribution) -> float:
        units = {1: 1.0, 2: 0.0, 3: 0.0}
        motions = case.chain.evaluate(np.arange(256) * TURN / 256).motions
        units |= {k: math.sqrt(np.mean(np.abs(motions[k].u2) ** 2)) for k in (2, 3)}
        return math.sqrt(sum((units[w.link] * abs(moment(w))) ** 2 for w in result.counterweights))

    assert forces(three) < forces(two) * 1.001 + 2.0 * L1


def test_a_point_of_the_link_to_count_from() -> None:
    case = scene(four_bar(L1, L2, L3, L0))
    result = solved(case, Place(1, radius=0.05), Place(2, radius=0.4, about=L2 + 0j))
    assert abs(result.counterweights[1].center - L2) == pytest.approx(0.4, rel=1e-12)
    assert result.exact
    assert rests(case, result)


def test_turned_axes_and_a_moved_mechanism_give_the_same_weights() -> None:
    plain = scene(slotted(0.1, 0.3, 0.02))
    turn, origin = 0.9, 0.04 - 0.03j
    laid = with_axes(moved(plain.mechanism, 0.5, 30.0 - 20.0j), 3, origin, turn)
    bodies = tuple(
        Body(b.link, b.mass, b.inertia, complex((b.center - origin) * cmath.exp(-1j * turn))) if b.link == 3 else b
        for b in plain.bodies
    )
    one = solved(plain, Place(1, radius=0.1), Place(3, mass=4.0))
    other = redistribute(chain_of(laid), bodies, [Place(1, radius=0.1), Place(3, mass=4.0)], X, SPEED)
    a1, a3 = one.counterweights
    b1, b3 = other.counterweights
    assert b1.center == pytest.approx(a1.center, rel=1e-10)
    assert b1.mass == pytest.approx(a1.mass, rel=1e-10)
    assert b3.center * cmath.exp(1j * turn) + origin == pytest.approx(a3.center, rel=1e-10)
    assert other.exact
    assert one.exact


def test_faulty_places_are_refused() -> None:
    case = scene(four_bar(L1, L2, L3, L0))
    with pytest.raises(UsageError, match="no such link"):
        solved(case, Place(7, mass=1.0))
    with pytest.raises(UsageError, match="no such link"):
        solved(case, Place(0, mass=1.0))
    with pytest.raises(UsageError, match="already"):
        solved(case, Place(1, mass=1.0), Place(1, radius=0.1))
    with pytest.raises(UsageError, match="counterweight on link 3: choose the mass or the radius"):
        solved(case, Place(3))
    with pytest.raises(UsageError, match="not positive"):
        solved(case, Place(3, radius=-1.0))
    with pytest.raises(AssemblyError, match="full turn"):
        redistribute(chain_of(crank_slider(0.1, 0.09)), case.bodies, [Place(1, mass=1.0)], X, SPEED)
