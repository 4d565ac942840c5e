"""The pendulum-rotor by its letters: what is given, and what rod and disc have by their sizes."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.report.formula.digits import RESULT, Given, significant
from tmmcalc.report.language import tr, tr_number, tr_unit
from tmmcalc.report.manuscript import Block, Lexicon, Paragraph, Place, Table
from tmmcalc.report.telling import lines, named
from tmmcalc.vibration.pendulum.task import PendulumTask
from tmmcalc.vibration.tables.pendulum import DiscTable, PendulumRodTable, PendulumTable
from tmmcalc.vibration.vibrator.springs import torsion_coefficient

Row = tuple[str, str, str, str]
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


def sections(task: PendulumTask, table: PendulumTable) -> Iterator[Block]:
    """The data as a table, then what follows from the sizes of rod and disc."""
    yield Paragraph(
        tr(
            "An elastic rod hangs from a spherical joint and carries a disc on its lower end; $a$ is counted down "
            "along the rod, $v$ and $w$ are its displacements along the horizontal axes $x$ and $y$. The given data "
            "are in table {table}.",
            table="{tab:pendulum_data}",
        )
        if task.pivot is not None
        else tr(
            "An elastic rod is clamped at its upper end and carries a disc on its lower end; $a$ is counted down "
            "along the rod, $v$ and $w$ are its displacements along the horizontal axes $x$ and $y$. The given data "
            "are in table {table}.",
            table="{tab:pendulum_data}",
        )
    )
    head = (tr("Quantity"), tr("Designation"), tr("Unit"), tr("Value"))
    rows = tuple(_rows(task, table))
    yield Table(tr("Given data of the pendulum-rotor"), head, rows, "pendulum_data")
    texts = [*_of_rod(task, table.rod), *_of_disc(task, table.disc)]
    if not texts:
        return
    lexicon = {**rotor(task), **_sizes(task, table)}
    yield Paragraph(tr("By the sizes of rod and disc"))
    yield from lines(texts, [Place("", lexicon)])


def _row(said: str, name: str, unit: str, value: float) -> Row:
    return said, f"${name}$" if name else "", tr_unit(unit), f"${significant(value, RESULT)}$"


def _rows(task: PendulumTask, table: PendulumTable) -> Iterator[Row]:
    rod, disc = table.rod, table.disc
    yield _row(tr("Length of the rod"), "l", "m", rod.length)
    if rod.diameter is not None:
        yield _row(tr("Outer diameter of the rod"), "d", "m", rod.diameter)
        if rod.bore:
            yield _row(tr("Inner diameter of the rod"), "d_0", "m", rod.bore)
    elif rod.width is not None and rod.thickness is not None:
        yield _row(tr("Side of the section along x"), "b", "m", rod.width)
        yield _row(tr("Side of the section along y"), "h", "m", rod.thickness)
    if rod.mass is not None:
        yield _row(tr("Mass of the rod"), "m_0", "kg", rod.mass)
    elif rod.diameter is not None or rod.width is not None:
        yield _row(tr("Density of the material"), "rho_m", "kg/m^3", rod.density)
    if rod.bending_stiffness is not None:
        yield from _pair(task, tr("Bending stiffness of the rod"), "B", "N*m^2", task.rod.bending)
    else:
        yield _row(tr("Modulus of elasticity"), "E", "Pa", rod.young)
    if rod.torsion_stiffness is not None:
        yield _row(tr("Torsional stiffness of the rod"), "C_p", "N*m^2", rod.torsion_stiffness)
    elif task.rod.torsion is not None:
        yield _row(tr("Shear modulus"), "G", "Pa", rod.shear_modulus)
    if rod.section_radius is not None:
        yield from _pair(task, tr("Radius of gyration of the section"), "i", "m", task.rod.radius)
    if disc is not None:
        yield from _disc_rows(task, disc)
    if task.pivot is not None:
        yield _row(tr("Stiffness of the joint"), "k", "N*m/rad", task.pivot)
    if task.spin:
        yield _row(tr("Speed of spin"), "Omega", "rad/s", task.spin)


def _disc_rows(task: PendulumTask, disc: DiscTable) -> Iterator[Row]:
    yield _row(tr("Mass of the disc"), "m", "kg", disc.mass)
    if disc.gyration is not None:
        pair = (disc.gyration[0], disc.gyration[-1])
        yield from _pair(task, tr("Radius of gyration of the disc about a diameter"), "r", "m", pair)
    else:
        yield from _pair(
            task, tr("Moment of inertia of the disc about a diameter"), "J_d", "kg*m^2", task.disc.diametral
        )
        if disc.polar_inertia is not None:
            yield _row(tr("Polar moment of inertia of the disc"), "J_p", "kg*m^2", disc.polar_inertia)
    if disc.eccentricity:
        yield _row(tr("Eccentricity of the disc"), "e", "m", disc.eccentricity)


def _pair(task: PendulumTask, said: str, name: str, unit: str, pair: tuple[float, float]) -> Iterator[Row]:
    """One value, or one for each plane."""
    if task.axisymmetric:
        yield _row(said, name, unit, pair[0])
        return
    for axis, value in zip(PLANES, pair, strict=True):
        yield _row(said, f"{name[0]}_{axis}", unit, value)


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
