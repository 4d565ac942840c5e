"""How what is given acts otherwise when inputs change: weights, loads of inertia, springs, technological loads.

Everything is told as the force and the moment about one fixed point on every link, and their changes. Loads that are
constant or go against a velocity, springs and inertia are differentiated by hand; a law of the position (a polynomial,
a table) is an explicit formula of the place, which is differentiated along the direction by a central difference of
the fourth order of that formula alone: its error is about 1e-12 of the largest value for smooth laws. Beside a corner
of a table that is nearer than the step the slope is that of both sides together.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.numerics.alike import groups, numbers, rebuilt
from tmmcalc.core.plane import LinkMotion, Plane, Real, cross
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.derivatives.closure import Moved, Slopes
from tmmcalc.linkage.loading import Body, Load, Loading, Spring
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loadlaws.indicator import Indicator
from tmmcalc.linkage.loadlaws.placed import Placed
from tmmcalc.linkage.loadlaws.quadratic import Quadratic
from tmmcalc.linkage.loadlaws.tabulated import Tabulated
from tmmcalc.linkage.loadlaws.viscous import Viscous
from tmmcalc.linkage.loads.scene import Scene
from tmmcalc.linkage.loads.sources import Place
from tmmcalc.linkage.loads.travel import EDGE, travel_of
from tmmcalc.linkage.loads.values import Acting
from tmmcalc.linkage.loads.windows import handed_over, window_of
from tmmcalc.linkage.model import FRAME
from tmmcalc.linkage.results import Kinematics

STEP = 1e-3  # of the difference of a law, against what changes
STENCIL = ((-2.0, 1 / 12), (-1.0, -2 / 3), (1.0, 2 / 3), (2.0, -1 / 12))


class Acted(NamedTuple):
    """Forces (n,) on a link with moments about the pole, and their changes (K, n)."""

    link: int
    force: Plane
    moment: Real
    dforce: Plane
    dmoment: Real


class Given(NamedTuple):
    """Where loads are differentiated: the scene, the place, the whole motion with its changes.

    ``changes`` of the loading, ``dtheta`` (K, n) of the angle along the motion; ``stepped(k, h)`` is the kinematics a
    step h along direction k, as far as laws of the position read it: its rows, dead centres and summaries.
    """

    scene: Scene
    place: Place
    moved: Moved
    changes: Any
    dtheta: Real
    slopes: Slopes  # (K, L) of mechanism and loading
    kinematics: Kinematics
    stepped: Callable[[int, float], Kinematics]
    pole: complex

    def at(self, link: int, r: Plane, dr: Plane, force: Plane, dforce: Plane) -> Acted:
        """A force at a point (n,) of a link."""
        arm = r - self.pole
        return Acted(link, force, cross(arm, force), dforce, cross(dr, force) + cross(arm, dforce))

    def couple(self, link: int, moment: Real, dmoment: Real) -> Acted:
        """A couple on a link."""
        return Acted(link, np.zeros(()) + 0j, moment, np.zeros(()) + 0j, dmoment)


def exact(scene: Scene) -> bool:
    """Whether all loads are given exactly.

    An indicator diagram, whose strokes depend on the way of a point of its own, is not; nor is a table of the
    displacement in a motion that is no cycle; nor a law of another kind.
    """
    return all(_is_exact(load, whole=scene.travel.whole) for load in scene.loading.loads if load.factor)


def _is_exact(load: Load, *, whole: bool) -> bool:
    if isinstance(load.law, Constant):
        return load.law.value != 0
    if isinstance(load.law, Tabulated):
        return whole or load.law.of in ("angle", "position")
    return isinstance(load.law, Viscous | Quadratic | Placed) and not isinstance(load.law, Indicator)


def given_loads(given: Given) -> list[Acted]:
    """Everything that is given."""
    loading, changes = given.scene.loading, given.changes
    found: list[Acted] = []
    for body, change in zip(loading.bodies, changes.bodies, strict=True):
        found += _body(given, body, change)
    for number, (load, change) in enumerate(zip(loading.loads, changes.loads, strict=True)):
        if load.factor:
            found += _load(given, load, change, number)
    for number, (spring, change) in enumerate(zip(loading.springs, changes.springs, strict=True)):
        found += _spring(given, spring, change, number)
    return found


def _body(given: Given, body: Body, change: Any) -> list[Acted]:
    """Weight and inertia m (g - a_S), -J_S eps of a body."""
    moved, drive = given.moved, given.moved.changes.input
    w, eps = given.scene.travel.speed, given.scene.travel.acceleration
    (r, v, a), (dr, dv, da) = (jet for jet in moved.point(body.link, body.center, change.center))
    u, turning = moved.bodies[body.link].u, moved.links[body.link].angle
    rate, rate2 = (u[1] / u[0]).imag, (u[2] / u[0]).imag
    acceleration = a * w**2 + v * eps
    dacceleration = da * w**2 + 2 * w * drive.speed * a + dv * eps + v * drive.acceleration
    angular = rate2 * w**2 + rate * eps
    dangular = turning[2] * w**2 + 2 * w * drive.speed * rate2 + turning[1] * eps + rate * drive.acceleration
    gravity, dgravity = given.scene.loading.gravity, given.changes.gravity
    force = body.mass * (gravity - acceleration)
    dforce = change.mass * (gravity - acceleration) + body.mass * (dgravity - dacceleration)
    couple = given.couple(body.link, -body.inertia * angular[0], -change.inertia * angular - body.inertia * dangular)
    return [given.at(body.link, r[0], dr, force[0], dforce), couple]


def _load(given: Given, load: Load, change: Any, number: int) -> list[Acted]:
    """A technological load or a resistance, with its opposite on the link it pushes against."""
    moved = given.moved
    if isinstance(load.law, Viscous | Quadratic):
        size, dsize = _resistance(given, load, change)
    else:
        size, dsize = _placed(given, load, change, number)
    pairs = [(load.link, 1.0), *([(load.against, -1.0)] if load.against != FRAME or load.kind == "moment" else [])]
    pairs = [(link, sign) for link, sign in pairs if link != FRAME]
    if load.kind == "moment":
        return [given.couple(link, sign * size, sign * dsize) for link, sign in pairs]
    r, dr = (jet[0] for jet in moved.point(load.link, load.point, change.point))
    e, de = (jet[0] for jet in _direction(given, load, change))
    force, dforce = size * e[0], dsize * e + size * de
    return [given.at(link, r[0], dr, sign * force, sign * dforce) for link, sign in pairs]


def _direction(given: Given, load: Load, change: Any) -> tuple[Plane, Plane]:
    body, own = given.moved.bodies[load.follows], given.moved.links[load.follows]
    return load.direction * body.u, load.direction * own.u + change.direction * body.u


def _resistance(given: Given, load: Load, change: Any) -> tuple[Real, Real]:
    """-c v or -c v |v| of the velocity (n,) along the direction, and its change (K, n)."""
    moved, w, dw = given.moved, given.scene.travel.speed, given.moved.changes.input.speed
    if load.kind == "moment":
        turn = {k: ((moved.bodies[k].u[1] / moved.bodies[k].u[0]).imag, moved.links[k].angle[1]) for k in _sides(load)}
        rate, drate = (turn[load.link][part] - turn[load.against][part] for part in (0, 1))
    else:
        relative, drelative = _relative(given, load, change)
        e, de = (jet[0] for jet in _direction(given, load, change))
        rate = (np.conj(e) * relative).real
        drate = (np.conj(de) * relative + np.conj(e) * drelative).real
    v, dv = rate * w, drate * w + rate * dw
    law: Any = load.law
    c, dc = law.coefficient * load.factor, change.law.coefficient * load.factor + law.coefficient * change.factor
    if isinstance(load.law, Viscous):
        return -(c * v)[0], -(dc * v + c * dv)
    return -(c * v * np.abs(v))[0], -(dc * v * np.abs(v) + 2 * c * np.abs(v) * dv)


def _sides(load: Load) -> tuple[int, int]:
    return load.link, load.against


def _relative(given: Given, load: Load, change: Any) -> tuple[Plane, Plane]:
    """Velocity (1, n) of the load's point against the link that it pushes against, where it stands, and its change."""
    moved = given.moved
    (r, v, _), (dr, dv, _) = moved.point(load.link, load.point, change.point)
    other, dother = moved.bodies[load.against], moved.links[load.against]
    i_omega = other.u[1] / other.u[0]
    di_omega = 1j * dother.angle[1]
    carried = other.z[1] + i_omega * (r - other.z[0])
    dcarried = dother.z[1] + di_omega * (r - other.z[0]) + i_omega * (dr - dother.z[0])
    return v - carried, dv - dcarried


def _placed(given: Given, load: Load, change: Any, number: int) -> tuple[Real, Real]:
    """Size (n,) of a load of the position, and its change (K, n)."""
    law, scene = load.law, given.scene
    assert isinstance(law, Placed)
    acting = [each for each in scene.loading.loads if each.factor and isinstance(each.law, Placed)]
    windows = {each.name: window_of(scene.chain, given.kinematics, scene.travel, each) for each in acting}
    beside = [windows[o.name] for o in acting if (o.link, o.kind) == (load.link, load.kind) and o is not load]
    inside = handed_over(scene.travel, windows[load.name], beside)(given.place)
    own = Acting(scene.chain, given.kinematics, scene.travel, scene.survey, load, windows[load.name])
    size = law.along(own).at(given.place)
    if isinstance(law, Constant):
        dsize = change.law.value * np.ones_like(size)
    else:
        dsize = np.stack([_difference(given, number, k) for k in range(len(given.dtheta))])
    return np.where(inside, load.factor * size, 0.0), np.where(inside, load.factor * dsize + change.factor * size, 0.0)


def _difference(given: Given, number: int, k: int) -> Real:
    """Change (n,) of the law of a load along direction k: by differences of its formula, at places known exactly."""
    total = np.zeros(len(given.place.theta))
    for weight, step, made in stepped(given, k):
        total += weight * _value(given, *made, number, k, step)
    return total


def stepped(given: Given, k: int) -> Iterator[tuple[float, float, tuple[Any, Loading]]]:
    """Mechanism and loading at the steps of a difference along direction k, with weights; nothing where nothing moves.

    The weights are those of the derivative.
    """
    tree = (given.scene.chain.mechanism, given.scene.loading)
    base = np.array(numbers(tree), complex)
    plain = [isinstance(value, float) for value in numbers(tree)]
    parts = np.abs(given.slopes[k]) / _sizes(tree, base)
    changes = [np.max(parts, initial=0.0), np.max(np.abs(given.dtheta[k]))]
    changes += [np.max(np.abs(change.angle[0, k])) for change in given.moved.links.values()]
    changes += [np.max(np.abs(change.z[0, k])) / given.moved.reach for change in given.moved.links.values()]
    largest = float(max(changes))
    for step, weight in STENCIL if largest else ():
        h = STEP / largest
        moved = base + step * h * given.slopes[k]
        leaves = [v.real if real else v for v, real in zip(moved.tolist(), plain, strict=True)]
        yield weight / h, step * h, rebuilt(tree, leaves)


def _sizes(tree: Any, base: Slopes) -> Real:
    """Ordinary sizes (L,) of numbers: their own, of zeros the largest of their record, else one."""
    own, owner = np.abs(base), np.array(groups(tree))
    largest = np.zeros(int(owner.max(initial=0)) + 1)
    np.maximum.at(largest, owner, own)
    sizes = np.where(own > 0, own, largest[owner])
    return np.where(sizes > 0, sizes, 1.0)


def edge_moves(given: Given, theta: float) -> Real | None:
    """Change (K,) of the angle along the motion at which a load begins or ends, of one that does so at theta.

    None where none does.
    """
    scene = given.scene
    for number, load in enumerate(scene.loading.loads):
        edges = window_of(scene.chain, given.kinematics, scene.travel, load).edges if load.factor else []
        own = [at for at, edge in enumerate(edges) if abs(edge - theta) <= EDGE]
        if own:
            found = np.zeros(len(given.dtheta))
            for k in range(len(found)):
                for weight, step, (mechanism, loading) in stepped(given, k):
                    chain, kinematics = replace(scene.chain, mechanism=mechanism), given.stepped(k, step)
                    travel = travel_of(chain, kinematics, loading.loads)
                    found[k] += weight * (
                        window_of(chain, kinematics, travel, loading.loads[number]).edges[own[0]] - theta
                    )
            return found
    return None


def _value(given: Given, mechanism: Any, loading: Loading, number: int, k: int, h: float) -> Real:
    """The law of a load (n,) where everything has changed by h along direction k."""
    scene, load = given.scene, loading.loads[number]
    chain: Chain = replace(scene.chain, mechanism=mechanism)
    kinematics = given.stepped(k, h)
    travel = travel_of(chain, kinematics, loading.loads)
    motions = {}
    for link, motion in given.place.configuration.motions.items():
        change, at = given.moved.links[link], motion.point(0j)
        turned = motion.u * np.exp(1j * h * change.angle[0, k])
        motions[link] = LinkMotion(0j, at.r + h * change.z[0, k], at.v, at.a, turned, *motion[5:])
    slides = dict(given.place.configuration.slides)
    for joint in chain.layout.joints:
        change_of = given.moved.slide(scene.chain.mechanism.joint(joint))[1]
        slides[joint] = slides[joint]._replace(s=slides[joint].s + h * change_of[0, k])
    configuration = given.place.configuration._replace(motions=motions, slides=slides)
    place = given.place._replace(theta=given.place.theta + h * given.dtheta[k], configuration=configuration)
    window = window_of(chain, kinematics, travel, load)
    law = load.law
    assert isinstance(law, Placed)
    return law.along(Acting(chain, kinematics, travel, scene.survey, load, window)).at(place)


def _spring(given: Given, spring: Spring, change: Any, number: int) -> list[Acted]:
    """A spring with its damper, between two points or about a pin."""
    moved, (a, b) = given.moved, spring.links
    w, dw = given.scene.travel.speed, given.moved.changes.input.speed
    if spring.kind == "torsion":
        moment, dmoment = _torsion(given, spring, change, number)
        pair: Sequence[tuple[int, float]] = ((a, 1.0), (b, -1.0))
        return [given.couple(link, sign * moment, sign * dmoment) for link, sign in pair if link != FRAME]
    (one, done), (other, dother) = (
        moved.point(k, p, dp) for k, p, dp in zip(spring.links, spring.points, change.points, strict=True)
    )
    d, dd = other - one, dother - done
    length = np.abs(d[0])
    e = d[0] / length
    dlength = (np.conj(e) * dd[0]).real
    de = (dd[0] - e * dlength) / length
    rate = (np.conj(e) * d[1]).real
    drate = (np.conj(de) * d[1] + np.conj(e) * dd[1]).real
    pull = spring.stiffness * (length - spring.free) + spring.damping * rate * w
    dpull = change.stiffness * (length - spring.free) + spring.stiffness * (dlength - change.free)
    dpull = dpull + change.damping * rate * w + spring.damping * (drate * w + rate * dw)
    force, dforce = (pull * e)[0], dpull * e + pull * de
    ends = ((a, one, done, 1.0), (b, other, dother, -1.0))
    return [given.at(k, r[0, 0], dr[0], s * force, s * dforce) for k, r, dr, s in ends if k != FRAME]


def _torsion(given: Given, spring: Spring, change: Any, number: int) -> tuple[Real, Real]:
    """The moment (n,) on the first link, as the sources of the scene give it, and its change (K, n)."""
    moved, (a, b) = given.moved, spring.links
    w, dw = given.scene.travel.speed, given.moved.changes.input.speed
    elastic: Real = np.zeros(len(given.place.theta))
    for source in given.scene.sources:
        if source.name == spring.name and source.kind == "spring":
            action = source.actions(given.place)[0]
            elastic = action.moment * (1.0 if action.link == a else -1.0)
    rates = {k: (moved.bodies[k].u[1] / moved.bodies[k].u[0]).imag for k in (a, b)}
    rate = rates[b] - rates[a]
    angle, drate = (moved.links[b].angle[order] - moved.links[a].angle[order] for order in (0, 1))
    damped = spring.damping * rate * w
    dmoment = spring.stiffness * (angle - change.free) + change.damping * rate * w
    dmoment = dmoment + spring.damping * (drate * w + rate * dw)
    if spring.stiffness:
        dmoment = dmoment + change.stiffness * elastic / spring.stiffness
    return np.asarray((elastic + damped)[0]), dmoment
