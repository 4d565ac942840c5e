"""What is given of a train that is written out: its scheme, its teeth, what is known of its motion and load."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial

from tmmcalc.gears.chosen.motion import Moving, written
from tmmcalc.gears.gearing import Gearing
from tmmcalc.gears.network.model import INTERNAL
from tmmcalc.gears.network.willis import wheel_names
from tmmcalc.gears.notes.letters import joined, teeth
from tmmcalc.gears.pictures.memberscheme import draw_members
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Datum, Figure
from tmmcalc.report.telling import data_of

SCHEME = (110.0, 75.0)  # size of the scheme [mm]


def of_gearing(order: Order) -> Iterator[Block]:
    """A train that is written out: its scheme, its teeth, what is known of its motion and load."""
    if "gearing" not in order.results:
        return
    found: Gearing = order.results["gearing"]
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
    yield from data_of(teeth(numbers))
    several = [body for body in network.bodies if body.count > 1]
    for body in network.bodies:
        if body.count > 1:
            said = tr("how many links {link} there are", link=body.name)
            yield Datum(said, (f"K_{{{body.name}}}" if several[1:] else "K",), (float(body.count),))
        if body.sharing != 1:
            said = tr("torque of the most loaded of the links {link} over the mean", link=body.name)
            yield Datum(said, (), (body.sharing,))
        if body.tilted:
            yield Datum(tr("link {link}", link=body.name), text=tr("bevel wheel whose axis is tilted"))


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
