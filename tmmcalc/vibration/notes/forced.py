"""The steady vibration under the unbalance: its forces, the linear system of the amplitudes, power, paths of points."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.report.formula.digits import Given, significant
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_number, tr_unit
from tmmcalc.report.manuscript import Block, Display, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.telling import column_of, lines, named
from tmmcalc.vibration.notes.device import COUNT, NOTHING, cell, square
from tmmcalc.vibration.vibrator.energies import excitation_of
from tmmcalc.vibration.vibrator.paths import STEPS, PointPath
from tmmcalc.vibration.vibrator.results import VibratorResult
from tmmcalc.vibration.vibrator.task import UNITS, VibratorTask

POINTS = 2  # whose paths are worked out by numbers
FORCES = (
    "P_1^c = m_r*Omega**2/2",
    "P_1^s = -m_r*Omega**2/sqrt(2)",
    "P_2^c = m_r*Omega**2/2",
    "P_2^s = m_r*Omega**2/sqrt(2)",
    "P_3^s = m_r*Omega**2*R",
    "P_7^c = m_r*Omega**2*R_u*(cos(delta) - sin(delta))/sqrt(2)",
)
MOVED = {  # amplitudes of a point of the part, of its cosine or its sine
    "x": "x_<p> = X_1^<p> + z*X_5^<p> - y*X_3^<p>",
    "y": "y_<p> = X_2^<p> + x*X_3^<p> - z*X_4^<p>",
    "z": "z_<p> = X_6^<p> + y*X_4^<p> - x*X_5^<p>",
}


def forced(task: VibratorTask, result: VibratorResult, known: Lexicon) -> Iterator[Block]:
    """Everything at the speed of the steady motion."""
    steady = result.steady
    assert steady is not None
    yield Heading(tr("Steady vibration"), 2)
    yield Paragraph(
        tr(
            "The unbalance turns with the angle $psi = Omega*t$. Its force does work on the displacements $x$, $y$, "
            "on the turns $phi$ and $gamma$; in every coordinate the force is $P_k = P_k^c*cos(psi) + "
            "P_k^s*sin(psi)$ with"
        )
    )
    lexicon = {**known, **_quantities(task, result)}
    place = [Place("", lexicon)]
    yield from lines(FORCES, place)
    yield Paragraph(
        tr(
            "The motion is sought as $q_k = X_k^c*cos(psi) + X_k^s*sin(psi)$. Substituted into the equations of "
            "motion it gives a linear system with 14 unknowns, which $D = C - Omega**2*M$ and $H = Omega*B$ make "
            "short:"
        )
    )
    yield Display(read("D*X^c + H*X^s = P^c"))
    yield Display(read("D*X^s - H*X^c = P^s"))
    stiff, damped = _dynamic(result)
    yield Paragraph(
        tr("The matrices $D$ and $H$ are in tables {tab:vibrator_dynamic} and {tab:vibrator_damped}.")
        if np.any(damped)
        else tr("The matrix $D$ is in table {tab:vibrator_dynamic}.")
    )
    yield square(tr("Matrix $D = C - Omega**2*M$ at the speed of the rotor"), stiff, "D", "vibrator_dynamic")
    if np.any(damped):
        yield square(tr("Matrix $H = Omega*B$ at the speed of the rotor"), damped, "H", "vibrator_damped")
    yield from _solution(result)
    yield Paragraph(tr("The solution satisfies the equations:"))
    yield from lines([_equation(k, "c", "s", "+") for k in range(COUNT)], place)
    yield from lines([_equation(k, "s", "c", "-") for k in range(COUNT)], place)
    yield from _amplitudes(result)
    yield from _power(result, lexicon)
    yield from _resonance(result)
    yield from _points(task, result)


def _dynamic(result: VibratorResult) -> tuple[Values, Values]:
    """D and H (7, 7); what is rounding beside the diagonals is none."""
    steady = result.steady
    assert steady is not None
    sizes = np.diagonal(result.stiffness) + steady.speed**2 * np.diagonal(result.mass)
    stiff, damped = result.stiffness - steady.speed**2 * result.mass, steady.speed * result.damping
    return _cleaned(stiff, sizes), _cleaned(damped, np.diagonal(damped))


def _cleaned(matrix: Values, sizes: Values) -> Values:
    """A matrix (7, 7) without what is rounding beside the sizes (7,) of its diagonal."""
    found: Values = np.where(np.abs(matrix) > NOTHING * np.sqrt(np.outer(sizes, sizes)), matrix, 0.0)
    return found


def _quantities(task: VibratorTask, result: VibratorResult) -> Lexicon:
    """Forces, amplitudes and the elements of D and H."""
    steady, unbalance = result.steady, task.unbalance
    assert steady is not None
    assert unbalance is not None
    force = excitation_of(unbalance).amplitude(np.array([steady.speed]))[0]
    found = {
        "m_r": Given(unbalance.moment, "kg*m", tr("static moment of the unbalance")),
        "Omega": Given(steady.speed, "rad/s", tr("speed of the rotor")),
        "R": Given(unbalance.radius, "m", tr("distance of the centre of its path from the vertical axis")),
        "R_u": Given(unbalance.arm, "m", tr("distance of the centre of its path from the hinge")),
        "delta": Given(math.degrees(unbalance.arm_angle), "deg", tr("angle of that arm above the horizontal")),
        "N": Given(steady.power, "W", tr("mean power that the dampers take")),
        "M_v": Given(steady.moment, "N*m", tr("mean moment that the vibration takes")),
    }
    stiff, damped = _dynamic(result)
    for k in range(COUNT):
        unit, moved = ("N", "m") if UNITS[k] == "m" else ("N*m", "rad")
        forces = (float(force[k].real), float(-force[k].imag))
        amplitudes = (float(steady.cosine[k]), float(steady.sine[k]))
        for letter, value, size in zip("cs", forces, amplitudes, strict=True):
            found[f"P_{k + 1}^{letter}"] = Given(value, unit)
            found[f"X_{k + 1}^{letter}"] = Given(size, moved)
        for j in range(COUNT):
            found[f"D_{k + 1}{j + 1}"] = Given(float(stiff[k, j]), "")
            found[f"H_{k + 1}{j + 1}"] = Given(float(damped[k, j]), "")
    return named(found)


def _equation(k: int, own: str, other: str, sign: str) -> str:
    """One equation of the system."""
    stiff = " + ".join(f"D_{k + 1}{j + 1}*X_{j + 1}^{own}" for j in range(COUNT))
    damped = "".join(f" {sign} H_{k + 1}{j + 1}*X_{j + 1}^{other}" for j in range(COUNT))
    return f"P_{k + 1}^{own} = {stiff}{damped}"


def _solution(result: VibratorResult) -> Iterator[Block]:
    """The amplitudes that the system gives."""
    steady = result.steady
    assert steady is not None
    yield Paragraph(tr("Its solution is in table {table}.", table="{tab:vibrator_steady}"))
    columns = []
    for values in (steady.cosine, steady.sine, steady.amplitude):
        columns.append(list(map(cell, values.tolist())))
    columns.append(column_of(np.degrees(steady.phase)))
    units = [tr_unit(unit) for unit in UNITS]
    head = ("$k$", tr("Unit"), "$X_k^c$", "$X_k^s$", "$A_k$", "$alpha_k$, °")
    labels = [str(k + 1) for k in range(COUNT)]
    rows = tuple(zip(labels, units, *columns, strict=True))
    yield Table(tr("Amplitudes of the steady vibration"), head, rows, "vibrator_steady")


def _amplitudes(result: VibratorResult) -> Iterator[Block]:
    """Amplitude and angle behind the unbalance of every coordinate that moves."""
    steady = result.steady
    assert steady is not None
    yield Paragraph(tr("Amplitude of each coordinate, and its angle behind the unbalance:"))
    for turns in (False, True):
        places = []
        for k in range(COUNT):
            if (UNITS[k] == "rad") != turns or not steady.amplitude[k]:
                continue
            unit = UNITS[k]
            own = named(
                {
                    "A_i": Given(float(steady.amplitude[k]), unit, tr("amplitude of coordinate $i$")),
                    "alpha_i": Given(
                        math.degrees(float(steady.phase[k])), "deg", tr("angle of coordinate $i$ behind the unbalance")
                    ),
                    "X_i^c": Given(float(steady.cosine[k]), unit),
                    "X_i^s": Given(float(steady.sine[k]), unit),
                }
            )
            places.append(Place("", own, str(k + 1)))
        if places:
            yield from lines(["A_i = sqrt((X_i^c)**2 + (X_i^s)**2)", "alpha_i = atan2(X_i^s, X_i^c)"], places)


def _power(result: VibratorResult, lexicon: Lexicon) -> Iterator[Block]:
    """The power of the unbalance, which the dampers take, and the moment of the rotor for it."""
    steady = result.steady
    assert steady is not None
    if not steady.power:
        return
    yield Paragraph(
        tr(
            "In a turn the rotor does by the unbalance the work that the dampers take; the mean moment and the power "
            "are"
        )
    )
    terms = " + ".join(f"P_{k + 1}^c*X_{k + 1}^s/2 - P_{k + 1}^s*X_{k + 1}^c/2" for k in range(COUNT))
    yield from lines([f"M_v = {terms}", "N = M_v*Omega"], [Place("", lexicon)])
    yield Result("N", lexicon["N"])


def _resonance(result: VibratorResult) -> Iterator[Block]:
    """How near the speed is to a natural frequency."""
    steady = result.steady
    assert steady is not None
    near = int(np.argmin(np.abs(result.frequency - steady.speed)))
    part = tr_number(significant(steady.speed / float(result.frequency[near]), 4))
    yield Paragraph(
        tr("The speed of the rotor is {part} of natural frequency {mode}, the nearest one.", part=part, mode=near + 1)
    )


def _points(task: VibratorTask, result: VibratorResult) -> Iterator[Block]:
    """The ellipses of the points of the part."""
    if not result.paths:
        return
    yield Heading(tr("Paths of points of the part"), 3)
    yield Paragraph(
        tr(
            "A point of the part with the coordinates $x$, $y$, $z$ at rest is moved by the displacement of the "
            "gripper and by its small turns. Each of its displacements is $x_c*cos(psi) + x_s*sin(psi)$, so the "
            "point describes an ellipse:"
        )
    )
    places = [_point(task, result, path) for path in result.paths[:POINTS]]
    for part in "cs":
        yield from lines([*MOVED.values()], places, {"p": part})
    yield from lines([f"A_{axis} = sqrt({axis}_c**2 + {axis}_s**2)" for axis in "xyz"], places)
    yield Paragraph(
        tr(
            "The normal $n$ of its plane is along the vector product of both amplitudes, whose length is the product "
            "of the semi-axes; the sum of their squares is that of the amplitudes:"
        )
    )
    products = {"x": "(y_c*z_s - z_c*y_s)", "y": "(z_c*x_s - x_c*z_s)", "z": "(x_c*y_s - y_c*x_s)"}
    round_ = [place for place, path in zip(places, result.paths, strict=False) if path.minor]
    if round_:
        yield from lines([f"n_{axis} = {product}/(a_e*b_e)" for axis, product in products.items()], round_)
        yield Display(read("n_x**2 + n_y**2 + n_z**2 = 1"))
    yield from lines(["a_e = sqrt(A_x**2 + A_y**2 + A_z**2 - b_e**2)"], places)
    columns = {
        f"$A_x$, {tr_unit('mm')}": [1e3 * path.amplitude[0] for path in result.paths],
        f"$A_y$, {tr_unit('mm')}": [1e3 * path.amplitude[1] for path in result.paths],
        f"$A_z$, {tr_unit('mm')}": [1e3 * path.amplitude[2] for path in result.paths],
        f"$a_e$, {tr_unit('mm')}": [1e3 * path.major for path in result.paths],
        f"$b_e$, {tr_unit('mm')}": [1e3 * path.minor for path in result.paths],
    }
    yield Paragraph(tr("The paths of all points are in table {table}.", table="{tab:vibrator_points}"))
    names = [path.name for path in result.paths]
    rows = tuple(zip(names, *map(column_of, columns.values()), strict=True))
    yield Table(tr("Paths of points of the part"), (tr("Point"), *columns), rows, "vibrator_points")


def _point(task: VibratorTask, result: VibratorResult, path: PointPath) -> Place:
    """A point with its place, its amplitudes and the semi-axes."""
    said, ellipse = tr("amplitudes of the displacements of the point"), tr("semi-axes of its ellipse")
    found = {
        **{
            axis: Given(float(v), "m", tr("coordinates of the point at rest"))
            for axis, v in zip("xyz", path.at, strict=True)
        },
        "a_e": Given(path.major, "m", ellipse),
        "b_e": Given(path.minor, "m", ellipse),
    }
    for k, axis in enumerate("xyz"):
        found[f"A_{axis}"] = Given(float(path.amplitude[k]), "m", tr("amplitudes of the point along the axes"))
        found[f"n_{axis}"] = Given(
            float(path.normal[k]), "", tr("projections of the normal of the plane of the ellipse")
        )
        found[f"{axis}_c"] = Given(float(path.path[0, k]), "m", said)
        found[f"{axis}_s"] = Given(float(path.path[STEPS // 4, k]), "m", said)
    return Place(tr("for point {name}", name=path.name), {**_quantities(task, result), **named(found)})
