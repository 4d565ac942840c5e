"""The chapter on the vibratory device: its data, stiffnesses, matrices and modes, steady vibration, starts."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import RESULT, Given, significant
from tmmcalc.report.language import tr, tr_number, tr_unit
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Paragraph, Place, Table
from tmmcalc.report.telling import data_table, lines, named, pictured
from tmmcalc.vibration.notes.device import device, matrices, modes
from tmmcalc.vibration.notes.forced import forced
from tmmcalc.vibration.notes.given import whole
from tmmcalc.vibration.notes.starts import driven, given_angle
from tmmcalc.vibration.pictures.vibrator import pieces_of
from tmmcalc.vibration.tables.tasks.vibration import to_vibrator
from tmmcalc.vibration.vibrator.results import VibratorResult
from tmmcalc.vibration.vibrator.springs import torsion_coefficient
from tmmcalc.vibration.vibrator.task import VibratorTask


def blocks(order: Order) -> Iterator[Block]:
    """The device as a calculation by hand finds it."""
    task, result = to_vibrator(order.spec), order.results["vibrator"]
    pieces = pieces_of(result)
    known = device(task, result)
    yield Heading(tr("The device and its data"), 2)
    yield from _given(task)
    yield Heading(tr("Stiffnesses of the springs"), 2)
    yield from _springs(task, result)
    yield from matrices(task, result, known)
    yield from modes(task, result, known)
    yield Paragraph(
        tr(
            "Figure {fig:vibrator_modes} shows the modes: a bar is the amplitude of its coordinate, that of a turn is "
            "the displacement at the radius $R_2$."
        )
    )
    yield pictured(pieces["modes"], key="vibrator_modes")
    if result.steady is not None:
        yield from forced(task, result, known)
        if "paths" in pieces:
            yield Paragraph(
                tr(
                    "Figure {fig:vibrator_paths} shows the ellipses of the points in space and from above; a diamond "
                    "is where a point is at $psi = 0$."
                )
            )
            yield pictured(pieces["paths"], key="vibrator_paths")
    if result.curve is not None:
        yield from _curve(result)
        yield pictured(pieces["curve"], key="vibrator_curve")
    if result.run_up is not None and task.run_up is not None:
        yield from given_angle(task, result.run_up)
        yield _started("{fig:vibrator_start}")
        yield pictured(pieces["start"], key="vibrator_start")
    if result.drive is not None and task.drive is not None:
        yield from driven(task, result, result.drive)
        yield _started("{fig:vibrator_drive}")
        yield pictured(pieces["drive"], key="vibrator_drive")


def _started(figure: str) -> Paragraph:
    """What the picture of a start shows."""
    return Paragraph(
        tr(
            "Figure {figure} shows over the time the speed of the rotor, with the natural frequencies by their numbers "
            "as dash-dotted lines, the displacements and the turns.",
            figure=figure,
        )
    )


def data(order: Order) -> Iterator[Block]:
    """The device, its bodies and springs, its starts, the points of the part."""
    yield from whole(to_vibrator(order.spec))


def _given(task: VibratorTask) -> Iterator[Block]:
    """The coordinates, and what is given as a table."""
    told = list(whole(task))
    yield from (block for block in told if isinstance(block, Paragraph))
    yield Paragraph(tr("The given data are in table {table}.", table="{tab:vibrator_data}"))
    yield data_table(tr("Given data of the vibratory device"), told, "vibrator_data")


def _number(value: float) -> str:
    return f"${significant(value, RESULT)}$"


def _springs(task: VibratorTask, result: VibratorResult) -> Iterator[Block]:
    """Rods as beams clamped at both ends, flat springs bent and twisted."""
    springs, flats = result.springs, task.flats
    known = named(_spring_quantities(task, result))
    place = [Place("", known)]
    if task.rods.stiffness is None:
        yield Paragraph(tr("Across itself a rod is a round beam clamped at both ends:"))
        yield from lines(["c = 12*E_c/l_c**3*(pi*d_c**4/64)"], place)
    if flats.vertical is None:
        yield Paragraph(tr("A flat spring is a beam clamped at both ends:"))
        yield from lines(["c_1 = 12*E/l_1**3*(b*h**3/12)"], place)
    if springs.push is not None:
        yield Paragraph(
            tr(
                "When the gripper tilts, the inner end of two springs is pushed by $l_2*theta$ and turned by "
                "$theta$, the two others are twisted; the weight has the arm $l*theta$:"
            )
        )
        if flats.torsion is None:
            value = tr_number(significant(torsion_coefficient(flats.width, flats.thickness), RESULT))
            yield Paragraph(
                tr("The torsion of the rectangle by the series of Saint-Venant gives $alpha_t$ = {value}.", value=value)
            )
        yield from lines(
            [
                "a = E*b*h**3*(l_1/2 + l_2)/l_1**3",
                "d = E*b*h**3*(4*l_1 + 6*l_2)/(12*l_1**2)",
                "d_1 = G*alpha_t*b*h**3/l_1",
                "M_g = m_2*g*l",
                "c_t = 2*a*l_2 + 2*d + 2*d_1 + M_g",
            ],
            place,
        )
    if task.rods.stiffness is not None and flats.vertical is not None and springs.push is None:
        yield Paragraph(tr("The stiffnesses of rods and springs are given."))


def _spring_quantities(task: VibratorTask, result: VibratorResult) -> Lexicon:
    """Springs by their letters."""
    springs, flats, rods = result.springs, task.flats, task.rods
    found = {
        "c": Given(springs.rod, "N/m", tr("stiffness across one rod")),
        "E_c": Given(rods.young, "Pa", tr("modulus of elasticity of the rods")),
        "l_c": Given(rods.length, "m", tr("length of a rod")),
        "d_c": Given(rods.diameter, "m", tr("diameter of a rod")),
        "c_1": Given(springs.vertical, "N/m", tr("vertical stiffness of one flat spring")),
        "E": Given(flats.young, "Pa", tr("modulus of elasticity of the flat springs")),
        "G": Given(flats.shear, "Pa", tr("shear modulus")),
        "b": Given(flats.width, "m", tr("width of a flat spring")),
        "h": Given(flats.thickness, "m", tr("thickness of a flat spring")),
        "l_1": Given(flats.length, "m", tr("length of a flat spring")),
        "l_2": Given(flats.offset, "m", tr("distance of its inner end from the axis")),
        "m_2": Given(task.gripper.mass, "kg", tr("mass of the gripper with the part")),
        "g": Given(task.gravity, "m/s^2", tr("acceleration of free fall")),
        "l": Given(task.gripper.drop, "m", tr("distance of its centre of mass below the flat springs")),
        "c_t": Given(springs.tilt, "N*m/rad", tr("stiffness of the flat springs against a tilt")),
    }
    parts = {
        "a": (springs.push, "N/rad", tr("force of a bent spring over the tilt")),
        "d": (springs.bend, "N*m/rad", tr("moment at the inner end of a bent spring over the tilt")),
        "d_1": (springs.twist, "N*m/rad", tr("moment of a twisted spring over the tilt")),
        "M_g": (springs.weight, "N*m/rad", tr("moment of the weight over the tilt")),
    }
    found |= {key: Given(value, unit, said) for key, (value, unit, said) in parts.items() if value is not None}
    if springs.push is not None:
        alpha = flats.torsion if flats.torsion is not None else torsion_coefficient(flats.width, flats.thickness)
        found["alpha_t"] = Given(alpha, "", tr("torsion coefficient of the section"))
    return found


def _curve(result: VibratorResult) -> Iterator[Block]:
    """The largest amplitudes over the speed."""
    curve = result.curve
    assert curve is not None
    yield Heading(tr("Resonance curve"), 2)
    yield Paragraph(
        tr(
            "The same system, solved at {count} speeds, gives the resonance curve in figure {figure}; the largest "
            "amplitudes are in table {table}.",
            count=len(curve.omega),
            figure="{fig:vibrator_curve}",
            table="{tab:vibrator_peaks}",
        )
    )
    units = dict(zip(NAMES_OF, ("mm", "mm", "deg", "deg", "deg", "mm", "deg"), strict=True))
    rows = []
    for peak in curve.peaks:
        unit = units[peak.coordinate]
        factor = 1e3 if unit == "mm" else 180 / np.pi
        shown = "°" if unit == "deg" else f" {tr_unit(unit)}"
        amplitude, omega, rpm = (_number(v) for v in (factor * peak.amplitude, peak.speed, peak.speed * 30 / np.pi))
        rows.append((f"${NAMES_OF[peak.coordinate]}$", f"{amplitude}{shown}", omega, rpm))
    head = (tr("Coordinate"), tr("Amplitude"), f"$Omega$, {tr_unit('rad/s')}", f"$n$, {tr_unit('rpm')}")
    yield Table(tr("Largest amplitudes on the resonance curve"), head, tuple(rows), "vibrator_peaks")


NAMES_OF = {
    "x": "x",
    "y": "y",
    "phi": "phi",
    "tilt_x": "theta_x",
    "tilt_y": "theta_y",
    "z": "z",
    "gamma": "gamma",
}
