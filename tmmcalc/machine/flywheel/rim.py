"""The rim of a flywheel: from a diameter to its section and mass, from a section to its diameter, and its stress.

             width b
            +-------+  ---          D = mean diameter, D_o = D + h outer, D_i = D - h inner
            |  rim  |   h           m = rho pi D h b
            +-------+  ---          J = m (D^2 + h^2) / 4 = m (D_o^2 + D_i^2) / 8, for a thin rim m D^2 / 4
               |arm
        -------+------- axis

Arms and hub give a part of the inertia and of the mass that depends on the drawing; `Proportions` says what is assumed.
"""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.flywheel.materials import CAST_IRON, Material

POISSON = 0.3


@record
class Proportions:
    """Proportions of the wheel where the user gives none."""

    width_to_thickness: float = 2.0  # b/h; customary 1 to 2.5
    thickness_to_diameter: float = 0.1  # h/D of a rim whose diameter is free
    rim_inertia: float = 0.9  # share of the rim in the inertia of the wheel; arms and hub give the rest
    rim_mass: float = 0.85  # share of the rim in the mass of the wheel; customary 0.85 to 0.9


DEFAULT = Proportions()


@record
class Rim:
    """A rim and what it is loaded with."""

    material: Material
    diameter: float = quantity("rim_mean_diameter[m]", "mean diameter of the rim", symbol="D")
    thickness: float = quantity("rim_thickness[m]", "radial thickness of the rim", symbol="h")
    width: float = quantity("rim_width[m]", "axial width of the rim", symbol="b")
    mass: float = quantity("rim_mass[kg]", "mass of the rim")
    total_mass: float = quantity("rim_total_mass[kg]", "mass of the flywheel with arms and hub")
    thin_mass: float = quantity("rim_thin_mass[kg]", "mass 4 J/D^2 of a thin rim that carries the whole inertia")
    inertia: float = quantity("rim_inertia[kg*m^2]", "inertia of the rim alone")
    speed: float = quantity("rim_speed[m/s]", "speed of the outer edge")
    stress: float = quantity("rim_stress[Pa]", "hoop stress rho v^2 of a thin ring at the mean diameter")
    peak_stress: float = quantity(
        "rim_peak_stress[Pa]", "hoop stress of the full ring at its inner edge, arms left out"
    )
    safety: float = quantity("rim_safety", "tensile strength over peak stress")
    allowed: bool = quantity("rim_allowed", "the outer edge keeps below the material's rim speed")

    @derived("rim_outer_diameter[m]", "outer diameter of the rim")
    def outer(self) -> float:
        """D + h."""
        return self.diameter + self.thickness

    @derived("rim_inner_diameter[m]", "inner diameter of the rim")
    def inner(self) -> float:
        """D - h."""
        return self.diameter - self.thickness


def largest_diameter(speed: float, material: Material = CAST_IRON) -> float:
    """Largest outer diameter [m] that the material allows at the shaft's largest speed [rad/s].

    >>> largest_diameter(60.0)
    1.0
    """
    return 2 * material.rim_speed / speed


def rim_of_mean_diameter(
    inertia: float, diameter: float, speed: float, material: Material = CAST_IRON, proportions: Proportions = DEFAULT
) -> Rim:
    """Rim of the mean ``diameter`` [m] for a flywheel of the given ``inertia`` [kg*m^2] at ``speed`` [rad/s].

    Raises `NoSolutionError` if the wheel would be full before it is heavy enough.
    """
    _check(inertia=inertia, diameter=diameter, speed=speed)
    c = _per_thickness(inertia, material, proportions) / diameter
    # h^2 (D^2 + h^2) = c, a quadratic for h^2 in the form that does not cancel
    thickness = math.sqrt(2 * c / (diameter**2 + math.sqrt(diameter**4 + 4 * c)))
    if thickness >= diameter:
        raise _full(inertia, diameter, "mean")
    return _rim(diameter, thickness, proportions.width_to_thickness * thickness, inertia, speed, material, proportions)


def rim_of_outer_diameter(
    inertia: float, outer: float, speed: float, material: Material = CAST_IRON, proportions: Proportions = DEFAULT
) -> Rim:
    """Rim of the ``outer`` diameter [m]: the lightest that a limit of the rim speed leaves.

    Raises `NoSolutionError` if a full disk of the same proportions is too light.
    """
    _check(inertia=inertia, outer=outer, speed=speed)
    c = _per_thickness(inertia, material, proportions)

    def missing(h: np.ndarray, _: np.ndarray) -> np.ndarray:
        return h * (outer**4 - (outer - 2 * h) ** 4) / 8 - c

    if missing(np.array(outer / 2), np.array(0)) < 0:
        raise _full(inertia, outer, "outer")
    thickness = float(bracketed(missing, np.zeros(1), np.array([outer / 2]))[0])
    width = proportions.width_to_thickness * thickness
    return _rim(outer - thickness, thickness, width, inertia, speed, material, proportions)


def rim_of_section(
    inertia: float,
    width: float,
    thickness: float,
    speed: float,
    material: Material = CAST_IRON,
    proportions: Proportions = DEFAULT,
) -> Rim:
    """Rim of the section ``width`` by ``thickness`` [m]: its diameter follows.

    D^3 + h^2 D = 4 J/(rho pi h b) has one positive root. Raises `NoSolutionError` if it leaves no hole.
    """
    _check(inertia=inertia, width=width, thickness=thickness, speed=speed)
    q = 4 * proportions.rim_inertia * inertia / (material.density * math.pi * thickness * width)
    diameter = _cubic(q, thickness)
    if diameter <= thickness:
        raise NoSolutionError(
            Phrase(
                "a section of {width:.4g} x {thickness:.4g} m is too heavy: it asks for a diameter of {diameter:.4g} m",
                width=width,
                thickness=thickness,
                diameter=diameter,
            ),
            where="flywheel rim",
            value=diameter,
            limit=thickness,
            remedy="a smaller section",
        )
    return _rim(diameter, thickness, width, inertia, speed, material, proportions)


def rim_of_diameter_and_width(
    inertia: float,
    diameter: float,
    width: float,
    speed: float,
    material: Material = CAST_IRON,
    proportions: Proportions = DEFAULT,
) -> Rim:
    """Rim of the mean ``diameter`` and the ``width`` [m]: its thickness follows.

    h^3 + D^2 h = 4 J/(rho pi D b) has one positive root. Raises `NoSolutionError` if it leaves no hole.
    """
    _check(inertia=inertia, diameter=diameter, width=width, speed=speed)
    thickness = _cubic(
        4 * proportions.rim_inertia * inertia / (material.density * math.pi * diameter * width), diameter
    )
    if thickness >= diameter:
        raise _full(inertia, diameter, "mean")
    return _rim(diameter, thickness, width, inertia, speed, material, proportions)


def rim_of_diameter_and_thickness(
    inertia: float,
    diameter: float,
    thickness: float,
    speed: float,
    material: Material = CAST_IRON,
    proportions: Proportions = DEFAULT,
) -> Rim:
    """Rim of the mean ``diameter`` and the ``thickness`` [m]: its width follows, b = 4 J/(rho pi D h (D^2 + h^2)).

    Raises `NoSolutionError` if the thickness leaves no hole.
    """
    _check(inertia=inertia, diameter=diameter, thickness=thickness, speed=speed)
    if thickness >= diameter:
        raise NoSolutionError(
            Phrase(
                "a rim {thickness:.4g} m thick leaves no hole in a mean diameter of {diameter:.4g} m",
                thickness=thickness,
                diameter=diameter,
            ),
            where="flywheel rim",
            value=thickness,
            limit=diameter,
            remedy="a thinner rim, or a larger diameter",
        )
    held = material.density * math.pi * diameter * thickness * (diameter**2 + thickness**2)
    width = 4 * proportions.rim_inertia * inertia / held
    return _rim(diameter, thickness, width, inertia, speed, material, proportions)


def _cubic(q: float, p: float) -> float:
    """The positive root of x^3 + p^2 x = q."""
    return 2 * p / math.sqrt(3) * math.sinh(math.asinh(1.5 * math.sqrt(3) * q / p**3) / 3)


def rim_of_proportions(
    inertia: float,
    speed: float,
    material: Material = CAST_IRON,
    proportions: Proportions = DEFAULT,
) -> Rim:
    """Rim of the default proportions, its outer diameter held below the material's limit."""
    _check(inertia=inertia, speed=speed)
    share = proportions.thickness_to_diameter
    free = (_per_thickness(inertia, material, proportions) / (share**2 * (1 + share**2))) ** 0.2
    limit = largest_diameter(speed, material)
    if free * (1 + share) > limit:
        return rim_of_outer_diameter(inertia, limit, speed, material, proportions)
    return rim_of_mean_diameter(inertia, free, speed, material, proportions)


def _per_thickness(inertia: float, material: Material, proportions: Proportions) -> float:
    """D h^2 (D^2 + h^2) [m^5] of a rim with the inertia that falls to it."""
    return 4 * proportions.rim_inertia * inertia / (material.density * math.pi * proportions.width_to_thickness)


def _rim(
    diameter: float,
    thickness: float,
    width: float,
    inertia: float,
    speed: float,
    material: Material,
    proportions: Proportions,
) -> Rim:
    mass = material.density * math.pi * diameter * thickness * width
    outer, inner = (diameter + thickness) / 2, (diameter - thickness) / 2
    edge = speed * outer
    peak = material.density * speed**2 / 4 * ((3 + POISSON) * outer**2 + (1 - POISSON) * inner**2)
    return Rim(
        material,
        diameter,
        thickness,
        width,
        mass,
        mass / proportions.rim_mass,
        4 * inertia / diameter**2,
        mass * (diameter**2 + thickness**2) / 4,
        edge,
        material.density * (speed * diameter / 2) ** 2,
        peak,
        material.strength / peak,
        edge <= material.rim_speed * (1 + 1e-12),
    )


def _full(inertia: float, diameter: float, which: str) -> NoSolutionError:
    return NoSolutionError(
        f"a wheel of {diameter:.4g} m {which} diameter is a full disk before it has {inertia:.5g} kg*m^2",
        where="flywheel rim",
        value=diameter,
        remedy="a larger diameter, a wider rim, a stronger material or a faster shaft",
    )


def _check(**sizes: float) -> None:
    for name, value in sizes.items():
        if not value > 0:
            raise UsageError(
                f"the {name} is {value:g}, it must be above zero", where="flywheel rim", value=value, limit=0.0
            )
