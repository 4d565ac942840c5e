"""What is given of gears: of a train its layout or its meshes, speeds and load; of a pair its teeth and shifts."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from functools import partial

from tmmcalc.gears.chosen.motion import Moving, written
from tmmcalc.gears.gearing import Gearing
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.gears.network.model import INTERNAL
from tmmcalc.gears.network.willis import wheel_names
from tmmcalc.gears.notes.letters import joined, teeth
from tmmcalc.gears.notes.pair import given_quantities
from tmmcalc.gears.notes.pairs.choice import chosen
from tmmcalc.gears.notes.pairs.lexicon import told_of
from tmmcalc.gears.notes.pairs.tables import something
from tmmcalc.gears.notes.strength import steel_word
from tmmcalc.gears.pictures.memberscheme import draw_members
from tmmcalc.gears.pictures.words import layout_word
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Datum, Figure

OF_WHEELS: Mapping[str, Callable[[str], str]] = {  # what is given of a wheel, by its letter
    "z": lambda wheel: tr("number of teeth of wheel {wheel}", wheel=wheel),
    "x": lambda wheel: tr("shift coefficient of wheel {wheel}", wheel=wheel),
    "r_a": lambda wheel: tr("tip radius of wheel {wheel}", wheel=wheel),
}
SCHEME = (110.0, 75.0)  # size of the scheme [mm]


def blocks(order: Order) -> Iterator[Block]:
    """The scheme of a train that is written out, and the data; those of pairs of a train stand with their chapter."""
    if order.spec.train is not None:
        yield from _train(order)
    if "gearing" in order.results:
        yield from _written(order, order.results["gearing"])
    if "pair" in order.results and order.spec.pair.teeth is not None:
        for found in order.results["pair"].pairs:
            yield from _pair(found)


def _pair(found: MeshPair) -> Iterator[Datum]:
    """A pair by its teeth: its kind of mesh, what is given of it and of which wheel, its tips."""
    task, lexicon = found.task, told_of(found).lexicon
    kinds = {
        "external": tr("external, of two wheels"),
        "internal": tr("internal, of a wheel in a ring"),
        "rack": tr("of a wheel with a rack"),
    }
    yield Datum(tr("kind of mesh"), text=kinds[task.kind])
    said = {f"{letter}_{k}": of(wheel) for letter, of in OF_WHEELS.items() for k, wheel in enumerate(task.wheels, 1)}
    if task.helix:
        said["m"] = tr("module in the normal section")
    for name, given in something(given_quantities(found), lexicon):
        assert isinstance(given.value, float)
        yield Datum(said.get(name, given.meaning), (name,), (given.value,), given.unit)
    if task.kind == "external" and task.tips == (None, None):
        said_of_tips = tr("shortened by $Deltay*m$, which keeps the radial clearance $c^{*}*m$")
        yield Datum(tr("tips of the teeth"), text=said_of_tips)
    yield from _choice(task)


def _choice(task: PairTask) -> Iterator[Datum]:
    """How shifts that are not given are chosen."""
    if task.strategy != "given":
        yield Datum(tr("choice of the shifts"), text=chosen(task))


def _train(order: Order) -> Iterator[Datum]:
    """What a train that is sought has to be."""
    train, strength = order.spec.train, order.spec.strength
    yield Datum(tr("layout of the train"), text=", ".join(map(layout_word, train.layout)))
    if train.ratio is not None:
        yield Datum(tr("ratio that is asked for"), ("u",), (float(train.ratio),))
    if train.tolerance is not None and train.tolerance_kind == "relative":
        yield Datum(tr("admitted error of the ratio"), ("Delta",), (100 * float(train.tolerance),), "%")
    if train.planets:
        yield Datum(tr("number of planets"), ("K",), tuple(map(float, train.planets)))
    if strength is not None and strength.torque is not None:
        yield Datum(tr("torque on wheel 1, of all branches together"), ("T_1",), (strength.torque,), "N*m")
    material = None if strength is None else strength.material
    if material is not None and material.treatment is not None:
        said = tr_name(material.treatment)
        yield Datum(
            tr("material of the wheels"), text=f"{steel_word(material.steel)}, {said}" if material.steel else said
        )


def _written(order: Order, found: Gearing) -> Iterator[Block]:
    """A train that is written out: its scheme, its teeth, what is known of its motion and load."""
    moving, table = written(found), order.spec.gearing
    yield Figure(tr("Scheme of the train"), partial(draw_members, found=moving), SCHEME, "gearing_task_scheme")
    yield from _members(moving)
    task = found.task
    for name, speed in task.speeds.items():
        if speed:
            yield Datum(tr("speed of link {link}", link=name), (f"n_{{{name}}}",), (speed * 30 / math.pi,), "rpm")
    held = [name for name, speed in task.speeds.items() if not speed]
    if held:
        yield Datum(tr("links at rest"), text=", ".join(held))
    if task.locked:
        yield Datum(tr("links that turn as one"), text=", ".join("–".join(pair) for pair in task.locked))
    for name, power in task.powers.items():
        yield Datum(tr("power put in on link {link}", link=name), (f"P_{{{name}}}",), (power,), "W")
    for name, torque in task.torques.items():
        yield Datum(tr("outside torque on link {link}", link=name), (f"T_{{{name}}}",), (torque,), "N*m")
    for name, torque in task.loads.items():
        yield Datum(tr("resisting torque on link {link}", link=name), (f"T_{{{name}}}",), (torque,), "N*m")
    if found.outputs:
        yield Datum(tr("driven link"), text=", ".join(found.outputs))
    if table.friction is not None:
        yield Datum(tr("coefficient of friction of teeth"), ("f",), (float(table.friction),))
    else:
        yield from _efficiencies(moving)


def _members(moving: Moving) -> Iterator[Datum]:
    """Wheels with their teeth, which of them mesh, how many links there are of a kind."""
    network = moving.task.network
    numbers = dict[str, float]()
    meshes = list[str]()
    for mesh, names in zip(network.meshes, _meshes(moving), strict=True):
        numbers |= dict(zip(names, (mesh.first_teeth, mesh.second_teeth), strict=True))
        pair = "–".join(names)
        meshes.append(tr("{mesh} (internal)", mesh=pair) if mesh.sign == INTERNAL else pair)
    yield Datum(tr("wheels in mesh"), text=", ".join(meshes))
    for name, given in teeth(numbers).items():
        assert isinstance(given.value, float)
        yield Datum(given.meaning, (name,), (given.value,))
    for body in network.bodies:
        if body.count > 1:
            yield Datum(tr("how many links {link} there are", link=body.name), ("K",), (float(body.count),))


def _efficiencies(moving: Moving) -> Iterator[Datum]:
    """Of all meshes together if they have the same, else of each."""
    values = [mesh.efficiency for mesh in moving.task.network.meshes]
    if len({*values}) == 1:
        yield Datum(tr("efficiency of each mesh"), ("eta",), (values[0],))
        return
    for value, names in zip(values, _meshes(moving), strict=True):
        said = tr("efficiency of the mesh {mesh}", mesh="–".join(names))
        yield Datum(said, (f"eta_{{{joined(names)}}}",), (value,))


def _meshes(moving: Moving) -> list[tuple[str, str]]:
    """The wheels of every mesh by their names."""
    layout = None if moving.chosen is None else moving.chosen.sets.scheme
    return [(first, second) for first, second in wheel_names(moving.task.network, layout)]
