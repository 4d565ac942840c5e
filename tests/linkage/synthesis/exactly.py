"""What sizes of designs have to keep at 60 digits, by dead centres, triangles and circles; and the nearest that do."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from mpmath import mp, mpf

from tmmcalc.linkage.synthesis.results import Design
from tmmcalc.linkage.synthesis.task import (
    CrankRockerTask,
    FunctionTask,
    PoseTask,
    RotatingTask,
    SliderCrankTask,
    SlottedTask,
    TrailingRodTask,
)

Equations = Callable[[list[Any]], list[Any]]


def settled(f: Equations, x: Sequence[Any], steps: int = 6) -> list[Any]:
    """The nearest unknowns that keep the equations, by steps of Newton's of the least size.

    The derivatives at the start serve as long as each step with them leaves less than a millionth of the one before.
    """
    x, slopes, last = list(x), None, mp.inf
    while steps:
        if slopes is None:
            slopes, steps = _slopes(f, x), steps - 1
        open_ = mp.matrix(f(x))
        if slopes.rows > slopes.cols:
            step = mp.lu_solve(slopes, open_)  # least squares of equations that agree
        else:
            step = slopes.T * mp.lu_solve(slopes * slopes.T, open_)
        x = [a - b for a, b in zip(x, step, strict=True)]
        size = max(map(abs, step))
        if size < mpf(10) ** -32:
            break
        slopes, last = slopes if size < last / 10**6 else None, size
    return x


def _slopes(f: Equations, x: list[Any]) -> Any:
    """Derivatives of the equations by the unknowns, to some twenty digits."""
    h, here, columns = mpf(10) ** -20, f(x), []
    for k in range(len(x)):
        ahead = f([*x[:k], x[k] + h, *x[k + 1 :]])
        columns.append([(a - b) / h for a, b in zip(ahead, here, strict=True)])
    return mp.matrix(columns).T


def _psi(ratio: float) -> Any:
    return mp.pi * (mpf(ratio) - 1) / (mpf(ratio) + 1)


def slider_crank(asked: SliderCrankTask, unit: float) -> Equations:
    def missed(x: list[Any]) -> list[Any]:
        r, l, e = x
        stroke = mp.sqrt((l + r) ** 2 - e**2) - mp.sqrt((l - r) ** 2 - e**2)
        values = {
            "stroke": stroke * unit, "crank": r * unit, "rod": l * unit, "offset": e * unit, "crank_ratio": r / l,
            "offset_ratio": e / r, "offset_part": e / stroke, "pressure_working": mp.asin((r - e) / l),
            "pressure_idle": mp.asin((r + e) / l), "time_ratio": mp.asin(e / (l - r)) - mp.asin(e / (l + r)),
        }  # fmt: skip
        found = []
        for name, value in values.items():
            wanted = getattr(asked, name)
            if wanted is not None:
                scale = unit if name in ("stroke", "crank", "rod", "offset") else 1
                found.append((value - (_psi(wanted) if name == "time_ratio" else mpf(wanted))) / scale)
        return found

    return missed


def slotted(asked: SlottedTask, unit: float) -> Equations:
    """The rod is across the slotted link at both ends of its swing; the largest tilt is in the middle or at an end."""

    def missed(x: list[Any]) -> list[Any]:
        r, centres, arm, rod, e = x
        phi = mp.asin(r / centres)
        found = [2 * phi - _psi(asked.time_ratio), 2 * arm * mp.sin(phi) - mpf(asked.stroke) / unit]
        for value, wanted in ((r, asked.crank), (centres, asked.centres), (e, asked.guide), (rod, asked.rod)):
            if wanted is not None:
                found.append(value - mpf(wanted) / unit)
        if asked.pressure is not None and asked.rod is None:
            tilts = [abs(mp.asin((e - arm * c) / rod)) for c in (1, mp.cos(phi))]
            found.append(max(tilts) - mpf(asked.pressure))
        if len(found) < 5:
            found.append(e - centres - mpf(asked.clearance) * r)
        return found

    return missed


def trailing(asked: TrailingRodTask, unit: float) -> Equations:
    """With the crank at the V angle the pin C and the piston D lie on the left axis, D at r + l from O."""

    def missed(x: list[Any]) -> list[Any]:
        length, alpha = x
        (r, l, lug), beta = (mpf(each) / unit for each in (asked.crank, asked.rod, asked.lug)), mpf(asked.v_angle)
        rod = -mp.asin(r * mp.sin(beta) / l)
        pin = r * mp.expj(beta) + lug * mp.expj(rod + alpha)
        along = pin * mp.expj(-beta)
        return [along.imag / lug, along.real + mp.sqrt(length**2 - along.imag**2) - r - l]

    return missed


def rotating(asked: RotatingTask, unit: float) -> Equations:
    e = mpf(asked.guide) / unit

    def pin(theta: Any, r: Any, centres: Any) -> Any:
        """Angle of the crank about A with the pin on the ray from C."""
        away = centres * mp.sin(theta) + mp.sqrt(r**2 - (centres * mp.cos(theta)) ** 2)
        return mp.arg((away * mp.expj(theta) - 1j * centres) / mp.expj(theta)) + theta

    def missed(x: list[Any]) -> list[Any]:
        r, centres, arm, rod = x
        stroke = mp.sqrt((rod + arm) ** 2 - e**2) + arm * 0 - mp.sqrt((rod - arm) ** 2 - e**2)
        ends = mp.asin(e / (rod + arm)), mp.pi + mp.asin(e / (rod - arm))
        turned = pin(ends[1], r, centres) - pin(ends[0], r, centres)
        found = [stroke - mpf(asked.stroke) / unit, turned - mp.pi - _psi(asked.time_ratio)]
        for value, wanted in ((r, asked.crank), (centres, asked.centres), (rod, asked.rod)):
            if wanted is not None:
                found.append(value - mpf(wanted) / unit)
        if asked.rod is None:
            found.append(mp.asin((arm + abs(e)) / rod) - mpf(asked.pressure))
        return found

    return missed


def crank_rocker(asked: CrankRockerTask, unit: float) -> Equations:
    """The triangles of both dead centres by the cosine rule."""

    def missed(x: list[Any]) -> list[Any]:
        r, l, rocker, frame = x
        ends = [l + r, l - r]
        at_rocker = [mp.acos((rocker**2 + frame**2 - a**2) / (2 * rocker * frame)) for a in ends]
        at_crank = [mp.acos((frame**2 + a**2 - rocker**2) / (2 * frame * a)) for a in ends]
        found = [
            at_rocker[0] - at_rocker[1] - mpf(asked.swing),
            abs(at_crank[1] - at_crank[0]) - _psi(asked.time_ratio),
        ]
        for value, name in zip(x, ("crank", "coupler", "rocker", "frame"), strict=True):
            if getattr(asked, name) is not None:
                found.append(value - mpf(getattr(asked, name)) / unit)
        if asked.transmission is not None:
            found.append(transmission(x) - mpf(asked.transmission))
        return found

    return missed


def transmission(x: list[Any]) -> Any:
    r, l, rocker, frame = x
    cosines = [(l**2 + rocker**2 - (frame + sign * r) ** 2) / (2 * l * rocker) for sign in (1, -1)]
    return mp.acos(max(map(abs, cosines)))


def best_rocker(asked: CrankRockerTask, x: list[Any], unit: float) -> list[Any]:
    """The best transmission along the family about the sizes x, by ever shorter brackets of the coupler."""
    names = ("crank", "coupler", "rocker", "frame")
    base = next(k for k, name in enumerate(names) if getattr(asked, name) is not None)
    half, psi = mpf(asked.swing) / 2, _psi(asked.time_ratio)

    def member(l: Any, side: int) -> list[Any]:
        """Of rocker length 1, from the triangle of the crank's pivot and both ends of the rocker pin."""
        r = mp.sqrt(mp.sin(half) ** 2 - (l * mp.sin(psi / 2)) ** 2) / mp.cos(psi / 2)
        ends = [mp.expj(mp.pi / 2 + sign * half) for sign in (1, -1)]
        far, near = l + r, l - r
        along = (far**2 - near**2) / (2 * (2 * mp.sin(half)))
        off = mp.sqrt(far**2 - (along + mp.sin(half)) ** 2)
        pivot = (ends[0] + ends[1]) / 2 + along + side * 1j * off
        sizes = [r, l, mpf(1), abs(pivot)]
        scale = mpf(getattr(asked, names[base])) / unit / sizes[base]
        return [scale * each for each in sizes]

    def value(l: Any) -> Any:
        y = member(l, side)
        longest = max(y[1:])
        return transmission(y) if longest <= asked.largest_ratio * y[0] * (1 + mpf(10) ** -30) else -longest / y[0]

    middle = x[1] / x[2]
    side = min((1, -1), key=lambda way: max(abs(a - b) for a, b in zip(member(middle, way), x, strict=True)))
    low, high = middle * (1 - mpf(10) ** -5), middle * (1 + mpf(10) ** -5)
    for _ in range(64):
        a, b = low + (high - low) * mpf("0.4"), low + (high - low) * mpf("0.6")
        low, high = (low, b) if value(a) >= value(b) else (a, high)
    return member((low + high) / 2, side)


def function(asked: FunctionTask, design: Design, unit: float) -> tuple[Equations, list[Any]]:
    """Lengths over ``unit`` and free offsets, and the distance of both pins at all points."""
    slides = asked.mechanism == "slider_crank"
    x = [mpf(design.size(symbol)) / unit for symbol in ("rle" if slides else "abc")]
    starts = [mpf(design.size("phi_start")), mpf(design.size("s_start" if slides else "psi_start"))]
    fixed = []
    for k, (told, wanted) in enumerate(zip(starts, (asked.input_start, asked.output_start), strict=True)):
        length = slides and k == 1
        if wanted is None:
            fixed.append(None)
            x.append(told / unit if length else told)
        else:
            fixed.append(mpf(wanted) / unit if length else wanted + mp.pi * mp.nint((told - wanted) / mp.pi))

    def missed(y: list[Any]) -> list[Any]:
        rest = iter(y[3:])
        u, v = (next(rest) if each is None else each for each in fixed)
        found = []
        for phi, out in zip(asked.inputs.tolist(), asked.outputs.tolist(), strict=True):
            px, py = y[0] * mp.cos(mpf(phi) + u), y[0] * mp.sin(mpf(phi) + u)
            if slides:
                found.append((px - mpf(out) / unit - v) ** 2 + (py - y[2]) ** 2 - y[1] ** 2)
            else:
                cx, cy = mpf(asked.frame) / unit + y[2] * mp.cos(mpf(out) + v), y[2] * mp.sin(mpf(out) + v)
                found.append((px - cx) ** 2 + (py - cy) ** 2 - y[1] ** 2)
        return found

    return missed, x


def posed(asked: PoseTask, design: Design, unit: float) -> tuple[Equations, list[Any], int]:
    """Sizes over ``unit`` about the middle of the points, then the turns of the coupler; how many are sizes."""
    slides = asked.mechanism == "slider_crank"
    middle = complex(asked.points.mean())
    ends = ("x_G", "y_G", "gamma") if slides else ("x_D", "y_D", "c")
    x = []
    for symbol in ("x_A", "y_A", "a", "b", "p", "q", *ends):
        value = mpf(design.size(symbol))
        shift = middle.real if symbol[0] == "x" else middle.imag if symbol[0] == "y" else 0.0
        x.append(value if symbol == "gamma" else (value - shift) / unit)
    count = len(x)
    points = [(mp.mpc(complex(each)) - mp.mpc(middle)) / unit for each in asked.points]
    assert design.precision is not None
    phi = design.precision.crank.tolist()
    if asked.timing is not None:
        x.append(mpf(phi[0]))
    if asked.angles is not None:
        x.append(mpf(design.size("body")))
    else:
        arms = [P - mp.mpc(x[0], x[1]) - x[2] * mp.expj(mpf(f)) for P, f in zip(points, phi, strict=True)]
        x += [mp.arg(arm / mp.mpc(x[4], x[5])) for arm in arms]

    def missed(y: list[Any]) -> list[Any]:
        rest = y[count:]
        first = rest.pop(0) if asked.timing is not None else None
        found = []
        for j, point in enumerate(points):
            turn = mp.expj(rest[j] if asked.angles is None else mpf(float(asked.angles[j])) - rest[0])
            b = point - turn * mp.mpc(y[4], y[5])
            c = b + turn * y[3]
            pivot = b - mp.mpc(y[0], y[1])
            if first is None:
                found.append(pivot.real**2 + pivot.imag**2 - y[2] ** 2)
            else:
                assert asked.timing is not None
                gap = pivot - y[2] * mp.expj(first + mpf(float(asked.timing[j])))
                found += [gap.real, gap.imag]
            other = c - mp.mpc(y[6], y[7])
            if slides:
                found.append(other.imag * mp.cos(y[8]) - other.real * mp.sin(y[8]))
            else:
                found.append(other.real**2 + other.imag**2 - y[8] ** 2)
        return found

    return missed, x, count
