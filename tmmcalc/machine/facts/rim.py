"""The facts of a rim, of a flywheel that is needed or of one that is there."""

from __future__ import annotations

from tmmcalc.core.quantity import keyed
from tmmcalc.machine.flywheel.rim import Rim
from tmmcalc.report.document import Fact
from tmmcalc.report.numbers import number


def rim_facts(rim: Rim, own: float) -> list[Fact]:
    """Sizes, inertia, mass, speed and stress of the rim of a flywheel with this inertia [kg*m^2]."""
    material = rim.material
    sizes = {"mean": rim.diameter, "outer": rim.outer, "inner": rim.inner}
    diameters = ", ".join(f"{word} {number(1e3 * value, 5)}" for word, value in sizes.items())
    section = {"width": rim.width, "thickness": rim.thickness}
    sections = ", ".join(f"{word} {number(1e3 * value, 5)} mm" for word, value in section.items())
    named = keyed(rim, "diameter", "outer", "inner", "width", "thickness")
    return [
        Fact("its rim", f"diameters: {diameters} mm\n{sections}", named),
        Fact(
            "inertia of the rim",
            f"{number(rim.inertia)} kg*m^2, {number(100 * rim.inertia / own, 3)} % of the wheel's"
            "\n(arms and hub are to give the rest)",
            keyed(rim, "inertia"),
        ),
        Fact(
            "mass of the rim",
            f"{number(rim.mass)} kg, {number(rim.total_mass)} kg with arms and hub"
            f"\n(4 J/D^2 = {number(rim.thin_mass)} kg as a thin rim alone)",
            keyed(rim, "mass", "total_mass", "thin_mass"),
        ),
        Fact(
            "speed of the rim",
            f"{number(rim.speed, 5)} m/s at its edge, {number(material.rim_speed)} m/s allowed for {material.name}",
            {
                **keyed(rim, "speed"),
                **keyed(material, "rim_speed"),
                **keyed(rim, "allowed"),
                **keyed(material, "name", "density", "strength", "source"),
            },
        ),
        Fact(
            "stress in the rim",
            f"{number(rim.stress / 1e6, 5)} MPa as a thin ring, {number(rim.peak_stress / 1e6, 5)} MPa inside"
            f"\nsafety {number(rim.safety, 4)} against {number(material.strength / 1e6)} MPa",
            keyed(rim, "stress", "peak_stress", "safety"),
        ),
    ]
