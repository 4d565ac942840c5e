"""Routes, laws and arms at 50 digits, written out anew: the joints by coordinates and 2 x 2 systems."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from itertools import pairwise
from typing import Any

from mpmath import mp, mpf

from tmmcalc.manipulators.task import ArcRoute, Arm, Drive, PathTask, PolyRoute, Route

Vector = list[Any]
Piece = tuple[Any, Callable[[Any], tuple[Vector, Vector, Vector]]]  # length, place with both derivatives over the way
NEAR = mpf(10) ** -9  # of a duration or length: the side decides


def _times(k: Any, a: Sequence[Any]) -> Vector:
    return [k * each for each in a]


def _plus(*vectors: Sequence[Any]) -> Vector:
    return [sum(parts, mpf(0)) for parts in zip(*vectors, strict=True)]


def _minus(a: Sequence[Any], b: Sequence[Any]) -> Vector:
    return [x - y for x, y in zip(a, b, strict=True)]


def _dot(a: Sequence[Any], b: Sequence[Any]) -> Any:
    return sum((x * y for x, y in zip(a, b, strict=True)), mpf(0))


def _size(a: Sequence[Any]) -> Any:
    return mp.sqrt(_dot(a, a))


def _unit(a: Sequence[Any]) -> Vector:
    return _times(1 / _size(a), a)


def _point(place: Sequence[float]) -> Vector:
    return [mpf(float(each)) for each in place]


def line(start: Vector, end: Vector) -> Piece:
    along = _unit(_minus(end, start))
    still = _times(0, along)
    return _size(_minus(end, start)), lambda s: (_plus(start, _times(s, along)), along, still)


def arc(centre: Vector, start: Vector, tangent: Vector, turn: Any) -> Piece:
    """From a point in the direction of a tangent by an angle above zero."""
    out = _minus(start, centre)
    radius = _size(out)
    u = _unit(out)

    def at(s: Any) -> tuple[Vector, Vector, Vector]:
        c, d = mp.cos(s / radius), mp.sin(s / radius)
        place = _plus(centre, _times(radius * c, u), _times(radius * d, tangent))
        along = _plus(_times(-d, u), _times(c, tangent))
        return place, along, _times(1 / radius**2, _minus(centre, place))

    return radius * turn, at


@cache
def legs(route: Route) -> list[list[Piece]]:
    if isinstance(route, PolyRoute):
        return _polyline(route)
    start, end = _point(route.start), _point(route.end)
    chord = _minus(end, start)
    d, middle = _size(chord), _times(mpf(1) / 2, _plus(start, end))
    if isinstance(route, ArcRoute):
        left = [-chord[1], chord[0]] if len(chord) == 2 else _cross(_point(route.normal), chord)
        left, radius = _unit(left), mpf(route.radius)
        away = mp.sqrt(max(radius**2 - d**2 / 4, mpf(0)))
        centre = _plus(middle, _times(route.side * away, left))
        tangent = _unit(_minus(_times(away / d, chord), _times(route.side * d / 2, left)))
        return [[arc(centre, start, tangent, 2 * mp.asin(min(d / (2 * radius), mpf(1))))]]
    via = _point(route.via)
    b, c = _minus(via, start), chord
    bb, cc, bc = _dot(b, b), _dot(c, c), _dot(b, c)
    area = 2 * (bb * cc - bc**2)
    centre = _plus(start, _times(cc * (bb - bc) / area, b), _times(bb * (cc - bc) / area, c))
    radius = _size(_minus(start, centre))
    half = mp.asin(min(d / (2 * radius), mpf(1)))
    beyond = _dot(_minus(via, middle), _minus(centre, middle)) > 0
    out = _minus(start, centre)
    tangent = _unit(_minus(_times(_dot(b, out), c), _times(_dot(c, out), b)))
    return [[arc(centre, start, tangent, 2 * (mp.pi - half) if beyond else 2 * half)]]


def _cross(a: Vector, b: Vector) -> Vector:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _polyline(route: PolyRoute) -> list[list[Piece]]:
    points, corner = [_point(each) for each in route.points], mpf(route.corner)
    found: list[list[Piece]] = [[]]
    begin = points[0]
    for k, point in enumerate(points[1:-1], 1):
        before, after = _unit(_minus(point, points[k - 1])), _unit(_minus(points[k + 1], point))
        if not corner:
            found[-1].append(line(begin, point))
            found.append([])
            begin = point
            continue
        turn = mp.acos(_dot(before, after))
        cut = corner * mp.tan(turn / 2)
        first, last = _minus(point, _times(cut, before)), _plus(point, _times(cut, after))
        found[-1].append(line(begin, first))
        inward = _unit(_minus(after, before))
        centre = _plus(point, _times(corner / mp.cos(turn / 2), inward))
        found[-1].append(arc(centre, first, before, turn))
        begin = last
    found[-1].append(line(begin, points[-1]))
    return found


@cache
def _laws(asked: PathTask) -> tuple[Vector, list[tuple[Any, Any, Any]]]:
    """Lengths and laws of all legs."""
    parts = legs(asked.route)
    lengths = [sum((piece[0] for piece in leg), mpf(0)) for leg in parts]
    return lengths, [law(length, asked.drive, _radii(leg)) for length, leg in zip(lengths, parts, strict=True)]


def law(way: Any, drive: Drive, radii: Sequence[Any]) -> tuple[Any, Any, Any]:
    """t_1, t_2 and the peak speed over a way."""
    a = mpf(drive.acceleration)
    if drive.duration is not None:
        uniform = mp.sqrt(mpf(drive.duration) ** 2 - 4 * way / a)
        peak = a * (mpf(drive.duration) - uniform) / 2
        return peak / a, uniform, peak
    limits = [mpf(drive.speed)] if drive.speed is not None else []
    if radii and drive.normal is not None:
        limits.append(mp.sqrt(mpf(drive.normal) * min(radii)))
    if radii and drive.total is not None:
        limits.append(mp.sqrt(mp.sqrt(mpf(drive.total) ** 2 - a**2) * min(radii)))
    return quickest(way, min(limits), a)


def quickest(way: Any, speed: Any, a: Any) -> tuple[Any, Any, Any]:
    if way * a >= speed**2:
        return speed / a, way / speed - speed / a, speed
    return mp.sqrt(way / a), mpf(0), mp.sqrt(way * a)


def along(found: tuple[Any, Any, Any], way: Any, a: Any, t: Any, side: int) -> Vector:
    """s, v, a of a law; which phase by the side where t is next to its end."""
    ramp, uniform, peak = found
    whole = 2 * ramp + uniform
    t += side * NEAR * whole if min(abs(t - each) for each in (ramp, ramp + uniform)) < NEAR * whole else 0
    moved = t
    if abs(t - ramp) <= 2 * NEAR * whole or abs(t - ramp - uniform) <= 2 * NEAR * whole:
        t -= side * NEAR * whole
    if moved < ramp:
        return [a * t**2 / 2, a * t, a]
    if moved < ramp + uniform:
        return [peak * ramp / 2 + peak * (t - ramp), peak, mpf(0)]
    return [way - a * (whole - t) ** 2 / 2, a * (whole - t), -a]


def gripper(asked: PathTask, t: float, side: int) -> tuple[Vector, list[Vector]]:
    """s, v, a from the start of the path, and place, velocity, acceleration of the gripper."""
    parts, drive = legs(asked.route), asked.drive
    lengths, laws = _laws(asked)
    durations = [2 * each[0] + each[1] for each in laws]
    left, done, k, whole = mpf(t), mpf(0), 0, sum(durations)
    while k < len(parts) - 1 and left > durations[k] + (NEAR if side < 0 else -NEAR) * whole:
        left, done, k = left - durations[k], done + lengths[k], k + 1
    s, v, a = along(laws[k], lengths[k], mpf(drive.acceleration), left, side)
    start, j, leg = mpf(0), 0, parts[k]
    while j < len(leg) - 1 and s > start + leg[j][0] + (NEAR if side < 0 else -NEAR) * lengths[k]:
        start, j = start + leg[j][0], j + 1
    place, tangent, bend = leg[j][1](s - start)
    return [done + s, v, a], [place, _times(v, tangent), _plus(_times(a, tangent), _times(v**2, bend))]


def _radii(leg: list[Piece]) -> Vector:
    bends = [_size(piece[1](mpf(0))[2]) for piece in leg]
    return [1 / bend for bend in bends if bend]


def inverse(arm: Arm, p: list[Vector]) -> list[Vector]:
    """Joint coordinates with both rates, (3, J)."""
    (z0, z1, z2) = (each[-1] for each in p)
    z0 -= mpf(arm.height)
    base: list[Vector] = [[], [], []]
    r0, r1, r2 = (each[0] for each in p)
    if arm.spatial:
        (x, y), (u, v), (du, dv) = (each[:2] for each in p)
        r0 = mp.sqrt(x * x + y * y)
        r1, turn = (x * u + y * v) / r0, (x * v - y * u) / r0**2
        r2 = (u * u + v * v + x * du + y * dv - r1**2) / r0
        base = [[mp.atan2(y, x)], [turn], [(x * dv - y * du - 2 * r0 * r1 * turn) / r0**2]]
    if arm.kind == "cylindrical":
        own = [[z0, r0], [z1, r1], [z2, r2]]
    elif arm.kind == "spherical":
        l0 = mp.sqrt(r0**2 + z0**2)
        l1, turn = (r0 * r1 + z0 * z1) / l0, (r0 * z1 - z0 * r1) / l0**2
        l2 = (r1**2 + z1**2 + r0 * r2 + z0 * z2 - l1**2) / l0
        own = [[mp.atan2(z0, r0), l0], [turn, l1], [(r0 * z2 - z0 * r2 - 2 * l0 * l1 * turn) / l0**2, l2]]
    else:
        own = _angular(arm, (r0, z0), (r1, z1), (r2, z2))
    return [first + second for first, second in zip(base, own, strict=True)]


def _angular(arm: Arm, place: Any, velocity: Any, acceleration: Any) -> list[Vector]:
    a, b = mpf(arm.upper), mpf(arm.forearm)
    d = mp.hypot(*place)
    q2 = mp.atan2(place[1], place[0]) + arm.elbow * mp.acos((d**2 + a**2 - b**2) / (2 * a * d))
    q3 = mp.atan2(place[1] - a * mp.sin(q2), place[0] - a * mp.cos(q2))
    jacobian = mp.matrix([[-a * mp.sin(q2), -b * mp.sin(q3)], [a * mp.cos(q2), b * mp.cos(q3)]])
    rates = mp.lu_solve(jacobian, mp.matrix(velocity))
    pull = [
        acceleration[0] + a * mp.cos(q2) * rates[0] ** 2 + b * mp.cos(q3) * rates[1] ** 2,
        acceleration[1] + a * mp.sin(q2) * rates[0] ** 2 + b * mp.sin(q3) * rates[1] ** 2,
    ]
    return [[q2, q3], list(rates), list(mp.lu_solve(jacobian, mp.matrix(pull)))]


def direct(arm: Arm, q: list[Vector]) -> list[Vector]:
    """Place, velocity, acceleration of the gripper of joint states (3, J), by differences over short times."""

    def at(t: Any) -> Vector:
        now = [x + v * t + a * t * t / 2 for x, v, a in zip(*q, strict=True)]
        own = now[1:] if arm.spatial else now
        if arm.kind == "cylindrical":
            r, z = own[1], own[0]
        elif arm.kind == "spherical":
            r, z = own[1] * mp.cos(own[0]), own[1] * mp.sin(own[0])
        else:
            a, b = mpf(arm.upper), mpf(arm.forearm)
            r, z = a * mp.cos(own[0]) + b * mp.cos(own[1]), a * mp.sin(own[0]) + b * mp.sin(own[1])
        flat = [r * mp.cos(now[0]), r * mp.sin(now[0])] if arm.spatial else [r]
        return [*flat, z + mpf(arm.height)]

    with mp.workdps(100):
        h = mpf(10) ** -25 / (1 + max(map(abs, q[1] + q[2])))
        back, here, ahead = at(-h), at(mpf(0)), at(h)
        first = [(b - a) / (2 * h) for a, b in zip(back, ahead, strict=True)]
        second = [(a - 2 * m + b) / h**2 for a, m, b in zip(back, here, ahead, strict=True)]
    return [here, first, second]


@cache
def spline(t: tuple[float, ...], q: tuple[float, ...]) -> Callable[[Any], Vector]:
    """The clamped cubic spline through a table by its second derivatives at the knots."""
    x, y = [mpf(each) for each in t], [mpf(each) for each in q]
    h = [b - a for a, b in pairwise(x)]
    n = len(x)
    system, right = mp.zeros(n, n), mp.zeros(n, 1)
    system[0, 0], system[0, 1], right[0] = 2 * h[0], h[0], 6 * (y[1] - y[0]) / h[0]
    system[n - 1, n - 1], system[n - 1, n - 2], right[n - 1] = 2 * h[-1], h[-1], -6 * (y[-1] - y[-2]) / h[-1]
    for i in range(1, n - 1):
        system[i, i - 1], system[i, i], system[i, i + 1] = h[i - 1], 2 * (h[i - 1] + h[i]), h[i]
        right[i] = 6 * ((y[i + 1] - y[i]) / h[i] - (y[i] - y[i - 1]) / h[i - 1])
    m = mp.lu_solve(system, right)

    def at(time: Any) -> Vector:
        now = time + x[0]
        i = max(k for k in range(n - 1) if x[k] <= now or k == 0)
        a, b, step = x[i + 1] - now, now - x[i], h[i]
        low, high = y[i] / step - m[i] * step / 6, y[i + 1] / step - m[i + 1] * step / 6
        place = (m[i] * a**3 + m[i + 1] * b**3) / (6 * step) + low * a + high * b
        rate = (m[i + 1] * b**2 - m[i] * a**2) / (2 * step) - low + high
        return [place, rate, (m[i] * a + m[i + 1] * b) / step]

    return at
