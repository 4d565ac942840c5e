"""What is given of the loads of a cam, its spring and guide, its strength."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import degrees

from tmmcalc.cams.forces.spring import DEFLECTION
from tmmcalc.cams.notes.cam_forces import GIVEN, given_loads
from tmmcalc.cams.notes.lexicon import angle, mm
from tmmcalc.cams.notes.loaded.judged import of_needs
from tmmcalc.cams.notes.loaded.quantities import Loaded, loaded_of, of_scene
from tmmcalc.cams.tables.cam import CamTable
from tmmcalc.cams.task import CamTask, Requirements
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Datum, Lexicon
from tmmcalc.report.telling import data_of, in_rows

MEGA = 1e-6
NEEDS = {  # keys of [cam.requirements]
    "width": "b",
    "modulus": "E_n",
    "contact": "sigma_HP",
    "rolling_arm": "k_r",
    "roller_friction": "f_r",
    "pin_friction": "f_0",
    "pin_pressure": "p_0P",
    "pin_ratio": "alpha_2",
    "roller_ratio": "alpha_0",
    "roller_density": "rho_s",
    "span": "l_s",
    "bending": "sigma_FP",
    "deflection": "Delta_P",
    "young": "E",
    "torsion": "alpha_e",
    "guide_pressure": "p_gP",
}
STEM = {"stem_radius": "r_T", "land": "l_H"}  # keys of [cam.guide]
GUIDE = {"top": "H_2", "length": "l", "gap": "Delta_g"}


def written(table: object, names: Mapping[str, str]) -> list[str]:
    """The names of the keys that the spec has written into a table."""
    said = getattr(table, "model_fields_set", ())
    return [name for key, name in names.items() if key in said]


def of_loads(order: Order) -> Iterator[Datum]:
    """Masses, forces and friction, the spring, the guide."""
    table, of = order.spec.cam, loaded_of(order)
    known = of.named(given_loads(of))
    yield from data_of(known, GIVEN)
    force = of.loads.force
    if force.phi is not None and force.values is not None:
        said = tr("angles of the cam of the points of the technological load, from the beginning of the rise")
        places = Datum(said, (), tuple(map(degrees, force.phi)), "deg")
        unit = "N*m" if of.turns else "N"
        said = tr("technological load at these points, linear between")
        yield from in_rows(places, Datum(said, (), tuple(map(float, force.values)), unit))
    yield from _spring(of)
    yield from data_of(of.named(of_scene(of)), written(table.guide, GUIDE))
    if order.results["cam_forces"].guide is not None:
        yield from _guide(of)


def _spring(of: Loaded) -> Iterator[Datum]:
    """How the spring is found, and what it is wound of."""
    asked = of.loads.spring
    if asked.method == "none":
        return
    ways = {
        "given": tr("its stiffness and preload are given"),
        "safety": tr("by the safety of the closure over the whole turn")
        if asked.exact
        else tr("by the safety of the closure, by the rule of the textbook"),
        "preload": tr("by its deflection in the lowest position and the least load of the contact"),
    }
    yield Datum(tr("return spring"), text=ways[asked.method])
    known: Lexicon = {}
    if asked.method == "preload":
        deflection = DEFLECTION * of.task.program.stroke if asked.deflection is None else asked.deflection
        said = tr("deflection of the spring in the lowest position")
        known["f_1"] = angle(deflection, said) if of.turns else mm(deflection, said)
    if asked.wire is not None and asked.coil is not None:
        known["d"] = mm(asked.wire, tr("diameter of the wire"))
        known["D"] = mm(asked.coil, tr("mean diameter of the coils"))
    if asked.allowed is not None:
        known["tau_a"] = Given(MEGA * asked.allowed, "MPa", tr("permissible shear stress of the wire"))
        known["n_d"] = Given(asked.dead, "", tr("number of coils at the ends that do not work"))
    if known.keys() & {"d", "tau_a"}:
        known["E_G"] = Given(MEGA * asked.shear, "MPa", tr("shear modulus of the wire"))
    yield from data_of(known, known)


def _guide(of: Loaded) -> Iterator[Datum]:
    """Where the guide begins, and where it acts on the stem."""
    parts = ["S_0", "h", *["r_2"] * (of.kind == "translating"), *["Delta_g"] * bool(of.task.guide.gap)]
    said = tr("height of the lower edge of the guide above the axis of the cam")
    yield Datum(said, ("H_1",), text=f"${' + '.join(parts)}$")
    yield Datum(tr("reactions of the guide"), text=tr("across the stem, at both edges of the guide"))


def of_needed(table: CamTable, task: CamTask) -> Iterator[Datum]:
    """Data of strength and slip: those that the spec writes, and of the usual ones what these ask for."""
    given = table.requirements
    if given is not None:
        names = {*written(given, NEEDS), *_usual(task.requirements)}
        yield from data_of(of_needs(task), (name for name in NEEDS.values() if name in names))
        if given.material is not None:
            words = [tr_name(given.material.treatment), given.material.hardness]
            if given.material.failure == "severe":
                words.append(tr("severe consequences of a failure"))
            yield Datum(tr("material of cam and roller"), text=", ".join(words))
        if given.pin is not None:
            yield Datum(tr("radius of the pin"), ("r_0",), (1e3 * given.pin,), "mm")
        if given.roller_inertia is not None:
            yield Datum(tr("moment of inertia of the roller"), ("J_r",), (given.roller_inertia,), "kg*m^2")
    yield from data_of(of_needs(task), written(table.guide, STEM))


def _usual(needs: Requirements) -> Iterator[str]:
    """The names of what has a usual value and counts with the data that are given."""
    if needs.contact is not None:
        yield "E_n"
    if needs.pin_pressure is not None or needs.pin is not None:
        yield from ("alpha_2", "alpha_0")
    if needs.rolling_arm is not None and needs.roller_inertia is None:
        yield "rho_s"
    if needs.deflection is not None:
        yield "E"
    if needs.bending is not None and needs.span is not None:
        yield "alpha_e"
