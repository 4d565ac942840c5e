"""A group of class III or IV, or one with the drive inside: its loops closed by Newton's method, rates from a system.

The projections of the closure of every loop are equations in the angles of the links and the coordinates of sliders.
Their derivatives are linear in the rates, with one matrix for velocities and accelerations:

    sum_first - sum_second of [-(y_E - y_S) omega + v cos gamma] = B_x        and along y
    sum_first - sum_second of [-(y_E - y_S) eps + a cos gamma] = C_x
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Point, Real
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.instant import in_time
from tmmcalc.linkage.loops.closure import Loops, PlacedGroup
from tmmcalc.linkage.loops.step import LoopStep
from tmmcalc.linkage.notes import points
from tmmcalc.linkage.notes.group import along_guide, angle, guide_name, length, plain_name, point_quantities
from tmmcalc.linkage.notes.ways import (
    NOTHING,
    Arm,
    Loop,
    Slid,
    Spin,
    coordinate,
    degrees,
    direction,
    loops_of,
    pin_of,
    projection,
    spins_of,
)
from tmmcalc.linkage.pins import find_pins
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.formula.digits import Given, significant
from tmmcalc.report.language import tr, tr_number, tr_unit
from tmmcalc.report.manuscript import Lexicon, Table
from tmmcalc.report.telling import column_of, named, vector

AXES = "xy"
PASSES = 12  # of Newton in the table
CLOSE = 1e-8  # of the longest vector: the residual of its last line
NEARER = 20  # halvings of the way to the start of Newton


class System(NamedTuple):
    """The equations of a group at one position: matrix (2 L, N), and the solutions in time."""

    matrix: Real
    rates: Real  # (N,) the unknown velocities
    rates2: Real  # and accelerations

    def found(self, letter: str) -> Real:
        """The solution, of the system of velocities ``B`` or of accelerations ``C``."""
        return self.rates if letter == "B" else self.rates2

    def right(self, letter: str) -> Real:
        """The right sides (2 L,): those along x, then those along y."""
        return self.matrix @ self.found(letter)


class Looped(NamedTuple):
    """A group at the positions."""

    step: LoopStep
    loops: tuple[Loop, ...]
    unknowns: tuple[Spin | Slid, ...]  # in the order of the columns
    systems: tuple[System, ...]
    iterations: tuple[Iteration, ...]
    carried: list[points.Carried]

    @property
    def arms(self) -> list[Arm]:
        """The vectors of all loops, each once."""
        ways = (way for loop in self.loops for way in (loop.first, loop.second))
        return list({(arm.start, arm.end, arm.spin.angle): arm for way in ways for arm in way.arms}.values())


class Iteration(NamedTuple):
    """Newton's method at one position: where it starts, the unknowns (steps, N) and the largest residual of each."""

    start: float  # input coordinate counted from position 0 [rad or m]
    unknowns: Real
    residuals: Real  # (steps,) [m]


def system_of(chain: Chain, step: LoopStep, result: Kinematics, row: int) -> System:
    """The system that the program solves, in time."""
    configuration = chain.evaluate(result.x[[row]])
    number = chain.steps.index(step)
    loops: Loops = configuration.ports[number]
    placed: PlacedGroup = configuration.placed[number]
    q1, q2 = loops.rates(placed)
    return System(placed.jacobian[..., 0], *result.in_time(q1[:, 0], q2[:, 0]))


def iteration_of(chain: Chain, step: LoopStep, result: Kinematics, row: int) -> Iteration:
    """Newton from the group at the position before, or from so near to this one that it comes to the same assembly."""
    number, x = chain.steps.index(step), float(result.x[row])
    before = x - float(result.x[1] - result.x[0])
    goal: PlacedGroup = chain.evaluate(np.array([x])).placed[number]
    loops: Loops = chain.evaluate(np.array([x]), order=0).ports[number]
    for _ in range(NEARER):
        with np.errstate(invalid="ignore"):
            start: PlacedGroup = chain.evaluate(np.array([before]), order=0).placed[number]
        found = _stepped(loops, start.q) if np.isfinite(start.q).all() else None
        if found is not None and np.allclose(np.exp(1j * found[0][-1]), np.exp(1j * goal.q[:, 0]), atol=1e-9):
            break
        before = (before + x) / 2
    assert found is not None
    return Iteration(before - float(result.x[0]), np.array(found[0]), np.array(found[1]))


def _stepped(loops: Loops, q: Real) -> tuple[list[Real], list[float]]:
    """Unknowns and largest residuals of the steps until the loops are closed."""
    size, longest = loops.size, float(np.max(np.abs(loops.equations.classes), initial=0.0))
    unknowns, residuals = list[Real](), list[float]()
    for _ in range(PASSES):
        placed = loops.place(q)
        unknowns.append(q[:, 0])
        residuals.append(float(np.max(np.abs([placed.residual.real, placed.residual.imag]))))
        if residuals[-1] < CLOSE * longest or not math.isfinite(residuals[-1]):
            break
        q, _ = loops.corrected(placed, size)
    return unknowns, residuals


def looped_of(
    chain: Chain,
    step: LoopStep,
    result: Kinematics,
    rows: Sequence[int],
    known: set[str],
    lexicons: Sequence[Lexicon],
) -> Looped:
    """The group with its quantities in the lexicons, and the points of its links that are not ``known``."""
    loops = loops_of(chain, step.group)
    looped = Looped(
        step,
        loops,
        tuple(_unknowns(chain, step)),
        tuple(system_of(chain, step, result, row) for row in rows),
        tuple(iteration_of(chain, step, result, row) for row in rows),
        [],
    )
    for lexicon, row, system in zip(lexicons, rows, looped.systems, strict=True):
        lexicon |= named(vector_quantities(chain, result, row, looped.arms))
        lexicon |= named(_right_sides(system))
    known |= {arm.end for arm in looped.arms}
    for carrier in _carriers(chain, looped, known):
        looped.carried.extend(points.gathered(chain, carrier, known, lexicons))
    return looped


def _unknowns(chain: Chain, step: LoopStep) -> Iterator[Spin | Slid]:
    """What the columns of the matrix belong to: links that turn, then joints that slide."""
    equations = step.equations
    spins = spins_of(chain, step.group)
    for c in range(equations.classes.shape[1]):
        yield next(spins[k][0] for k in step.group.links if (own := equations.turnings[k]).of == c and not own.known)
    for j in equations.free:
        yield Slid(chain.mechanism.joint(equations.rails[j].joint), 1, 0.0)


def vector_quantities(chain: Chain, result: Kinematics, row: int, arms: Sequence[Arm]) -> Lexicon:
    """Vectors with their angles, the points of guides from which they start, the rates along them."""
    configuration = chain.evaluate(result.x[[row]])
    found: Lexicon = {}
    for arm in arms:
        found |= _guide_point(chain, configuration, result, arm)
        found |= _vector_quantities(configuration, arm)
        for slid in arm.slid:
            found |= _slide_quantities(configuration, result, arm, slid)
    return found


def _guide_point(chain: Chain, configuration: Configuration, result: Kinematics, arm: Arm) -> Lexicon:
    """The point of a guide of the source chain, where a vector starts from one."""
    pins = find_pins(chain.mechanism)
    if pin_of(pins, arm.start) is not None:
        return {}
    joint = next(slid.joint for slid in arm.slid if guide_name(pins, slid.joint) == arm.start)
    side = joint.links.index(arm.spin.link)
    state = in_time(configuration.motions[arm.spin.link], result)
    place = state.r + state.arm(joint.points[side])
    there = Point(np.array(place), *map(np.array, state.point(joint.points[side])))
    return point_quantities(arm.start, arm.start, there)


def _vector_quantities(configuration: Configuration, arm: Arm) -> Lexicon:
    """The length of the constant part and its angle; the angle of the links."""
    spin = arm.spin
    own, line = spin.line
    said = tr("angle of the guide of link {link}", link=own) if spin.known else tr("angle of link {link}", link=own)
    found = {spin.angle: angle(complex(np.ravel(configuration.motions[own].u)[0]) * line, said)}
    if abs(arm.fixed) > NOTHING:
        ends = {"first": arm.start, "second": arm.end}
        letter, told = (
            ("h", tr("constant part of the vector {first}{second}", **ends))
            if arm.slid
            else ("l", tr("distance between points {first} and {second}", **ends))
        )
        between = tr("angle between the line {first}{second} and link {link}", link=own, **ends)
        found[f"{letter}_{{{arm.ends}}}"] = length(abs(arm.fixed), told)
        found[f"alpha_{{{arm.ends}}}"] = Given(degrees(arm.fixed), "deg", between)
    return found


def _slide_quantities(configuration: Configuration, result: Kinematics, arm: Arm, slid: Slid) -> Lexicon:
    slide = configuration.slides[slid.joint.name]
    rate, rate2 = (float(np.ravel(each)[0]) for each in result.in_time(slide.ds, slide.dds))
    slider, guide = map(str, slid.joint.links)
    return {
        **along_guide(slider, guide, slider, float(np.ravel(slide.s)[0]), rate, rate2),
        f"delta_{slider}": Given(
            math.degrees(slid.delta), "deg", tr("angle between the lines of link {link}", link=arm.spin.line[0])
        ),
    }


def _right_sides(system: System) -> Lexicon:
    """The right sides of the equations."""
    count = len(system.matrix) // 2
    found: Lexicon = {}
    for letter, unit in (("B", "m/s"), ("C", "m/s^2")):
        values = system.right(letter)
        for k in range(count):
            told = (
                tr("right sides of the equations for the velocities")
                if letter == "B"
                else tr("right sides of the equations for the accelerations")
            )
            found |= vector(f"{letter}_{{{k + 1}%}}", complex(values[k], values[count + k]), unit, told)
    return found


def _carriers(chain: Chain, looped: Looped, known: set[str]) -> Iterator[points.Carrier]:
    """The links of the group, each from a point of it that is known."""
    outer = set(looped.step.group.outer)
    pins = sorted(find_pins(chain.mechanism), key=lambda pin: not outer & set(pin.joints))  # where lines begin first
    for link, (spin, line) in spins_of(chain, looped.step.group).items():
        own = next((pin for pin in pins if link in pin.at and plain_name(pin.name) in known), None)
        if own is not None:
            yield points.Carrier(link, plain_name(own.name), own.at[link], spin.angle, line, spin.link)


def unknown_names(looped: Looped, kind: str) -> list[str]:
    """The names of the unknowns: of the ``position``, or of the system of a rate, ``velocity`` or ``acceleration``."""
    turning, sliding = {"position": ("", "s"), "velocity": ("omega", "v"), "acceleration": ("eps", "a")}[kind]
    names = []
    for each in looped.unknowns:
        if isinstance(each, Spin):
            names.append(f"{turning}_{each.link}" if turning else each.angle)
        else:
            names.append(coordinate(each) if kind == "position" else f"{sliding}_{{{each.pair}}}")
    return names


def reached(looped: Looped) -> list[Arm]:
    """The vectors that lead to every point of the group, the first one to each."""
    return list({arm.end: arm for arm in reversed(looped.arms)}.values())[::-1]


def newton(result: Kinematics, rows: Sequence[int], looped: Looped) -> Iterator[Table]:
    """The steps of Newton's method at each position: the unknowns and the largest residual of the equations."""
    names = unknown_names(looped, "position")
    turned = [isinstance(each, Spin) for each in looped.unknowns]
    heads = [f"${name}$, {tr_unit('deg' if turns else 'm')}" for name, turns in zip(names, turned, strict=True)]
    for row, (start, unknowns, residuals) in zip(rows, looped.iterations, strict=True):
        columns = [column_of(values) for values in _as_told(looped, unknowns)]
        sizes = [f"${significant(residual, 2)}$" for residual in residuals]
        began = f"$phi$ = {math.degrees(start):.4g}°" if result.turns else f"$Deltas$ = {start:.4g} {tr_unit('m')}"
        yield Table(
            tr("Newton's method in position {label}, from {start}", label=result.labels[row], start=tr_number(began)),
            (tr("Step"), *heads, f"{tr('Residual')}, {tr_unit('m')}"),
            tuple(zip(map(str, range(len(sizes))), *columns, sizes, strict=True)),
            _key(looped, "newton", row),
        )


def _key(looped: Looped, kind: str, row: int) -> str:
    """The key of a table of a group at a position."""
    return "_".join(["group", *map(str, looped.step.group.links), kind, str(row)])


def _as_told(looped: Looped, unknowns: Real) -> Iterator[Real]:
    """The columns of unknowns: angles [deg] of the lines of links, in place of their axes, and coordinates."""
    turnings = looped.step.equations.turnings
    for each, values in zip(looped.unknowns, unknowns.T, strict=True):
        if isinstance(each, Spin):
            own, line = each.line
            yield np.degrees(values) + degrees(turnings[own].turn * line)
        else:
            yield values


def systems(result: Kinematics, rows: Sequence[int], looped: Looped, letter: str) -> Iterator[Table]:
    """The matrix with the right sides at each position, and the solution below."""
    names = unknown_names(looped, "velocity" if letter == "B" else "acceleration")
    count = len(looped.loops)
    order = [k + count * axis for k in range(count) for axis in (0, 1)]
    heads = [f"${letter}_{{{k + 1}{axis}}}$" for k in range(count) for axis in AXES]
    for row, system in zip(rows, looped.systems, strict=True):
        right, found = system.right(letter), system.found(letter)
        columns = [[*column_of(part[order]), *column_of([x])] for part, x in zip(system.matrix.T, found, strict=True)]
        yield Table(
            tr("Coefficients of the system and its solution in position {label}", label=result.labels[row]),
            (tr("Equation"), *(f"${name}$" for name in names), tr("Right side")),
            tuple(zip((*heads, tr("Solution")), *columns, [*column_of(right[order]), ""], strict=True)),
            _key(looped, letter, row),
        )


def closures(looped: Looped) -> Iterator[str]:
    """The closure of every loop as a vector equation."""
    for loop in looped.loops:
        yield " = ".join(
            " + ".join([f"vec(r_{{{way.start}}})", *(f"vec(l_{{{arm.ends}}})" for arm in way.arms)])
            for way in (loop.first, loop.second)
        )


def places(looped: Looped) -> Iterator[str]:
    """The coordinates of the end of every vector from those of its start."""
    for arm in looped.arms:
        yield from places_of(arm)


def places_of(arm: Arm) -> Iterator[str]:
    """The coordinates of the end of a vector from those of its start."""
    for axis, function in zip(AXES, ("cos", "sin"), strict=True):
        yield f"{axis}_{{{arm.end}}} = {axis}_{{{arm.start}}}{''.join(projection(arm, function))}"


def right_sides(looped: Looped, letter: str) -> Iterator[str]:
    """The right sides: what is known of the velocities (``B``), or of the accelerations (``C``)."""
    terms = _known_velocities if letter == "B" else _known_accelerations
    rate = "v" if letter == "B" else "a"
    for k, loop in enumerate(looped.loops):
        for axis in AXES:
            parts = [f"{rate}_{{{loop.second.start}{axis}}} - {rate}_{{{loop.first.start}{axis}}}"]
            for way, sense in ((loop.first, -1), (loop.second, 1)):
                parts += [term for arm in way.arms for term in terms(looped, arm, axis, sense)]
            yield f"{letter}_{{{k + 1}{axis}}} = {' '.join(parts)}"


def equations(looped: Looped, letter: str) -> Iterator[str]:
    """The equations of the system: their right side as the sum of the terms with what is unknown."""
    for k, loop in enumerate(looped.loops):
        for axis in AXES:
            parts = [
                term
                for way, sense in ((loop.first, 1), (loop.second, -1))
                for arm in way.arms
                for term in _unknown(looped, arm, axis, sense, "v" if letter == "B" else "a")
            ]
            yield f"{letter}_{{{k + 1}{axis}}} = {' '.join(parts).removeprefix('+ ')}"


def rates_of(arm: Arm) -> tuple[list[str], list[str]]:
    """Velocity and acceleration of the end of a vector from those of its start."""
    velocities, accelerations = [], []
    for axis in AXES:
        slides = [_slide(arm, slid, axis, 1, "v") for slid in arm.slid]
        turned = _turned(arm, axis, 1, f"omega_{arm.spin.link}")
        velocities.append(f"v_{{{arm.end}{axis}}} = v_{{{arm.start}{axis}}} {' '.join([turned, *slides])}")
        slides = [_slide(arm, slid, axis, 1, "a") for slid in arm.slid]
        slides += [_coriolis(arm, slid, axis, 1) for slid in arm.slid]
        parts = [_turned(arm, axis, 1, f"eps_{arm.spin.link}"), _normal(arm, axis, 1), *slides]
        accelerations.append(f"a_{{{arm.end}{axis}}} = a_{{{arm.start}{axis}}} {' '.join(parts)}")
    return velocities, accelerations


def _known_velocities(looped: Looped, arm: Arm, axis: str, sense: int) -> Iterator[str]:
    if arm.spin.known:
        yield _turned(arm, axis, sense, f"omega_{arm.spin.link}")
    for slid in arm.slid:
        if slid.joint.name == looped.step.group.drive:
            yield _slide(arm, slid, axis, sense, "v")


def _known_accelerations(looped: Looped, arm: Arm, axis: str, sense: int) -> Iterator[str]:
    if arm.spin.known:
        yield _turned(arm, axis, sense, f"eps_{arm.spin.link}")
    yield _normal(arm, axis, sense)
    for slid in arm.slid:
        yield _coriolis(arm, slid, axis, sense)
        if slid.joint.name == looped.step.group.drive:
            yield _slide(arm, slid, axis, sense, "a")


def _unknown(looped: Looped, arm: Arm, axis: str, sense: int, rate: str) -> Iterator[str]:
    if not arm.spin.known:
        yield _turned(arm, axis, sense, f"{'omega' if rate == 'v' else 'eps'}_{arm.spin.link}")
    for slid in arm.slid:
        if slid.joint.name != looped.step.group.drive:
            yield _slide(arm, slid, axis, sense, rate)


def _turned(arm: Arm, axis: str, sense: int, rate: str) -> str:
    """The part of the end's motion about the start by a rate of turning."""
    other, sign = ("y", -sense) if axis == "x" else ("x", sense)
    return f"{_sign(sign)} {rate}*({other}_{{{arm.end}}} - {other}_{{{arm.start}}})"


def _normal(arm: Arm, axis: str, sense: int) -> str:
    return f"{_sign(-sense)} omega_{arm.spin.link}**2*({axis}_{{{arm.end}}} - {axis}_{{{arm.start}}})"


def _slide(arm: Arm, slid: Slid, axis: str, sense: int, rate: str) -> str:
    function = "cos" if axis == "x" else "sin"
    return f"{_sign(sense * slid.sign)} {rate}_{{{slid.pair}}}*{function}({direction(arm, slid)})"


def _coriolis(arm: Arm, slid: Slid, axis: str, sense: int) -> str:
    function, sign = ("sin", -sense) if axis == "x" else ("cos", sense)
    turned = f"2*omega_{arm.spin.link}*v_{{{slid.pair}}}*{function}({direction(arm, slid)})"
    return f"{_sign(sign * slid.sign)} {turned}"


def _sign(sense: int) -> str:
    return "+" if sense > 0 else "-"
