"""Wet cylinder liner that hangs by its collar: the collar is a ring, the cylinder below it a shell.

x runs along the bore from the ring, w is the deflection outwards. Forces and moments are those on a unit of the
circumference of radius r1: Q0 pushes the end of the shell outwards, M0 and m turn towards larger dw/dx. With
xi = alpha x the shell's D w'''' + E h w/r1^2 = p gives waves that die away from either end.
"""

from __future__ import annotations

from dataclasses import replace
from math import ceil, pi
from typing import Any, Literal, NamedTuple

import numpy as np

from tmmcalc.core.notes import Phrase, Said, held
from tmmcalc.core.numerics.extended import apart, spread, widened
from tmmcalc.core.numerics.extrema import around, maxima, refine
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record

SHOWN = 2 * pi  # alpha x to which a long liner is told
LONG = 3.0  # alpha L from which on the end of the liner is hardly felt at the ring
THIN = 0.1  # h/r1 up to which a shell is thin
LOOKED = 24  # rows that are computed again
DENSE = 64  # samples in a unit of alpha x among which extremes are looked for,
FADED = 4 * pi  # up to here: behind it 3e-6 is left of what the ring does to the shell


@record
class Clamp:
    """The force that holds the collar between the head and the block, as a multiple of the gas force."""

    pressure: float  # p_max [Pa]
    bore: float  # diameter of the area F_h that the gas acts on [m]
    arm: float  # of the force of the block outside that of the head [m]
    factor: float = 1.8  # P = factor p_max F_h


@record
class LinerTask:
    """A liner, what it is of, and what loads it."""

    radius: float  # r1 of the shell, at which the ring joins it [m]
    thickness: float  # h of the shell [m]
    outer: float  # r2 of the ring [m]
    width: float  # b of the ring along the bore [m]
    young: float  # E [Pa]
    poisson: float  # mu
    load: float = 0.0  # q on the ring, outwards [N/m]
    moment: float = 0.0  # m on the ring [N]
    clamp: Clamp | None = None  # gives m
    pressure: float = 0.0  # p in the bore below the ring [Pa]
    length: float | None = None  # L of the shell [m]; None: it is long
    continuity: Literal["edge", "centre"] = "edge"
    allowed: float | None = None  # stress [Pa]
    rows: int = 200


@record
class Peak:
    """Where a stress is largest."""

    x: float = quantity("x[m]", "place along the bore, from the ring")
    stress: float = quantity("sigma[Pa]", "stress there")
    surface: str = quantity("surface", "surface of the shell, inner or outer")


@record
class LinerError:
    """Relative errors by the same formulas in extended precision."""

    forces: float  # Q0 and M0, each
    deflection: float
    moment: float
    stress: float


@record
class Liner:
    """What the ring and the shell do to each other, and the shell along the bore."""

    alpha: float = quantity("alpha[1/m]", "parameter of the shell, (3 (1 - mu^2)/(r1^2 h^2))^(1/4)", symbol=r"\alpha_s")
    stiffness: float = quantity("D[N*m]", "bending stiffness of the shell, E h^3/(12 (1 - mu^2))")
    ring_area: float = quantity("F_ring[m^2]", "section of the ring, F' = r1 b ln(r2/r1)", symbol="F'")
    ring_inertia: float = quantity("I_ring[m^4]", "moment of inertia of the ring, I' = F' b^2/12", symbol="I'")
    moment: float = quantity("m[N]", "moment on a unit of the circumference of the ring")
    force: float = quantity("Q0[N/m]", "force between ring and shell", symbol="Q_0", source="(8)")
    couple: float = quantity("M0[N]", "moment between ring and shell", symbol="M_0", source="(8)")
    continuity: str = quantity("continuity", "what the shell follows, the edge of the ring or its centre")
    other_force: float = quantity("Q0_other[N/m]", "Q0 by the other continuity")
    other_couple: float = quantity("M0_other[N]", "M0 by the other continuity")
    end: float = quantity("w0[m]", "deflection of the shell at the ring", symbol="w_0")
    turn: float = quantity("psi[rad]", "turn of the ring, dw/dx of the shell at it", symbol=r"\psi")
    centre: float = quantity("u_ring[m]", "displacement of the centre of the ring outwards", symbol="u")
    ring_stress: float = quantity("sigma_ring[Pa]", "largest stress along the circumference of the ring at r1")
    bending: Peak = quantity("bending", "largest stress of bending along the bore")
    largest: Peak = quantity("equivalent", "largest equivalent stress (Mises) of the shell")
    labels: tuple[str, ...]
    x: Values = quantity("x[m]", "place along the bore, from the ring")  # (n,)
    w: Values = quantity("w[m]", "deflection of the shell outwards", source="(9)")  # (n,)
    slope: Values = quantity("slope[rad]", "dw/dx")  # (n,)
    bend: Values = quantity("M[N]", "moment of bending D d2w/dx2; M = -M0 at the ring")  # (n,)
    shear: Values = quantity("Q[N/m]", "force across the shell, D d3w/dx3; Q = Q0 at the ring")  # (n,)
    axial: Values = quantity("sigma_x[Pa]", "stress of bending 6 M/h^2 at the inner surface")  # (n,)
    hoop: Values = quantity("sigma_t[Pa]", "stress E w/r1 along the circumference, mean of the wall")  # (n,)
    inner: Values = quantity("sigma_in[Pa]", "equivalent stress at the inner surface")  # (n,)
    outer: Values = quantity("sigma_out[Pa]", "equivalent stress at the outer surface")  # (n,)
    notes: tuple[Said, ...] = ()
    error: LinerError | None = None  # None: not estimated


class Shell(NamedTuple):
    """Numbers of the ring and the shell, and the waves of the deflection, in the numbers of the task."""

    alpha: Any
    stiffness: Any
    area: Any  # F'
    inertia: Any  # I'
    moment: Any  # m
    uniform: Any  # deflection by the pressure alone
    span: Any  # alpha L; None: long
    waves: Values  # (4,) [m]: of cos and sin from the ring, of cos and sin from the far end


def solve_liner(task: LinerTask) -> Liner:
    """Forces between ring and shell by continuity, the shell along the bore, where its stresses are largest."""
    shell = shell_of(task)
    end = along(task, shell, np.zeros(1))
    length = task.length if task.length is not None else SHOWN / shell.alpha
    x = length * np.arange(task.rows + 1) / task.rows
    rows = along(task, shell, x)
    turn, centre = float(end["slope"][0]), _centre(task, shell, float(end["shear"][0]))
    other = _other(task)
    bending, largest = _peak(task, shell, length, ("axial", "outer_axial")), _peak(task, shell, length)
    return Liner(
        alpha=float(shell.alpha),
        stiffness=float(shell.stiffness),
        ring_area=float(shell.area),
        ring_inertia=float(shell.inertia),
        moment=float(shell.moment),
        force=float(end["shear"][0]),
        couple=-float(end["bend"][0]),
        continuity=task.continuity,
        other_force=other[0],
        other_couple=other[1],
        end=float(end["w"][0]),
        turn=turn,
        centre=centre,
        ring_stress=task.young / task.radius * (abs(centre) + abs(turn) * task.width / 2),
        bending=bending,
        largest=largest,
        labels=tuple(map(str, range(len(x)))),
        x=x,
        **{name: rows[name] for name in ("w", "slope", "bend", "shear", "axial", "hoop", "inner", "outer")},
        notes=tuple(_notes(task, shell, largest)),
        error=_errors(task, shell, x),
    )


def shell_of(task: LinerTask) -> Shell:
    """The waves from the two equations of continuity (8), in the numbers of the task.

    Ring: u = (q - Q0) r1^2/(E F'), psi = (m - M0 - Q0 b/2) r1^2/(E I'); shell: w(0) = u + psi b/2, dw/dx(0) = psi.
    The source leaves psi b/2 out, and so has the shell follow the centre of the ring.
    """
    r, h, b, e = task.radius, task.thickness, task.width, task.young
    bulk = 1 - task.poisson**2
    alpha = np.sqrt(np.sqrt(3 * bulk)) / np.sqrt(r * h)
    stiffness = e * h**3 / (12 * bulk)
    area = r * b * np.log1p((task.outer - r) / r)
    inertia = area * b**2 / 12
    clamp = task.clamp
    moment = task.moment if clamp is None else clamp.factor * clamp.pressure * clamp.bore**2 * clamp.arm / (8 * r)
    uniform = task.pressure * r**2 / (e * h)
    span = None if task.length is None else alpha * task.length
    cosine, sine = (_shape(np.array(wave), 0.0 * alpha, span) for wave in _free(span))  # of A = 1, of B = 1
    value, slope, second, third = (np.array(pair) for pair in zip(cosine, sine, strict=True))
    shear, couple = stiffness * alpha**3 * third, -stiffness * alpha**2 * second
    radial, turning = r**2 / (e * area), r**2 / (e * inertia)
    led = b / 2 if task.continuity == "edge" else 0.0
    first = value + radial * shear - led * alpha * slope
    other = alpha * slope + turning * (couple + shear * b / 2)
    right = radial * task.load - uniform, turning * moment
    determinant = first[0] * other[1] - first[1] * other[0]
    a = (right[0] * other[1] - first[1] * right[1]) / determinant
    c = (first[0] * right[1] - right[0] * other[0]) / determinant
    waves = a * np.array(_free(span)[0]) + c * np.array(_free(span)[1])
    return Shell(alpha, stiffness, area, inertia, moment, uniform, span, waves)


def _free(span: Any) -> tuple[list[Any], list[Any]]:
    """The waves (4,) with A = 1 and with B = 1 that leave the far end free: there d2w/dx2 = d3w/dx3 = 0."""
    if span is None:
        return [1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]
    left, c, s = np.exp(-span), np.cos(span), np.sin(span)
    return [1.0, 0.0, left * (c - 2 * s), left * s], [0.0, 1.0, left * (2 * c + s), -left * c]


def _shape(waves: Values, xi: Any, span: Any) -> tuple[Any, Any, Any, Any]:
    """e^-xi (A cos xi + B sin xi) + e^-eta (C cos eta + G sin eta), eta = span - xi, with three derivatives by xi."""
    a, b, c, g = waves
    left, cos, sin = np.exp(-xi), np.cos(xi), np.sin(xi)
    found = (
        left * (a * cos + b * sin),
        left * ((b - a) * cos - (a + b) * sin),
        2 * left * (a * sin - b * cos),
        2 * left * ((a + b) * cos + (b - a) * sin),
    )
    if span is None:
        return found
    eta = span - xi
    left, cos, sin = np.exp(-eta), np.cos(eta), np.sin(eta)
    back = (
        left * (c * cos + g * sin),
        left * ((c - g) * cos + (c + g) * sin),
        2 * left * (c * sin - g * cos),
        -2 * left * ((c + g) * cos + (g - c) * sin),
    )
    value, slope, second, third = (one + other for one, other in zip(found, back, strict=True))
    return value, slope, second, third


def waves_at(shell: Shell, x: Values) -> tuple[tuple[Values, Values], tuple[Values, Values]]:
    """The waves p [m] from the ring and from the far end at the places x (n,), each with s, minus half its second
    derivative by alpha x."""
    a, b, c, g = shell.waves
    xi, nothing = shell.alpha * x, 0.0 * shell.alpha
    near, _, bent, _ = _shape(np.array([a, b, nothing, nothing]), xi, None)
    if shell.span is None:
        return (near, -bent / 2), (nothing * xi, nothing * xi)
    far, _, far_bent, _ = _shape(np.array([nothing, nothing, c, g]), xi, shell.span)
    return (near, -bent / 2), (far, -far_bent / 2)


def along(task: LinerTask, shell: Shell, x: Values) -> dict[str, Values]:
    """Deflection, slope, moment, force and stresses (n,) at the places x (n,), in the numbers of the task."""
    value, slope, second, third = _shape(shell.waves, shell.alpha * x, shell.span)
    w = value + shell.uniform
    bend = shell.stiffness * shell.alpha**2 * second
    axial, hoop = 6 * bend / task.thickness**2, task.young * w / task.radius
    inside, outside = hoop + task.poisson * axial, hoop - task.poisson * axial
    return {
        "w": w,
        "slope": shell.alpha * slope,
        "bend": bend,
        "shear": shell.stiffness * shell.alpha**3 * third,
        "axial": axial,
        "outer_axial": -axial,
        "hoop": hoop,
        "inner_hoop": inside,
        "outer_hoop": outside,
        "inner": _mises(axial, inside),
        "outer": _mises(-axial, outside),
    }


def _mises(one: Values, other: Values) -> Values:
    """Equivalent stress (n,) of two principal stresses (n,)."""
    return np.asarray(np.sqrt(one**2 - one * other + other**2))


def _centre(task: LinerTask, shell: Shell, force: float) -> float:
    """u of the ring [m]."""
    return float((task.load - force) * task.radius**2 / (task.young * shell.area))


def _other(task: LinerTask) -> tuple[float, float]:
    """Q0 [N/m] and M0 [N] by the other continuity."""
    other = replace(task, continuity="centre" if task.continuity == "edge" else "edge")
    at = along(other, shell_of(other), np.zeros(1))
    return float(at["shear"][0]), -float(at["bend"][0])


def _peak(task: LinerTask, shell: Shell, length: float, names: tuple[str, str] = ("inner", "outer")) -> Peak:
    """The largest of a stress at the inner and the outer surface, and its place."""
    reach = min(float(shell.alpha) * length, FADED)
    x = np.linspace(0.0, reach / float(shell.alpha), 1 + DENSE * max(1, ceil(reach)))
    found = []
    for surface, name in zip(("inner", "outer"), names, strict=True):

        def stress_at(place: Values, _: Indices, name: str = name) -> Values:
            return along(task, shell, place)[name]

        values = along(task, shell, x)[name]
        at = np.flatnonzero(maxima(values, False))
        places, heights = refine(stress_at, *around(x, at, False))
        found += [(float(height), float(place), surface) for place, height in zip(places, heights, strict=True)]
        found += [(float(values[end]), float(x[end]), surface) for end in (0, -1)]
    stress, place, surface = max(found, key=lambda each: each[0])
    return Peak(place, stress, surface)


def _notes(task: LinerTask, shell: Shell, largest: Peak) -> list[Said]:
    found: list[Said] = []
    if task.thickness > THIN * task.radius:
        text = (
            "h/r1 = {value:.3g} is above {limit:g}: a thick wall, of which the theory of thin shells is no more than "
            "an estimate"
        )
        found.append(held("warning", text, task.thickness / task.radius, THIN, name="h/r1"))
    if shell.span is not None and shell.span < LONG:
        long = shell_of(replace(task, length=None))
        at = along(task, long, np.zeros(1))
        found.append(
            Phrase(
                "note: alpha L = {span:.4g}: the free end is felt at the ring; the source's formulas, which are "
                "for a long liner, give Q0 = {shear:.7g} N/m, M0 = {bend:.7g} N*m/m",
                span=float(shell.span),
                shear=float(at["shear"][0]),
                bend=-float(at["bend"][0]),
            )
        )
    if task.allowed is not None and largest.stress > task.allowed:
        text = "the equivalent stress of {value:.6g} MPa is above the allowed {limit:.6g} MPa"
        found.append(held("warning", text, largest.stress, task.allowed, "Pa", shown="MPa", name="sigma_eq"))
    return found


def _errors(task: LinerTask, shell: Shell, x: Values) -> LinerError:
    """Some of the rows and both ends again in extended precision."""
    wide = widened(task)
    exact_shell = shell_of(wide)
    rows = x[spread(len(x), LOOKED)]
    found, exact = along(task, shell, rows), along(wide, exact_shell, rows.astype(np.longdouble))
    return LinerError(
        forces=max(apart(found[name][:1], exact[name][:1]) for name in ("shear", "bend")),
        deflection=apart(found["w"], exact["w"]),
        moment=apart(found["bend"], exact["bend"]),
        stress=max(apart(found[name], exact[name]) for name in ("inner", "outer")),
    )
