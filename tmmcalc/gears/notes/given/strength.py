"""What is given of the strength of a train and of the choice among trains: load, materials, rules, criteria."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tmmcalc.gears.criteria.wheels import Build
from tmmcalc.gears.notes.letters import letter
from tmmcalc.gears.notes.strength import steel_word
from tmmcalc.gears.pictures.words import short_name
from tmmcalc.gears.selection.task import WEIGHTED
from tmmcalc.gears.strength.letters import LETTERS
from tmmcalc.gears.strength.material import Material
from tmmcalc.gears.tables.strength import StrengthTable
from tmmcalc.gears.tables.tasks.sizing import to_selection
from tmmcalc.gears.tables.tasks.strength import to_material
from tmmcalc.gears.tables.tasks.train import to_train
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr, tr_name, tr_number
from tmmcalc.report.manuscript import Datum

MM = 1e3  # of a metre


def of_strength(order: Order) -> Iterator[Datum]:
    """What loads the train, what its wheels are made of, by what rules its modules and widths follow."""
    table: StrengthTable | None = order.spec.strength
    if table is None:
        return
    if table.torque is not None:
        yield Datum(tr("torque on wheel 1, of all branches together"), ("T_1",), (table.torque,), "N*m")
    if table.moment is not None:
        said = tr("largest moment on the output shaft of the train, whose losses are not counted")
        yield Datum(said, ("M_{max}",), (abs(table.moment),), "N*m")
    if table.moment_ratio is not None:
        said = tr("speed of wheel 1 over that of the shaft of this moment")
        yield Datum(said, ("u_Σ",), (abs(table.moment_ratio),))
    apart = table.wheel is not None or table.pinion is not None
    first = tr("material of the pinions") if apart else tr("material of the wheels")
    planets = any(each.scheme.planetary for each in to_train(order.spec))
    yield from of_material(to_material(table.pinion or table.material), first, planets=planets)
    yield from of_material(to_material(table.wheel), tr("material of the other wheels"), planets=planets)
    yield from _stages(table)
    yield from _rules(table)


def of_material(material: Material | None, said: str, *, planets: bool) -> Iterator[Datum]:
    """Steel, treatment, hardness and what of its service is not usual; ``planets``: whether there are any."""
    if material is None:
        return
    words = [tr_name(material.treatment), str(material.hardness)]
    if material.steel:
        words.insert(0, steel_word(material.steel))
    if material.core is not None:
        words.append(tr("core {hardness}", hardness=material.core))
    if material.protected:
        words.append(tr("protected against decarburisation"))
    if material.structure is not None:
        words.append(tr_name(material.structure))
    words.append(_sides(material.load, planets=planets))
    if material.failure == "severe":
        words.append(tr("severe consequences of a failure"))
    if material.wear == "abrasive":
        words.append(tr("abrasive wear"))
    if material.blank != "forging":
        words.append(tr_name(material.blank))
    yield Datum(said, text=", ".join(words))
    if material.row is not None:
        yield Datum(tr("{material}: row of table D.4.3", material=said), text=material.row)
    for key, limit in (("sigma_Hlim", material.contact_limit), ("sigma_Flim^0", material.bending_limit)):
        if limit is not None:
            yield Datum(f"{said}: {tr_name(LETTERS[key])}", (letter(key),), (limit / 1e6,), "MPa")


def _sides(load: str | None, *, planets: bool) -> str:
    """How many sides of the teeth bear load."""
    if load is None and planets:
        return tr("load on one side of the teeth, of planets on both")
    return tr("load on both sides of the teeth") if load == "two-sided" else tr("load on one side of the teeth")


def _stages(table: StrengthTable) -> Iterator[Datum]:
    """What is given of each stage, or of all alike."""
    megapascal = 1e-6
    for values, key, factor, unit in (
        (table.permissible_contact, "sigma_HP", megapascal, "MPa"),
        (table.permissible_bending, "sigma_FP", megapascal, "MPa"),
        (table.face_width, "psi_bd", 1.0, ""),
        (table.module, "m", MM, "mm"),
        (table.width, "b", MM, "mm"),
    ):
        if values is not None:
            said = tr_name(LETTERS[key])
            meaning = tr("{quantity}, stage by stage", quantity=said) if len(values) > 1 else said
            yield Datum(meaning, (letter(key),), tuple(factor * value for value in values), unit)
    if table.face_width is None and table.module is None:
        yield Datum(tr_name(LETTERS["psi_bd"]), (letter("psi_bd"),), text=tr("middle of table D.4.2"))
    if table.arrangement is not None:
        said = tr("place of the wheels between their bearings, row of table D.4.1")
        yield Datum(said, (), tuple(map(float, table.arrangement)))


def _rules(table: StrengthTable) -> Iterator[Datum]:
    """Rules of modules and widths, where they are not the usual ones."""
    if table.modules_row == 1:
        yield Datum(tr("standard modules"), text=tr("of the preferred row alone"))
    if table.underrun:
        yield Datum(tr("part by which a standard module may be too small"), (), (table.underrun,))
    if table.face_width_rule == "book1992":
        yield Datum(tr("face widths"), text=tr("by the rule of the textbook's program"))
    if table.rounding == "floor1":
        yield Datum(tr("rounding of face widths"), text=tr("down to whole millimetres, and one more"))
    if table.on_overload == "reject":
        yield Datum(tr("sets whose second stage is too weak"), text=tr("left out"))
    if table.iterate:
        said = tr("factors of the load distribution over the width")
        yield Datum(said, text=tr("at the face width that results"))


def of_choice(order: Order) -> Iterator[Datum]:
    """By what the best train is chosen, and what masses, inertias and efficiencies are found with."""
    if order.spec.train is None:
        return
    task, build = to_selection(order.spec), Build()
    rings = any(each.scheme.rings for each in to_train(order.spec))
    yield Datum(tr("efficiency of an external mesh"), (), (task.meshes.external,))
    if rings:
        yield Datum(tr("efficiency of an internal mesh"), (), (task.meshes.internal,))
    if "criteria" not in order.results:
        return
    yield Datum(tr("criteria of the comparison"), text=_listed(task.objectives))
    chosen = {WEIGHTED: tr("by the weighted sum of the criteria")}.get(str(task.choose))
    if isinstance(task.choose, int):
        chosen = tr("row {number} of the list", number=task.choose)
    yield Datum(tr("choice of the train"), text=chosen or tr("by {criterion}", criterion=short_name(str(task.choose))))
    for key, weight in task.weights:
        yield Datum(tr("weight of the criterion “{name}”", name=short_name(key)), (), (weight,))
    yield Datum(tr("density of steel"), ("rho",), (build.density,), "kg/m^3")
    yield Datum(tr("coefficient of the mass of a webbed wheel"), ("alpha_M",), (build.webbed_mass,))
    yield Datum(tr("coefficient of the inertia of a webbed wheel"), ("alpha_J",), (build.webbed_inertia,))
    if rings:
        yield Datum(tr("depth of a ring with its rim over the module"), (), (build.rim,))
    if task.series:
        said = tr("the best train is compared with two trains with single planets in series")
        yield Datum(tr("further comparison"), text=said)


def _listed(criteria: Sequence[str]) -> str:
    return tr_number(", ".join(map(short_name, criteria)))
