"""Whirl of the elastic rotor: the matrices of a few functions put into the equations, frequencies, critical speeds.

The functions are those of `tmmcalc.vibration.pendulum.basis` on one element: a straight tilt, and bends whose curvature
is a Legendre polynomial. Four of them show the method; the tables have the results of as many as the accuracy asks.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.report.formula.digits import RESULT, Given, significant
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_name, tr_number, tr_unit
from tmmcalc.report.manuscript import Block, Display, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.telling import column_of, lines, named
from tmmcalc.vibration.notes.device import square
from tmmcalc.vibration.notes.rotor import rotor, rpm
from tmmcalc.vibration.pendulum.basis import Basis
from tmmcalc.vibration.pendulum.energies import Matrices, matrices
from tmmcalc.vibration.pendulum.results import Campbell, PendulumResult
from tmmcalc.vibration.pendulum.task import PendulumTask
from tmmcalc.vibration.pendulum.whirl import critical_speeds, unbalance_whirl, whirl

FEW = 4  # functions that show the method
NOTHING = 1e-12  # of the diagonal: an element so small is none
SPEEDS = 12  # rows of the Campbell diagram


def whirling(task: PendulumTask, result: PendulumResult) -> Iterator[Block]:
    """The equations, a solution by few functions, and the frequencies."""
    yield Heading(tr("Natural frequencies and whirl"), 2)
    yield Paragraph(
        tr(
            "Bending, the weight of what hangs below, rotary inertia and the gyroscopic moments of rod and disc are "
            "counted; the tension of the rod at the depth $a$ is"
        )
    )
    yield Display(read("N = g*(rho*(l - a) + m)"))
    yield Paragraph(
        tr(
            "By Ritz's method the displacement is a sum of given functions of $a$ with the amplitudes $z_k$; "
            "energies of bending, weight and motion give the matrices $K$, $M$ and $G$. With $s = a/l$ the first "
            "function is the straight tilt $s$, the curvature of the others is 1, then a Legendre polynomial of "
            "growing degree. A whirl with the frequency $omega$ satisfies"
        )
        if task.pivot is not None
        else tr(
            "By Ritz's method the displacement is a sum of given functions of $a$ with the amplitudes $z_k$; "
            "energies of bending, weight and motion give the matrices $K$, $M$ and $G$. With $s = a/l$ the curvature "
            "of the functions is 1, then a Legendre polynomial of growing degree; at the clamped end they have "
            "neither displacement nor slope. A whirl with the frequency $omega$ satisfies"
        )
    )
    yield Display(read("(K - omega**2*M + omega*Omega*G)*z = 0" if task.spin else "(K - omega**2*M)*z = 0"))
    parts = few(task)
    made = _matrices(task, parts)
    first, last = (f"{{tab:pendulum_{letter}}}" for letter in (next(iter(made)), [*made][-1]))
    yield Paragraph(
        tr(
            "Tables {first}–{last} have the elements of the matrices by {count} functions.",
            first=first,
            last=last,
            count=FEW,
        )
    )
    for letter, matrix in made.items():
        yield square(_captions()[letter], matrix, letter, f"pendulum_{letter}")
    if task.pivot is not None:
        yield from _first(task, parts)
    yield from _satisfied(task, parts)
    yield from _frequencies(result)


def _captions() -> dict[str, str]:
    return {
        "K": tr("Stiffness matrix $K$ of few functions, N/m"),
        "M": tr("Mass matrix $M$ of few functions, kg"),
        "G": tr("Gyroscopic matrix $G$ of few functions, kg"),
    }


def few(task: PendulumTask) -> Matrices:
    """The matrices of the functions that show the method, of the plane xz."""
    tilts = task.pivot is not None
    return matrices(task, Basis((0.0, 1.0), FEW + 1 - tilts, tilts), 0)


def _matrices(task: PendulumTask, parts: Matrices) -> dict[str, Values]:
    """K, M and of a rotor that spins G; what is rounding beside the diagonal is none."""
    found = {"K": parts.stiffness, "M": parts.mass}
    if _spins(task):
        found["G"] = parts.spin
    return {letter: _cleaned(matrix) for letter, matrix in found.items()}


def _spins(task: PendulumTask) -> bool:
    return task.axisymmetric and (task.spin != 0 or task.speeds is not None)


def _cleaned(matrix: Values) -> Values:
    sizes = np.sqrt(np.abs(np.diagonal(matrix)))
    return np.where(np.abs(matrix) > NOTHING * np.outer(sizes, sizes), matrix, 0.0)


def _elements(task: PendulumTask, parts: Matrices) -> Lexicon:
    found = {}
    for letter, matrix in _matrices(task, parts).items():
        for k in range(FEW):
            for j in range(FEW):
                found[f"{letter}_{k + 1}{j + 1}"] = Given(float(matrix[k, j]), "N/m" if letter == "K" else "kg")
    return {**rotor(task), **named(found)}


def _first(task: PendulumTask, parts: Matrices) -> Iterator[Block]:
    """The elements of the straight tilt in closed form."""
    yield Paragraph(tr("The elements of the straight tilt in closed form:"))
    i, inertia = ("i", "J_d") if task.axisymmetric else ("i_x", "J_x")
    texts = [
        "K_11 = g*(rho*l/2 + m)/l + k/l**2",
        f"M_11 = rho*l/3 + rho*{i}**2/l + m + {inertia}/l**2",
        *(["G_11 = 2*rho*i**2/l + J_p/l**2"] if _spins(task) else []),
    ]
    yield from lines(texts, [Place("", _elements(task, parts))])


def _row(letter: str, k: int, factor: str = "", sign: str = "+") -> str:
    """One row of a matrix times the amplitudes, term by term, each with a factor."""
    return f" {sign} ".join(f"{factor}{letter}_{k + 1}{j + 1}*z_{j + 1}" for j in range(FEW))


def _satisfied(task: PendulumTask, parts: Matrices) -> Iterator[Block]:
    """The lowest whirl of each sense put into the equations."""
    pencil = whirl(parts, np.array(task.spin))
    chosen = [(tr("forward whirl"), -1), (tr("backward whirl"), 0)] if task.spin else [("", -1)]
    places = []
    for name, at in chosen:
        shape = pencil.y[:FEW, at]
        omega = Given(1 / float(pencil.mu[at]), "rad/s", tr("frequency of the whirl, below zero of the backward one"))
        if not task.spin:
            omega = omega._replace(meaning=tr("natural frequency"))
        places.append(Place(name, {**_elements(task, parts), "omega": omega, **_amplitudes(parts, shape)}))
    yield Paragraph(
        tr(
            "The lowest whirl of each sense, by these functions, with the displacement 1 of the lower end satisfies "
            "the equations (what bending and weight do stands on the left):"
        )
        if task.spin
        else tr(
            "The lowest mode, by these functions, with the displacement 1 of the lower end satisfies the equations "
            "(what bending and weight do stands on the left):"
        )
    )
    for k in range(FEW):
        gyroscopic = f" - {_row('G', k, 'omega*Omega*', '-')}" if task.spin else ""
        yield from lines([f"{_row('K', k)} = {_row('M', k, 'omega**2*')}{gyroscopic}"], places)


def _amplitudes(parts: Matrices, shape: Values) -> Lexicon:
    """The amplitudes with the displacement 1 of the lower end."""
    scaled = shape / float(parts.tip @ shape)
    return {f"z_{k + 1}": Given(float(value)) for k, value in enumerate(scaled)}


def _frequencies(result: PendulumResult) -> Iterator[Block]:
    """All frequencies that are asked for."""
    yield Paragraph(
        tr(
            "With {count} functions the frequencies no longer change; they are in table {table}, where $f = "
            "omega/(2*pi)$, $n = 60*f$.",
            count=result.functions,
            table="{tab:pendulum_frequencies}",
        )
    )
    rows = []
    for modes in result.modes:
        columns = (modes.frequency, modes.hertz, modes.speed)
        for k, numbers in enumerate(zip(*(values.tolist() for values in columns), strict=True)):
            cells = (f"${significant(number, RESULT)}$" for number in numbers)
            rows.append((tr_name(modes.name), str(k + 1), *cells, str(modes.nodes[k])))
    head = (
        tr("Whirl or plane"),
        tr("Mode"),
        f"$omega$, {tr_unit('rad/s')}",
        f"$f$, {tr_unit('Hz')}",
        f"$n$, {tr_unit('rpm')}",
        tr("Nodes"),
    )
    yield Table(tr("Natural frequencies"), head, tuple(rows), "pendulum_frequencies")
    for modes in result.modes:
        value = Given(float(modes.hertz[0]), "Hz", tr("lowest natural frequency"))
        yield Result("f_1", value, place=tr_name(modes.name))


def critical(task: PendulumTask, result: PendulumResult) -> Iterator[Block]:
    """The critical speeds, the first of each sense by few functions put into the equations."""
    if not len(result.forward_critical) and not len(result.backward_critical):
        return
    yield Heading(tr("Critical speeds"), 2)
    yield Paragraph(
        tr(
            "At a critical speed the rotor whirls with its own speed, forward $omega = Omega$ or backward $omega = "
            "-Omega$; the equations are then"
        )
    )
    yield Display(read("(K - Omega**2*(M - G))*z = 0"))
    yield Display(read("(K - Omega**2*(M + G))*z = 0"))
    yield from _critical_rows(task)
    rows = []
    for name, speeds in ((tr("forward"), result.forward_critical), (tr("backward"), result.backward_critical)):
        rows += [
            (name, str(k), *column_of([omega]), *column_of([omega * 30 / math.pi]))
            for k, omega in enumerate(speeds.tolist(), 1)
        ]
    head = (tr("Whirl"), tr("Number"), f"$Omega$, {tr_unit('rad/s')}", f"$n$, {tr_unit('rpm')}")
    yield Paragraph(
        tr(
            "All critical speeds, by {count} functions, are in table {table}.",
            count=result.functions,
            table="{tab:pendulum_critical}",
        )
    )
    yield Table(tr("Critical speeds"), head, tuple(rows), "pendulum_critical")
    if len(result.forward_critical):
        first = Given(float(result.forward_critical[0]), "rad/s", tr("first critical speed of forward whirl"))
        yield Result("Omega_1", first)
        if task.spin:
            near = result.forward_critical[np.argmin(np.abs(result.forward_critical - abs(task.spin)))]
            part = tr_number(significant(abs(task.spin) / float(near), 4))
            yield Paragraph(
                tr("The spin is {part} of the nearest one, {speed} rpm.", part=part, speed=rpm(float(near)))
            )


def _critical_rows(task: PendulumTask) -> Iterator[Block]:
    """The first critical speed of forward whirl by few functions, put into the equations."""
    parts = few(task)
    found = critical_speeds(parts, 1)[0]
    if not len(found.speeds):
        return
    said = Given(float(found.speeds[0]), "rad/s", tr("critical speed by few functions"))
    place = Place("", {**_elements(task, parts), "Omega": said, **_amplitudes(parts, found.shapes[:, 0])})
    yield Paragraph(tr("The first one of forward whirl by {count} functions:", count=FEW))
    for k in range(FEW):
        gyroscopic = _row("G", k, "Omega**2*", "-")
        yield from lines([f"{_row('K', k)} = {_row('M', k, 'Omega**2*')} - {gyroscopic}"], [place])


def campbell(found: Campbell) -> Iterator[Block]:
    """Frequencies over the speed of spin."""
    rows = np.unique(np.linspace(0, len(found.spin) - 1, SPEEDS + 1).round().astype(int))
    shown = min(found.modes, 3)
    columns = {f"$Omega$, {tr_unit('rad/s')}": column_of(found.spin[rows])}
    for letter, own in (("f", found.forward), ("b", found.backward)):
        for k in range(shown):
            columns[f"$omega_{{{letter}{k + 1}}}$, {tr_unit('rad/s')}"] = column_of(own[k][rows])
    yield Heading(tr("Campbell diagram"), 2)
    yield Paragraph(
        tr(
            "The frequencies of forward and of backward whirl, $omega_f$ and $omega_b$, over the speed of spin are "
            "in table {table} and figure {figure}; where the line of the spin cuts them, the speed is critical.",
            table="{tab:pendulum_campbell_rows}",
            figure="{fig:pendulum_campbell}",
        )
    )
    caption = tr("Frequencies of whirl over the speed of spin")
    yield Table(caption, tuple(columns), tuple(zip(*columns.values(), strict=True)), "pendulum_campbell_rows")


def unbalance(task: PendulumTask, result: PendulumResult) -> Iterator[Block]:
    """The whirl of the eccentric disc: the linear system by few functions, and the deflection."""
    assert result.deflection is not None
    parts = few(task)
    shape = unbalance_whirl(parts, task.disc.mass * task.disc.eccentricity, task.spin)
    yield Heading(tr("Whirl of the unbalance"), 2)
    yield Paragraph(
        tr(
            "The eccentric disc bends the rod, and the bent rod turns with the rotor. With the displacements $f_k$ "
            "of the lower end by the functions the amplitudes satisfy the linear system"
        )
    )
    yield Display(read("(K - Omega**2*(M - G))*z = m*e*Omega**2*f"))
    lexicon: Lexicon = {
        **_elements(task, parts),
        **{f"z_{k + 1}": Given(float(value), "m") for k, value in enumerate(shape)},
        **{f"f_{k + 1}": Given(float(value)) for k, value in enumerate(parts.tip)},
        "z_i": Given(shape.tolist(), "m", tr("amplitudes of the functions")),
        "f_i": Given(parts.tip.tolist(), "", tr("displacements of the lower end by the functions")),
        "delta": Given(float(parts.tip @ shape), "m", tr("displacement of the lower end by few functions")),
    }
    yield from _solved(parts, shape)
    place = [Place("", lexicon)]
    yield Paragraph(tr("The solution satisfies the equations:"))
    for k in range(FEW):
        inertia, gyroscopic = _row("M", k, "Omega**2*", "-"), _row("G", k, "Omega**2*")
        yield from lines([f"m*e*Omega**2*f_{k + 1} = {_row('K', k)} - {inertia} + {gyroscopic}"], place)
    yield from lines(["delta = sum(f_i*z_i, i)"], place)
    value = tr_number(significant(1e3 * abs(result.deflection), RESULT))
    yield Paragraph(
        tr("With {count} functions it is {value} mm, on the heavy side.", count=result.functions, value=value)
        if result.deflection > 0
        else tr(
            "With {count} functions it is {value} mm, on the light side: the rotor centres itself.",
            count=result.functions,
            value=value,
        )
    )
    yield Result("delta", Given(1e3 * abs(result.deflection), "mm", tr("whirl of the lower end by the unbalance")))


def _solved(parts: Matrices, shape: Values) -> Iterator[Block]:
    """The amplitudes that the system gives."""
    labels: Sequence[str] = [str(k + 1) for k in range(FEW)]
    columns = [[f"${significant(float(v), RESULT)}$" for v in values] for values in (parts.tip, shape)]
    head = ("$k$", "$f_k$", f"$z_k$, {tr_unit('m')}")
    yield Paragraph(tr("Table {tab:pendulum_unbalance} has its solution by {count} functions.", count=FEW))
    caption = tr("Amplitudes of the whirl of the unbalance")
    yield Table(caption, head, tuple(zip(labels, *columns, strict=True)), "pendulum_unbalance")
