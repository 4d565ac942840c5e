"""Materials of flywheel rims, and the fluctuation customarily allowed by kind of machine."""

from __future__ import annotations

from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record


@record
class Material:
    """A rim material."""

    name: str = quantity("rim_material", "material of the rim")
    density: float = quantity("rim_density[kg/m^3]", "density of the rim")
    rim_speed: float = quantity("rim_speed_limit[m/s]", "largest speed of the rim that is allowed")
    strength: float = quantity("rim_strength[Pa]", "tensile strength of the rim")
    source: str = quantity("rim_material_source", "where the data of the material are from")


CAST_IRON = Material(
    "cast iron",
    7200.0,
    30.0,
    200e6,
    "strength of grade EN-GJL-200; customary limit 30 to 35 m/s (one mile a minute, 27 m/s, in old inspection rules)",
)
CAST_STEEL = Material("cast steel", 7800.0, 50.0, 450e6, "strength of grade GS-45; customary limit 50 m/s")
STEEL = Material("steel", 7850.0, 60.0, 470e6, "strength of grade S355, forged or rolled; customary limit 60 m/s")

MATERIALS = {material.name: material for material in (CAST_IRON, CAST_STEEL, STEEL)}


@record
class Allowed:
    """Range of the coefficient of speed fluctuation that is customary for a kind of machine."""

    machine: str
    largest: float  # rough machines [-]
    smallest: float  # fine ones [-]


RECOMMENDED = (
    Allowed("pumps, presses, crushers", 1 / 5, 1 / 30),
    Allowed("metal-cutting machine tools", 1 / 25, 1 / 50),
    Allowed("looms, paper machines", 1 / 40, 1 / 50),
    Allowed("internal combustion engines, compressors", 1 / 80, 1 / 150),
    Allowed("direct-current generators", 1 / 100, 1 / 200),
    Allowed("alternating-current generators", 1 / 200, 1 / 300),
    Allowed("aircraft engines", 1 / 200, 1 / 200),
)
"""Customary values of course projects; limits are set by experience with each kind of machine and are approximate."""
