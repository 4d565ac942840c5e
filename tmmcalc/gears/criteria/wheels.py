"""Masses and moments of inertia of the wheels (textbook 4.43, 4.44).

A pinion is a solid cylinder of its reference diameter; a wheel is of the typical webbed shape, lighter by alpha1 and
with its mass farther out by alpha2. Tooth gaps, shafts and the carrier are neglected; wheels that stand still are not
counted. In the layouts of the textbook 1, 2' and 3' are pinions and 2, 3, 4 wheels; the planet of AIbar is a wheel.

Extensions: planets inside a ring with no sun beside them (2 of II, 2' of II and AII) are pinions, being the smaller of
their pairs; a ring that turns (1 of II, 4 of AII) is a cylinder ring from its reference circle outward by ``rim``
modules; both planets of 2A-AA are wheels, and planet 3, which reaches both planes of meshing, is twice as wide.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.model import ToothSets, Values
from tmmcalc.gears.scheme import Shape


@record
class Build:
    """How wheels are built."""

    density: float = 7820.0  # [kg/m^3] steel (textbook 4.6)
    webbed_mass: float = 0.434  # alpha1: mass of a wheel over that of the solid cylinder
    webbed_inertia: float = 1.21  # alpha2: its radius of inertia squared over that of the solid cylinder
    rim: float = 3.75  # [module] depth of a ring behind its reference circle: tooth root and rim


@record
class Wheels:
    """Single wheels of n trains; zeros for those that stand still."""

    masses: Values  # [kg] (n, wheels)
    inertias: Values  # [kg*m^2] about their own axes (n, wheels)
    numbers: Values  # how many of each there are (wheels,)

    @property
    def mass(self) -> Values:
        """Mass [kg] of all moving wheels (n,)."""
        return self.total(self.masses)

    def total(self, single: Values) -> Values:
        """Sum (n,) of a quantity of single wheels (n, wheels) over all, alike for like trains to the last bit."""
        amount = np.zeros(len(single), single.dtype)
        for column, number in zip(single.T, self.numbers, strict=True):
            amount += number * column
        return amount


def stage_of(sets: ToothSets, wheel: str) -> int:
    """The stage whose module and width a wheel has."""
    return next(mesh.stage for mesh in sets.scheme.meshes if wheel in (mesh.first, mesh.second))


def radii(sets: ToothSets, module: Values) -> Values:
    """Reference radii [m] (n, wheels) for modules [m] (n, stages)."""
    stages = [stage_of(sets, wheel) for wheel in sets.scheme.wheels]
    reference: Values = sets.teeth * module[:, stages] / 2
    return reference


def wheels(sets: ToothSets, module: Values, width: Values, build: Build | None = None) -> Wheels:
    """Masses and own inertias of all wheels; ``module`` and ``width`` [m] are (n, stages) (textbook 4.43, 4.44).

    >>> sun = ToothSets("AIbar", np.array([[18, 48, 114]]), np.ones((1, 1), int), np.full((1, 2), 0.349), planets=3)
    >>> round(float(wheels(sun, np.array([[0.0025]]), np.array([[0.025]])).mass[0]), 4)
    3.1897
    """
    build = Build() if build is None else build
    scheme = sets.scheme
    masses, inertias = np.zeros((2, *sets.teeth.shape), module.dtype)
    reference = radii(sets, module)
    for wheel, part in scheme.moving.items():
        column, stage = scheme.index(wheel), stage_of(sets, wheel)
        thickness = width[:, stage] * part.widths
        outer = build.rim * module[:, stage]
        masses[:, column], inertias[:, column] = _body(part.shape, reference[:, column], thickness, outer, build)
    numbers = np.array([sets.planets if wheel in scheme.planets else 1.0 for wheel in scheme.wheels])
    return Wheels(masses, inertias, numbers)


def _body(shape: Shape, r: Values, b: Values, rim: Values, build: Build) -> tuple[Values, Values]:
    """Mass and inertia (n,) of a wheel of radius ``r`` and width ``b``."""
    solid = np.pi * build.density * b * r**2
    if shape == "pinion":
        return solid, solid * r**2 / 2
    if shape == "wheel":
        mass = build.webbed_mass * solid
        return mass, build.webbed_inertia * mass * r**2 / 2
    mass = np.pi * build.density * b * rim * (2 * r + rim)
    return mass, mass * (r**2 + (r + rim) ** 2) / 2
