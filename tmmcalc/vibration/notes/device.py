"""Mass, stiffness and damping of the device with numbers, its natural frequencies and modes put into the equations."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.report.formula.digits import Given, significant
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Display, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.telling import column_of, lines, named
from tmmcalc.vibration.vibrator.results import VibratorResult
from tmmcalc.vibration.vibrator.task import UNITS, VibratorTask

COUNT = 7
SHOWN = 2  # modes that are put into the equations
DIGITS = 4  # of the elements of a matrix
NOTHING = 1e-12  # of the diagonal: an element so small is none
MASSES = (
    "M_11 = m_1 + m_2 + m_3",
    "M_13 = -m_3*R_0/sqrt(2)",
    "M_23 = m_3*R_0/sqrt(2)",
    "M_15 = -m_2*l",
    "M_24 = m_2*l",
    "M_17 = -m_3*R^{*}*sin(beta)/sqrt(2)",
    "M_33 = J_z1 + J_ζ + J_z3 + m_3*R_0**2",
    "M_44 = J_ξ + m_2*l**2",
    "M_55 = J_η + m_2*l**2",
    "M_66 = m_2",
    "M_77 = J_x3 + m_3*(R^{*})**2",
)
STIFFNESSES = ("C_11 = 4*c", "C_33 = 4*c*R_2**2", "C_44 = c_t", "C_66 = 4*c_1", "C_77 = c_2")


def device(task: VibratorTask, result: VibratorResult) -> Lexicon:
    """Bodies, springs, and the elements of the matrices."""
    ring, gripper, exciter, springs = task.ring, task.gripper, task.exciter, result.springs
    inertia = "kg*m^2"
    found = {
        "m_1": Given(ring.mass, "kg", tr("mass of the ring")),
        "m_2": Given(gripper.mass, "kg", tr("mass of the gripper with the part")),
        "m_3": Given(exciter.mass, "kg", tr("mass of the exciter")),
        "l": Given(gripper.drop, "m", tr("distance of its centre of mass below the flat springs")),
        "R_0": Given(exciter.radius, "m", tr("distance of the exciter's centre of mass from the vertical axis")),
        "R^{*}": Given(exciter.arm, "m", tr("distance of the exciter's centre of mass from the hinge")),
        "beta": Given(math.degrees(exciter.arm_angle), "deg", tr("angle of this arm above the horizontal")),
        "J_z1": Given(ring.inertia, inertia, tr("moment of inertia of the ring about the vertical")),
        "J_z3": Given(exciter.inertia_z, inertia, tr("moment of inertia of the exciter about the vertical")),
        "J_x3": Given(exciter.inertia_hinge, inertia, tr("moment of inertia of the exciter along the hinge")),
        "J_ξ": Given(gripper.inertia_x, inertia, tr("moment of inertia of the gripper")),
        "J_η": Given(gripper.inertia_y, inertia, tr("moment of inertia of the gripper")),
        "J_ζ": Given(gripper.inertia_z, inertia, tr("moment of inertia of the gripper")),
        "c": Given(springs.rod, "N/m", tr("stiffness across one rod")),
        "c_1": Given(springs.vertical, "N/m", tr("vertical stiffness of one flat spring")),
        "c_2": Given(springs.plate, "N*m/rad", tr("stiffness of the plate against a turn")),
        "c_t": Given(springs.tilt, "N*m/rad", tr("stiffness of the flat springs against a tilt")),
        "R_2": Given(task.rods.radius, "m", tr("distance of the rods' ends from the vertical axis")),
    }
    for k in range(COUNT):
        for j in range(COUNT):
            turns = (UNITS[k] == "rad") + (UNITS[j] == "rad")
            mass, stiff = (("kg", "N/m"), ("kg*m", "N/rad"), ("kg*m^2", "N*m/rad"))[turns]
            found[f"M_{k + 1}{j + 1}"] = Given(_clean(result.mass, k, j), mass)
            found[f"C_{k + 1}{j + 1}"] = Given(_clean(result.stiffness, k, j), stiff)
    return named(found)


def _clean(matrix: Values, k: int, j: int) -> float:
    """An element; what is rounding beside the diagonal is none."""
    value = float(matrix[k, j])
    return 0.0 if abs(value) <= NOTHING * math.sqrt(abs(matrix[k, k] * matrix[j, j])) else value


def matrices(task: VibratorTask, result: VibratorResult, known: Lexicon) -> Iterator[Block]:
    """Elements in letters and in numbers, then the matrices as tables."""
    yield Heading(tr("Mass, stiffness and damping matrices"), 2)
    yield Paragraph(
        tr(
            "Small vibrations are described by Lagrange's equations $M*q'' + B*q' + C*q = P$ in matrices; the elements "
            "$M_{kj}$ follow from the kinetic energy of the bodies, the elements $C_{kj}$ from the potential energy of "
            "the springs:"
        )
    )
    place = [Place("", dict(known))]
    yield from lines(MASSES, place)
    yield Paragraph(tr("Further $M_22 = M_11$, $M_27 = M_17$, the matrix is symmetrical, all other elements are zero."))
    yield from lines(STIFFNESSES, place)
    yield Paragraph(
        tr(
            "Further $C_22 = C_11$, $C_55 = C_44$; the stiffness matrix is diagonal. Table {tab:vibrator_mass} has "
            "both matrices."
        )
    )
    cleaned = np.array([[_clean(result.mass, k, j) for j in range(COUNT)] for k in range(COUNT)])
    yield square(
        tr("Mass matrix $M$ (kg, kg·m, kg·m²) with the diagonal of $C$ (N/m, N·m/rad)"),
        cleaned,
        "M",
        "vibrator_mass",
        {"$C_{kk}$": np.diagonal(result.stiffness)},
    )
    if any(task.damping.direct):
        yield Paragraph(tr("The damping matrix has the given coefficients on its diagonal, $B_{kk} = b_k$."))
        return
    if not task.damping.ratio:
        yield Paragraph(tr("The device has no damping."))
        return
    yield Paragraph(
        tr(
            "Every mode has the same part $zeta$ of critical damping if $B = 2*zeta*S$, where the symmetric matrix "
            "$S$ is such that $S*M^{-1}*S = C$; it is in table {table}.",
            table="{tab:vibrator_damping}",
        )
    )
    damping = np.array([[_clean(result.damping, k, j) for j in range(COUNT)] for k in range(COUNT)])
    yield square(tr("Damping matrix $B$ (N·s/m, N·s, N·m·s)"), damping, "B", "vibrator_damping")


def square(caption: str, matrix: Values, letter: str, key: str, more: dict[str, Values] | None = None) -> Table:
    """A matrix as a table, zeros as such."""
    columns = [list(map(cell, row.tolist())) for row in matrix.T]
    heads = [f"{j + 1}" for j in range(len(matrix))]
    beside = {name: list(map(cell, values.tolist())) for name, values in (more or {}).items()}
    labels = [f"${letter}_{{{k + 1}j}}$" for k in range(len(matrix))]
    return Table(caption, ("$k$", *heads, *beside), tuple(zip(labels, *columns, *beside.values(), strict=True)), key)


def modes(task: VibratorTask, result: VibratorResult, known: Lexicon) -> Iterator[Block]:
    """Frequencies and shapes as tables, two modes put into the equations."""
    yield Heading(tr("Natural frequencies and modes"), 2)
    yield Paragraph(tr("Free vibrations without damping $q = u*sin(omega*t)$ satisfy"))
    yield Display(read("(C - omega**2*M)*u = 0"), "vibrator_free")
    yield Paragraph(
        tr(
            "This eigenvalue problem has the seven natural frequencies of table {table}; there $f = omega/(2*pi)$, "
            "$n = 60*f$, and $zeta$ is the part of critical damping. The amplitudes $u_k$ of the modes are in table "
            "{shapes}, the largest displacement being 1, where a turn counts by what it moves at the radius $R_2$.",
            table="{tab:vibrator_frequencies}",
            shapes="{tab:vibrator_shapes}",
        )
    )
    labels = [str(k + 1) for k in range(COUNT)]
    columns = {
        f"$omega$, {tr_unit('rad/s')}": column_of(result.frequency),
        f"$f$, {tr_unit('Hz')}": column_of(result.hertz),
        f"$n$, {tr_unit('rpm')}": column_of(result.speeds),
        "$zeta$": column_of(result.ratio),
    }
    rows = tuple(zip(labels, *columns.values(), strict=True))
    yield Table(tr("Natural frequencies"), (tr("Mode"), *columns), rows, "vibrator_frequencies")
    shapes = result.shapes
    heads = [f"$u_{k + 1}$" for k in range(COUNT)]
    table = tuple(zip(labels, *(map(cell, row.tolist()) for row in shapes), strict=True))
    yield Table(tr("Amplitudes of the modes"), (tr("Mode"), *heads), table, "vibrator_shapes")
    yield from _satisfied(result, known)
    if any(task.damping.direct):
        yield Paragraph(tr("The dampers give each mode a part of critical damping:"))
        places = [_mode(result, known, k, task.damping.direct) for k in range(COUNT)]
        yield from lines(["zeta = omega*sum(b_i*u_i**2, i)/(2*sum(C_i*u_i**2, i))"], places)
    lowest = Given(float(result.hertz[0]), "Hz", tr("lowest natural frequency"))
    yield Result("f_1", lowest)


def cell(value: float) -> str:
    """A number of a table whose numbers differ much in size."""
    return f"${significant(value, DIGITS)}$"


def _satisfied(result: VibratorResult, known: Lexicon) -> Iterator[Block]:
    """The modes next to the speed, without one the lowest and another, put into the equations."""
    chosen = shown_modes(result)
    yield Paragraph(tr("The found modes satisfy the equations $C_{kk}*u_k/omega**2 = sum(M_{kj}*u_j, j)$:"))
    places = [_mode(result, known, k, ()) for k in chosen]
    for k in range(COUNT):
        terms = " + ".join(f"M_{k + 1}{j + 1}*u_{j + 1}" for j in range(COUNT))
        yield from lines([f"C_{k + 1}{k + 1}*u_{k + 1}/omega**2 = {terms}"], places)


def shown_modes(result: VibratorResult) -> list[int]:
    """The modes about the speed of the rotor; without one the first and the third."""
    if result.steady is None:
        return [0, 2]
    near = np.argsort(np.abs(result.frequency - result.steady.speed))[:SHOWN]
    return sorted(near.tolist())


def _mode(result: VibratorResult, known: Lexicon, k: int, dampers: Sequence[float]) -> Place:
    shape = result.shapes[:, k].tolist()
    found: dict[str, Given] = {
        "omega": Given(float(result.frequency[k]), "rad/s", tr("natural frequency")),
        **{f"u_{j + 1}": Given(value, "" if UNITS[j] == "m" else "rad/m") for j, value in enumerate(shape)},
    }
    if dampers:
        found |= {
            "zeta": Given(float(result.ratio[k]), "", tr("part of critical damping of the mode")),
            "b_i": Given(list(dampers), "", tr("damping coefficients of the coordinates")),
            "u_i": Given(shape, "", tr("amplitudes of the mode")),
            "C_i": Given(np.diagonal(result.stiffness).tolist(), "", tr("diagonal of the stiffness matrix")),
        }
    return Place(tr("in mode {number}", number=k + 1), {**known, **named(found)})
