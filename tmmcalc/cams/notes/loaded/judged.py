"""The quantities of the requirements: what is given of materials and sizes, and what a place of the turn adds.

Lengths in mm, stresses in MPa. Permissible values have the index P: ``sigma_HP``, ``p_0P``.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from tmmcalc.cams.follower import contact_path
from tmmcalc.cams.notes.lexicon import mm
from tmmcalc.cams.notes.loaded.quantities import Found, Loaded, of_scene
from tmmcalc.cams.pressure.angle import tangent_terms
from tmmcalc.cams.strength.case import contact_curvature, roller_acceleration
from tmmcalc.cams.strength.formulas import flat_radius, rolling, stem_moment
from tmmcalc.cams.strength.results import CamStrength, Margin
from tmmcalc.cams.task import CamTask, Requirements
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Lexicon, Place

MEGA = 1e-6
ROWS = ("curvature", "run", "slip", "stress", "reduced", "bending", "pressure")  # of the result, where they are


class Judging(NamedTuple):
    """A loaded cam with its requirements."""

    of: Loaded
    found: CamStrength

    @property
    def needs(self) -> Requirements:
        """What is asked."""
        return self.of.task.requirements

    @property
    def scene(self) -> Lexicon:
        """What is the same all over the turn."""
        return self.of.named(of_scene(self.of) | of_requirements(self))

    def margin(self, name: str) -> Margin | None:
        """A requirement by its name, if it has a value."""
        return next((each for each in self.found.margins if each.name == name and each.value is not None), None)

    def lines(self, texts: Sequence[str], lexicon: Lexicon) -> Iterator[Block]:
        """Formulas at one place, or for all of the turn."""
        yield from self.of.lines(texts, [Place("", self.scene | lexicon)])

    def row(self, row: int) -> Place:
        """A row of the tables."""
        place, there = self.of.at_row(row), self.of.row(row)
        arrays = {name: getattr(self.found, name) for name in ROWS}
        values = {name: float(each[row]) for name, each in arrays.items() if each is not None}
        return Place(place.name, self._lexicon(there, place.lexicon, values))

    def at(self, there: Found, **values: float) -> Lexicon:
        """The quantities of a place, with ``values`` [SI] of ROWS that are known there."""
        follower = self.found.follower
        known = {"curvature": float(contact_curvature(follower, there.points.motion)[0])}
        if follower.kind != "flat":
            loads, points = self.of.loads, there.points
            known["run"] = float(roller_acceleration(self.of.task, loads, follower, points, there.now.contact)[0])
        return self._lexicon(there, self.of.at(there), known | values)

    def _lexicon(self, there: Found, lexicon: Lexicon, values: Mapping[str, float]) -> Lexicon:
        own = _shape(self, there, values["curvature"]) | _judged(values) | _moments(self, there)
        return self.scene | lexicon | self.of.named(own)


def of_needs(task: CamTask) -> Lexicon:
    """What is given of materials and sizes."""
    needs, limits, guide = task.requirements, task.limits, task.guide
    lengths = {
        "b": (needs.width, tr("length of the line of contact")),
        "k_r": (needs.rolling_arm, tr("arm of the rolling resistance")),
        "l_s": (needs.span, tr("distance of the supports of the camshaft")),
        "Delta_P": (needs.deflection, tr("permissible deflection of the camshaft")),
        "r_T": (guide.stem, tr("radius of the stem")),
        "l_H": (guide.land, tr("length of each ground land of the stem")),
        "r_m": (limits.convex, tr("least radius of convex parts that can be made")),
        "r_i": (limits.concave, tr("least radius of the tool for concave parts")),
        "r_1": (limits.shaft or None, tr("radius of the camshaft")),
    }
    quantities = {name: mm(value, said) for name, (value, said) in lengths.items() if value is not None}
    stresses = {
        "E_n": (needs.modulus, tr("reduced modulus of elasticity of cam and roller")),
        "E": (needs.young, tr("modulus of elasticity of the camshaft")),
        "sigma_HP": (needs.contact, tr("permissible contact stress")),
        "sigma_FP": (needs.bending, tr("permissible bending stress")),
        "p_0P": (needs.pin_pressure, tr("permissible pressure on the pin")),
        "p_gP": (needs.guide_pressure, tr("permissible pressure in the guide")),
    }
    quantities |= {name: Given(MEGA * v, "MPa", said) for name, (v, said) in stresses.items() if v is not None}
    numbers = {
        "f_r": (needs.roller_friction, tr("coefficient of sliding friction of the roller on the cam")),
        "f_0": (needs.pin_friction or 0.0, tr("coefficient of friction of the roller on its pin")),
        "alpha_2": (needs.pin_ratio, tr("length of the pin over its diameter")),
        "alpha_0": (needs.roller_ratio, tr("least radius of the roller over that of the pin")),
        "alpha_e": (needs.torsion, tr("weight of the torque in the reduced moment")),
    }
    quantities |= {name: Given(v, "", said) for name, (v, said) in numbers.items() if v is not None}
    quantities["rho_s"] = Given(needs.roller_density, "kg/m^3", tr("density of the roller"))
    return quantities


def of_requirements(of: Judging) -> Lexicon:
    """What is given, and the constants of the roller and the shaft."""
    quantities, found = of_needs(of.of.task), of.found
    quantities["R_max"] = Given(of.of.result.extreme("R").size, "N", tr("largest force of the cam"))
    if found.unit is not None:
        quantities["r_0"] = mm(found.unit.pin, tr("radius of the pin"))
        quantities["r_2^{*}"] = mm(found.unit.least, tr("least radius of the roller"))
    elif found.rolling is not None:
        quantities["r_0"] = mm(0.0)
    if found.rolling is not None:
        quantities["C_1"] = Given(found.rolling.resisting, "", tr("constant of the resistance in the slip function"))
        quantities["C_2"] = Given(
            1e-3 * found.rolling.driving, "N/mm", tr("constant of the inertia in the slip function")
        )
        quantities["J_r"] = Given(found.rolling.inertia, "kg*m^2", tr("moment of inertia of the roller"))
    return quantities


def _shape(of: Judging, there: Found, curvature: float) -> Lexicon:
    """Curvature of the profile, and for a roller the rates of the pitch curve that it and A are made of."""
    follower, motion = of.found.follower, there.points.motion
    if follower.kind == "flat":
        radius = float(flat_radius(motion, follower.start)[0])
        return {"rho": mm(radius, tr("radius of curvature of the profile"))}
    speed = float(np.hypot(*tangent_terms(follower, motion, follower.start, follower.offset))[0])
    own = {
        "w": mm(speed, tr("derivative of the arc of the pitch curve by $phi$")),
        "kappa": Given(1e-3 * curvature, "1/mm", tr("curvature of the pitch curve, negative where it is concave")),
        "b_κ": Given(1e6 * curvature * speed**3, "mm^2", tr("numerator of the curvature")),
        "A_0": mm(float(rolling(follower, motion)[1][0]), tr("second derivative of this arc by $phi$")),
    }
    return own | _rates(of, there) if follower.kind == "oscillating" else own


def _rates(of: Judging, there: Found) -> Lexicon:
    """Derivatives of the pitch curve along and across the line of centres, of a rocker."""
    points = there.points
    _, one, two = (contact_path(of.found.follower, points.phi, points.motion) * np.exp(-1j * points.phi))[:, 0].tolist()
    return {
        "u_1": mm(one.real, tr("first derivative of the pitch curve along the line of centres")),
        "h_1": mm(one.imag, tr("first derivative of the pitch curve across the line of centres")),
        "u_2": mm(two.real, tr("second derivative of the pitch curve along the line of centres")),
        "h_2": mm(two.imag, tr("second derivative of the pitch curve across the line of centres")),
    }


def _judged(values: Mapping[str, float]) -> Lexicon:
    """What the requirements are judged by."""
    said = {
        "run": ("A", 1e3, "mm", tr("acceleration of the rolling, over the square of the angular velocity")),
        "slip": ("D", 1.0, "", tr("slip function; the roller rolls where it is at most 1")),
        "stress": ("sigma_H", MEGA, "MPa", tr("contact stress")),
        "reduced": ("M_E", 1.0, "N*m", tr("reduced moment of the camshaft")),
        "bending": ("sigma_F", MEGA, "MPa", tr("bending stress of the stem")),
        "pressure": ("p_g", MEGA, "MPa", tr("pressure in the guide")),
    }
    return {
        name: Given(factor * values[key], unit, meaning)
        for key, (name, factor, unit, meaning) in said.items()
        if key in values
    }


def _moments(of: Judging, there: Found) -> Lexicon:
    """Bending moment of a stem at the lower edge of its guide."""
    now, follower = there.now, of.found.follower
    if of.of.task.guide.stem is None or follower.kind == "oscillating":
        return {}
    moment = stem_moment(follower, there.points.motion, now.contact, now.sine, now.protrusion)
    return {"M_T": Given(float(moment[0]), "N*m", tr("bending moment of the stem at the lower edge of the guide"))}
