"""The pendulum-rotor by its letters: what is given, and what rod and disc have by their sizes."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.report.formula.digits import RESULT, Given, significant
from tmmcalc.report.language import tr, tr_number
from tmmcalc.report.manuscript import Block, Datum, Lexicon, Paragraph, Place
from tmmcalc.report.telling import data_table, lines, named
from tmmcalc.vibration.pendulum.task import PendulumTask, Swing
from tmmcalc.vibration.tables.pendulum import DiscTable, PendulumRodTable, PendulumTable
from tmmcalc.vibration.vibrator.springs import torsion_coefficient

PLANES = ("x", "y")


def rotor(task: PendulumTask) -> Lexicon:
    """Rod, disc, joint and spin; of two different planes the quantities of each have its axis as index."""
    rod, disc = task.rod, task.disc
    found = {
        "l": Given(rod.length, "m", tr("length of the rod")),
        "rho": Given(rod.density, "kg/m", tr("mass of a metre of the rod")),
        "g": Given(task.gravity, "m/s^2", tr("acceleration of free fall")),
        "m": Given(disc.mass, "kg", tr("mass of the disc")),
        "e": Given(disc.eccentricity, "m", tr("eccentricity of the disc")),
        "J_p": Given(disc.polar, "kg*m^2", tr("polar moment of inertia of the disc")),
        "k": Given(task.pivot or 0.0, "N*m/rad", tr("stiffness of the joint")),
        "Omega": Given(task.spin, "rad/s", tr("speed of spin")),
    }
    each = {
        "B": (rod.bending, "N*m^2", tr("bending stiffness of the rod")),
        "i": (rod.radius, "m", tr("radius of gyration of the section")),
        "J_d": (disc.diametral, "kg*m^2", tr("moment of inertia of the disc about a diameter")),
    }
    for name, (pair, unit, said) in each.items():
        if task.axisymmetric:
            found[name] = Given(pair[0], unit, said)
            continue
        for axis, value in zip(PLANES, pair, strict=True):
            base = name[0] if name == "J_d" else name
            found[f"{base}_{axis}"] = Given(value, unit, said)
    return named(found)


def whole(task: PendulumTask, table: PendulumTable) -> Iterator[Block]:
    """All that is given, with the speeds and the motion in time that are asked for."""
    yield _hangs(task)
    yield from _rows(task, table)
    yield Datum(tr("Number of natural frequencies that are sought"), (), (float(task.modes),))
    if task.speeds is not None:
        said = tr("Speeds of spin between which the frequencies are sought")
        yield Datum(said, ("Omega",), (task.speeds.low, task.speeds.high), "rad/s")
    if task.swing is not None:
        yield from _swing(task.swing, heavy=bool(task.disc.eccentricity))


def _swing(asked: Swing, *, heavy: bool) -> Iterator[Block]:
    """How the motion in time begins, and how the joint moves."""
    if heavy:
        yield Paragraph(tr("At the beginning of the motion in time the heavy side of the disc is towards $x$."))
    yield Datum(tr("Time of the motion"), ("t_e",), (asked.duration,), "s")
    said = tr("Tilt of the straight rod towards $x$ at the beginning")
    yield Datum(said, ("theta_0",), (math.degrees(asked.tilt),), "deg")
    if asked.deflection:
        said = tr("Displacement of the lower end along $x$ by a force that bends the rod and lets go")
        yield Datum(said, ("v_d",), (asked.deflection,), "m")
    if asked.push:
        said = tr("Speed of the lower end along $y$ at the beginning, in the shape of the displacements")
        yield Datum(said, ("w'",), (asked.push,), "m/s")
    if asked.times:
        said = tr("Times of the speeds of the upper end, between which they change evenly; the last one is kept")
        yield Datum(said, ("t_i",), asked.times, "s")
        for said, name, speeds in (
            (tr("Speeds of the upper end along $x$ at these times"), "u_x", asked.x),
            (tr("Speeds of the upper end along $y$ at these times"), "u_y", asked.y),
            (tr("Speeds of the upper end upwards at these times"), "u_z", asked.up),
        ):
            if speeds:
                yield Datum(said, (name,), speeds, "m/s")


def _hangs(task: PendulumTask) -> Paragraph:
    return Paragraph(
        tr(
            "An elastic rod hangs from a spherical joint and carries a disc on its lower end; $a$ is counted down "
            "along the rod, $v$ and $w$ are its displacements along the horizontal axes $x$ and $y$."
        )
        if task.pivot is not None
        else tr(
            "An elastic rod is clamped at its upper end and carries a disc on its lower end; $a$ is counted down "
            "along the rod, $v$ and $w$ are its displacements along the horizontal axes $x$ and $y$."
        )
    )


def sections(task: PendulumTask, table: PendulumTable) -> Iterator[Block]:
    """The data as a table, then what follows from the sizes of rod and disc."""
    table_ = tr("The given data are in table {table}.", table="{tab:pendulum_data}")
    yield Paragraph(f"{_hangs(task).text} {table_}")
    yield data_table(tr("Given data of the pendulum-rotor"), _rows(task, table), "pendulum_data")
    texts = [*_of_rod(task, table.rod), *_of_disc(task, table.disc)]
    if not texts:
        return
    lexicon = {**rotor(task), **_sizes(task, table)}
    yield Paragraph(tr("By the sizes of rod and disc"))
    yield from lines(texts, [Place("", lexicon)])


def _rows(task: PendulumTask, table: PendulumTable) -> Iterator[Datum]:
    rod, disc = table.rod, table.disc
    yield Datum(tr("Length of the rod"), ("l",), (rod.length,), "m")
    if rod.diameter is not None:
        yield Datum(tr("Outer diameter of the rod"), ("d",), (rod.diameter,), "m")
        if rod.bore:
            yield Datum(tr("Inner diameter of the rod"), ("d_0",), (rod.bore,), "m")
    elif rod.width is not None and rod.thickness is not None:
        yield Datum(tr("Side of the section along x"), ("b",), (rod.width,), "m")
        yield Datum(tr("Side of the section along y"), ("h",), (rod.thickness,), "m")
    if rod.mass is not None:
        yield Datum(tr("Mass of the rod"), ("m_0",), (rod.mass,), "kg")
    elif rod.diameter is not None or rod.width is not None:
        yield Datum(tr("Density of the material"), ("rho_m",), (rod.density,), "kg/m^3")
    if rod.bending_stiffness is not None:
        yield from _pair(task, tr("Bending stiffness of the rod"), "B", "N*m^2", task.rod.bending)
    else:
        yield Datum(tr("Modulus of elasticity"), ("E",), (rod.young,), "Pa")
    if rod.torsion_stiffness is not None:
        yield Datum(tr("Torsional stiffness of the rod"), ("C_p",), (rod.torsion_stiffness,), "N*m^2")
    elif task.rod.torsion is not None:
        yield Datum(tr("shear modulus"), ("G",), (rod.shear_modulus,), "Pa")
    if rod.section_radius is not None:
        yield from _pair(task, tr("Radius of gyration of the section"), "i", "m", task.rod.radius)
    if disc is not None:
        yield from _disc_rows(task, disc)
    if task.pivot is not None:
        yield Datum(tr("Stiffness of the joint"), ("k",), (task.pivot,), "N*m/rad")
    yield Datum(tr("acceleration of gravity"), ("g",), (task.gravity,), "m/s^2")
    if task.spin:
        yield Datum(tr("Speed of spin"), ("Omega",), (task.spin,), "rad/s")


def _disc_rows(task: PendulumTask, disc: DiscTable) -> Iterator[Datum]:
    yield Datum(tr("Mass of the disc"), ("m",), (disc.mass,), "kg")
    if disc.gyration is not None:
        pair = (disc.gyration[0], disc.gyration[-1])
        yield from _pair(task, tr("Radius of gyration of the disc about a diameter"), "r", "m", pair)
    else:
        yield from _pair(
            task, tr("Moment of inertia of the disc about a diameter"), "J_d", "kg*m^2", task.disc.diametral
        )
        if disc.polar_inertia is not None:
            yield Datum(tr("Polar moment of inertia of the disc"), ("J_p",), (disc.polar_inertia,), "kg*m^2")
    if disc.eccentricity:
        yield Datum(tr("Eccentricity of the disc"), ("e",), (disc.eccentricity,), "m")


def _pair(task: PendulumTask, said: str, name: str, unit: str, pair: tuple[float, float]) -> Iterator[Datum]:
    """One value, or one for each plane."""
    if task.axisymmetric:
        yield Datum(said, (name,), (pair[0],), unit)
        return
    for axis, value in zip(PLANES, pair, strict=True):
        yield Datum(said, (f"{name[0]}_{axis}",), (value,), unit)


def _sizes(task: PendulumTask, table: PendulumTable) -> Lexicon:
    """Sizes and materials by their letters."""
    rod, disc = table.rod, table.disc
    found = {
        "E": Given(rod.young, "Pa", tr("modulus of elasticity")),
        "G": Given(rod.shear_modulus, "Pa", tr("shear modulus")),
        "rho_m": Given(rod.density, "kg/m^3", tr("density of the material")),
        "d_0": Given(rod.bore, "m", tr("inner diameter of the rod")),
    }
    if rod.mass is not None:
        found["m_0"] = Given(rod.mass, "kg", tr("mass of the rod"))
    if rod.diameter is not None:
        found["d"] = Given(rod.diameter, "m", tr("outer diameter of the rod"))
    if rod.width is not None and rod.thickness is not None:
        found["b"] = Given(rod.width, "m", tr("sides of the section"))
        found["h"] = Given(rod.thickness, "m", tr("sides of the section"))
        coefficient = torsion_coefficient(rod.width, rod.thickness)
        found["alpha_t"] = Given(coefficient, "", tr("torsion coefficient of the section"))
    if task.rod.torsion is not None:
        found["C_p"] = Given(task.rod.torsion, "N*m^2", tr("torsional stiffness of the rod"))
    if disc is not None and disc.gyration is not None:
        said = tr("radius of gyration of the disc about a diameter")
        found["r"] = Given(disc.gyration[0], "m", said)
        for axis, value in zip(PLANES, (disc.gyration[0], disc.gyration[-1]), strict=True):
            found[f"r_{axis}"] = Given(value, "m", said)
    return named(found)


def _of_rod(task: PendulumTask, rod: PendulumRodTable) -> Iterator[str]:
    """Mass, stiffnesses and radius of the section, those that are not given."""
    round_, flat = rod.diameter is not None, rod.width is not None and rod.thickness is not None
    if rod.mass is not None:
        yield "rho = m_0/l"
    elif round_:
        yield "rho = rho_m*pi*(d**2 - d_0**2)/4"
    elif flat:
        yield "rho = rho_m*b*h"
    if rod.bending_stiffness is None:
        if round_:
            yield "B = E*pi*(d**4 - d_0**4)/64" if task.axisymmetric else "B_x = E*pi*(d**4 - d_0**4)/64"
            if not task.axisymmetric:
                yield "B_y = E*pi*(d**4 - d_0**4)/64"
        elif flat:
            yield from ("B = E*h*b**3/12",) if task.axisymmetric else ("B_x = E*h*b**3/12", "B_y = E*b*h**3/12")
    if rod.section_radius is None and round_:
        own = "sqrt(d**2 + d_0**2)/4" if rod.bore else "d/4"
        yield from (f"i = {own}",) if task.axisymmetric else (f"i_x = {own}", f"i_y = {own}")
    elif rod.section_radius is None and flat:
        yield from ("i = b/sqrt(12)",) if task.axisymmetric else ("i_x = b/sqrt(12)", "i_y = h/sqrt(12)")
    if rod.torsion_stiffness is None and task.rod.torsion is not None:
        yield "C_p = G*pi*(d**4 - d_0**4)/32" if round_ else "C_p = G*alpha_t*b*h**3"


def _of_disc(task: PendulumTask, disc: DiscTable | None) -> Iterator[str]:
    """Moments of inertia of a thin disc, those that are not given."""
    if disc is None:
        return
    if disc.gyration is not None:
        if task.axisymmetric:
            yield from ("J_d = m*r**2", "J_p = 2*J_d")
        else:
            yield from ("J_x = m*r_x**2", "J_y = m*r_y**2", "J_p = J_x + J_y")
    elif disc.polar_inertia is None and any(task.disc.diametral):
        yield "J_p = 2*J_d" if task.axisymmetric else "J_p = J_x + J_y"


def rpm(omega: float) -> str:
    """A speed in revolutions a minute."""
    return tr_number(significant(omega * 30 / math.pi, RESULT))
