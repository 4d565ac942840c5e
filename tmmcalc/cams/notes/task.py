"""What is given of a cam or of an indexing drive: its kind, motion and law, sizes and limits, loads, strength."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import degrees, isclose, pi

import numpy as np

from tmmcalc.cams.lawresult import LawResult
from tmmcalc.cams.notes.cam_elastic import TRAIN, train_scene
from tmmcalc.cams.notes.cam_forces import GIVEN as LOADS
from tmmcalc.cams.notes.cam_forces import given_loads
from tmmcalc.cams.notes.cam_law import described, laws_described
from tmmcalc.cams.notes.cam_profile import axes_of
from tmmcalc.cams.notes.cam_synthesis import SIZES, of_limits
from tmmcalc.cams.notes.indexing import given_names, law_name
from tmmcalc.cams.notes.lexicon import Told, of_follower, of_task, told_of
from tmmcalc.cams.notes.loaded.judged import of_needs
from tmmcalc.cams.notes.loaded.quantities import Loaded, loaded_of, of_scene
from tmmcalc.cams.notes.stepping.quantities import stepping_of
from tmmcalc.cams.tables.tasks.indexing import to_indexing
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Datum, Lexicon

LIMITS = {  # keys of [cam.limits] by the names in formulas
    "pressure_angle": "theta_P",
    "pressure_angle_return": "theta_{Pc}",
    "convex_radius": "r_m",
    "concave_radius": "r_i",
    "shaft_radius": "r_1",
}
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
NEAR = 1e-9  # [rad]: one angle
SPRING = {"safety": "K_1", "least_contact": "F_min"}  # keys of [cam.spring] that have defaults


def blocks(order: Order) -> Iterator[Block]:
    """The data that the spec says, without those that the program has found or taken."""
    if "cam_law" in order.results and "cam_synthesis" in order.results:
        yield from _cam(order)
    if "indexing" in order.results:
        yield from _drive(order)


def _cam(order: Order) -> Iterator[Datum]:
    """The cam in the order of its chapter."""
    table, told = order.spec.cam, told_of(order)
    yield from (Datum(what, text=text) for what, text in described(told))
    if table.steps is not None:
        yield Datum(tr("number of equal steps of each phase of motion"), ("n",), (float(table.steps),))
        yield from _positions(told.law)
    if "cam_profile" in order.results:
        yield Datum(tr("axes of the cam"), text=axes_of(told.follower))
    motion = told.named(of_task(told))
    if table.speed is not None and _is_round(turns := table.speed * 30 / pi):  # as it was written, then
        yield Datum(tr("rotational speed of the cam"), ("n_1",), (turns,), "rpm")
    yield from _data(motion, (name for name in motion if name != told.words["wn"] or table.speed is not None))
    yield from (Datum(what, text=text) for what, text in laws_described(told))
    sizes = [SIZES[size.symbol] for size in order.results["cam_synthesis"].sizes if size.given]
    yield from _data(of_follower(told.follower), sizes)
    yield from _data(of_limits(told), _written(table.limits, LIMITS))
    if "cam_pressure" in order.results and told.follower.kind != "flat":
        yield Datum(tr("where the pressure angle is positive"), text=_positive(told))
    if "cam_forces" in order.results:
        of = loaded_of(order)
        left_out = {*SPRING.values()} - {*_written(table.spring, SPRING)}
        yield from _data(of.named(given_loads(of)), (name for name in LOADS if name not in left_out))
        yield from _data(of.named(of_scene(of)), _written(table.guide, GUIDE))
        if order.results["cam_forces"].guide is not None:
            yield from _guide(of)
    yield from _data(of_needs(told.task), (*_written(table.requirements, NEEDS), *_written(table.guide, STEM)))
    if "cam_elastic" in order.results:
        yield from _data(train_scene(told, order.results["cam_elastic"]), TRAIN)


def _positions(law: LawResult) -> Iterator[Datum]:
    """The numbers of the positions from the beginning to the end of each phase of motion."""
    words = {"rise": tr("positions of the rise"), "return": tr("positions of the return")}
    for phase in law.phases:
        if phase.constants is not None:
            within = (law.positions.phi >= phase.begin - NEAR) & (law.positions.phi <= phase.end + NEAR)
            first, *_, last = (law.labels[row].rstrip("-") for row in np.flatnonzero(within))
            said = tr("{first} at its beginning to {last} at its end", first=first, last=last)
            yield Datum(words[phase.kind], text=said)


def _positive(told: Told) -> str:
    """The rule of the sign of the pressure angle."""
    if told.turns:
        return tr("where the force of the cam pulls the rocker away from its pivot")
    return tr("where the normal of the profile is turned from the velocity of the rise as the cam turns")


def _guide(of: Loaded) -> Iterator[Datum]:
    """Where the guide begins, and where it acts on the stem."""
    parts = ["S_0", "h", *["r_2"] * (of.kind == "translating"), *["Delta_g"] * bool(of.task.guide.gap)]
    said = tr("height of the lower edge of the guide above the axis of the cam")
    yield Datum(said, ("H_1",), text=f"${' + '.join(parts)}$")
    yield Datum(tr("reactions of the guide"), text=tr("across the stem, at both edges of the guide"))


def _drive(order: Order) -> Iterator[Datum]:
    """The indexing drive."""
    of = stepping_of(to_indexing(order.spec), order.results["indexing"])
    yield Datum(tr("law of the step"), text=law_name(of.found))
    yield from _data(of.lexicon, given_names(of))


def _is_round(value: float) -> bool:
    """Whether a few figures tell it whole."""
    return isclose(value, float(f"{value:.5g}"), rel_tol=1e-12)


def _written(table: object, names: dict[str, str]) -> list[str]:
    """The names of the keys that the spec has written into a table."""
    said = getattr(table, "model_fields_set", ())
    return [name for key, name in names.items() if key in said]


def _data(known: Lexicon, names: Iterable[str]) -> Iterator[Datum]:
    """Those of the names that have a value, angles in degrees."""
    for name in names:
        given = known.get(name) or known.get(canonical(name))
        if given is None or not given.value:
            continue
        assert isinstance(given.value, float)
        turned = given.unit == "rad"
        value, unit = (degrees(given.value), "deg") if turned else (given.value, given.unit)
        yield Datum(given.meaning, (name,), (value,), unit)
