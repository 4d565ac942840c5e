"""What is given of pairs of wheels: their teeth, or what is asked of the meshes of a train; an open pair; a wheel."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence

from tmmcalc.gears.involute.measure.span import Rule
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.gears.notes.given.strength import of_material
from tmmcalc.gears.notes.pair import given_quantities
from tmmcalc.gears.notes.pairs.choice import chosen
from tmmcalc.gears.notes.pairs.lexicon import told_of
from tmmcalc.gears.notes.wheel import given_of_wheel
from tmmcalc.gears.pictures.words import pair_name
from tmmcalc.gears.single.results import SingleWheel
from tmmcalc.gears.single.task import WheelTask
from tmmcalc.gears.tables.open_pair import OpenPairTable
from tmmcalc.gears.tables.pair import PairKeys, PairMeshTable
from tmmcalc.gears.tables.tasks.open_pair import to_open_pair
from tmmcalc.gears.tables.tasks.strength import to_material
from tmmcalc.gears.tables.train import TrainTable
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Datum
from tmmcalc.report.telling import Of, data_of, owned

OF_WHEELS: Mapping[str, Callable[[str], str]] = {  # what is given of a wheel, by its letter before the index
    "z_": lambda wheel: tr("number of teeth of wheel {wheel}", wheel=wheel),
    "x_": lambda wheel: tr("shift coefficient of wheel {wheel}", wheel=wheel),
    "r_a": lambda wheel: tr("tip radius of wheel {wheel}", wheel=wheel),
}
RACK = ("alpha", "h_a^{*}", "c^{*}")
MM = 1e3  # of a metre


def of_pairs(order: Order) -> Iterator[Datum]:
    """Pairs by their teeth, meshes of a train by what is asked of them, the open pair on the crank last."""
    if "pair" not in order.results:
        return
    spec, every = order.spec, order.results["pair"].pairs
    on_crank = to_open_pair(spec)
    pairs = [each for each in every if on_crank is None or each.task != on_crank.pair]
    if spec.pair is not None:
        for k, found in enumerate(pairs):
            of = _named(found.task, k) if len(pairs) > 1 else str
            keys = [spec.pair, *_own(spec.pair.meshes, found.task, k)]
            yield from _rack(found, of, spec.train) if spec.pair.of_train else _pair(found, of)
            yield Datum(of(tr("choice of the shifts")), text=_rule(found.task, keys, of_train=spec.pair.of_train))
            yield from _limits(found.task, keys, of)
            yield from _measures(found.task, of)
    if on_crank is not None:
        yield from _open(order, next(each for each in every if each.task == on_crank.pair))


def _named(task: PairTask, k: int) -> Of:
    """Quantities with the name of their pair."""
    plain = pair_name(task.name)
    return owned(tr("pair {name}", name=plain if "–" in plain else f"“{plain}”" if plain else k + 1))


def _own(tables: Sequence[PairMeshTable], task: PairTask, k: int) -> Sequence[PairKeys]:
    """The entry of a pair among several: of a train that of its mesh, else the one at its place."""
    meshes = [each for each in tables if each.mesh is not None]
    return [each for each in meshes if each.mesh == task.name] if meshes else tables[k : k + 1]


def _rule(task: PairTask, keys: Sequence[PairKeys], *, of_train: bool) -> str:
    """How the shifts are chosen; of a mesh of a train one shift may be that of the mesh before."""
    shifted = {"x1", "x2"} & {key for table in keys for key in table.model_fields_set}
    if task.strategy == "given_aw" and task.shifts != (None, None) and not shifted:
        return tr("The centre distance is that of the train; a wheel keeps the shift that it has in another mesh.")
    if task.strategy == "given_aw" and of_train:
        return tr("The centre distance is that of the train; the sum of the shifts follows from it.")
    return chosen(task)


def _pair(found: MeshPair, of: Of) -> Iterator[Datum]:
    """A pair by its teeth: its kind of mesh, what is given of it and of which wheel, its tips."""
    task = found.task
    kinds = {
        "external": tr("external, of two wheels"),
        "internal": tr("internal, of a wheel in a ring"),
        "rack": tr("of a wheel with a rack"),
    }
    yield Datum(of(tr("kind of mesh")), text=kinds[task.kind])
    yield from _quantities(found, of)
    yield from _tips(task, of)


def _quantities(found: MeshPair, of: Of, without: tuple[str, ...] = ()) -> Iterator[Datum]:
    """The numbers that are given, each of its wheel."""
    task, lexicon = found.task, told_of(found).lexicon
    said = {f"{letter}{k}": name(wheel) for letter, name in OF_WHEELS.items() for k, wheel in enumerate(task.wheels, 1)}
    if task.helix:
        said["m"] = tr("module in the normal section")
    own = {name: lexicon[name]._replace(meaning=words) for name, words in said.items() if name in lexicon}
    yield from data_of({**lexicon, **own}, [name for name in given_quantities(found) if name not in without], of)


def _rack(found: MeshPair, of: Of, train: TrainTable) -> Iterator[Datum]:
    """The rack of a mesh of a train: what of it the train has not told."""
    names = [name for name in RACK if name not in _told_rack(found.task, train)]
    yield from data_of(told_of(found).lexicon, names, of)
    yield from _rounding(found.task, of)


def _told_rack(task: PairTask, train: TrainTable | None) -> tuple[str, ...]:
    """What of the rack of a pair its train tells: angle and addendum, where they are the same."""
    same = train is not None and (train.pressure_angle, float(train.addendum)) == (task.rack.angle, task.rack.addendum)
    return RACK[:2] if same else ()


def _tips(task: PairTask, of: Of) -> Iterator[Datum]:
    """How the tips of the rack are rounded, and how high the teeth of the wheels are."""
    yield from _rounding(task, of)
    if task.kind == "external" and task.tips == (None, None):
        said_of_tips = tr("shortened by $Deltay*m$, which keeps the radial clearance $c^{*}*m$")
        yield Datum(of(tr("tips of the teeth")), text=said_of_tips)


def _rounding(task: PairTask | WheelTask, of: Of) -> Iterator[Datum]:
    """The rounding of the rack's tips where it is given, and its section across helical teeth."""
    if task.rack.tip_radius is not None:
        yield Datum(of(tr("radius of the rounding of the rack’s tips, in modules")), (), (task.rack.tip_radius,))
    if task.helix and task.fillet == "circle":
        yield Datum(of(tr("rounding of the rack across helical teeth")), text=tr("a circle, as the textbook has it"))


def _limits(task: PairTask, keys: Sequence[PairKeys], of: Of) -> Iterator[Datum]:
    """Limits that the spec puts, by which a pair is judged and its shifts are chosen."""
    written = {key for table in keys for key in table.model_fields_set}
    limits = task.limits
    for key, said, value in (
        ("contact_ratio_min", tr("least transverse contact ratio"), limits.contact_ratio),
        ("contact_ratio_wanted", tr("wanted transverse contact ratio"), limits.contact_ratio_wanted),
        ("tip_thickness_min", tr("least thickness of the tips, in modules"), limits.tip_thickness),
        ("tip_thickness_wanted", tr("wanted thickness of the tips, in modules"), limits.tip_thickness_wanted),
        ("sliding_max", tr("largest wanted specific sliding"), limits.sliding),
        ("pressure_max", tr("largest wanted specific pressure"), limits.pressure),
    ):
        if key in written and value is not None:
            yield Datum(of(said), (), (value,))
    if "angle_range" in written:
        said = tr("usual operating pressure angles, from and to")
        yield Datum(of(said), (), tuple(map(math.degrees, limits.angles)), "deg")
    if "undercut" in written:
        yield Datum(of(tr("undercut")), text=tr("none") if task.strict else tr("admitted"))


def _measures(task: PairTask, of: Of) -> Iterator[Datum]:
    """What the teeth are measured over, where it is given, and the rules that a choice follows."""
    asked = task.measuring
    spans = {f"z_w{k}": float(teeth) for k, teeth in enumerate(asked.span_teeth, 1) if teeth is not None}
    if spans:
        yield Datum(of(tr("numbers of teeth in the spans")), tuple(spans), tuple(spans.values()))
    balls = {f"D_{k}": size for k, size in enumerate(asked.balls, 1) if size is not None}
    if balls:
        said = tr("diameters of the pins") if asked.body == "pins" else tr("diameters of the balls")
        yield Datum(of(said), tuple(balls), tuple(MM * size for size in balls.values()), "mm")
    elif asked.body == "pins":
        yield Datum(of(tr("measured over")), text=tr("pins"))
    yield from _width(task, asked.rule, of)


def _width(task: PairTask | WheelTask, rule: Rule, of: Of) -> Iterator[Datum]:
    """The face width that a span of helical teeth needs, where it is not that of the textbook."""
    if task.helix and task.face_width is not None and rule == "exact":
        yield Datum(of(tr("face width that a span needs")), text="$W <= b/sin(beta_b)$")


def _open(order: Order, found: MeshPair) -> Iterator[Datum]:
    """The open pair on the crank; of its rack what a train does not have told."""
    table: OpenPairTable = order.spec.open_pair
    of = owned(tr("open pair"))
    if found.task.kind == "internal":
        yield Datum(of(tr("kind of mesh")), text=tr("internal, of a wheel in a ring"))
    yield from _quantities(found, of, _told_rack(found.task, order.spec.train))
    yield from _tips(found.task, of)
    yield Datum(of(tr("choice of the shifts")), text=chosen(found.task))
    yield from _limits(found.task, [table], of)
    yield from _measures(found.task, of)
    if table.friction is not None:
        yield Datum(of(tr("coefficient of friction of teeth")), (), (table.friction,))
    else:
        on_crank = to_open_pair(order.spec)
        assert on_crank is not None
        yield Datum(of(tr_name("efficiency")), ("eta_o",), (on_crank.efficiency,))
    if table.inertia is not None:
        said = tr("moment of inertia of the pair reduced to the crank")
        yield Datum(of(said), ("J_ab",), (table.inertia,), "kg*m^2")
    pinion = to_material(table.pinion or table.material)
    yield from of_material(pinion, of(tr("material of the pinion")), planets=False)
    yield from of_material(to_material(table.gear), of(tr("material of the gear")), planets=False)
    said = tr("place of the wheels between their bearings, row of table D.4.1")
    yield Datum(of(said), (), (float(table.arrangement),))


def of_wheel(order: Order) -> Iterator[Datum]:
    """A wheel or a ring alone, what of it is measured, the circles on which its tooth is asked for."""
    if "wheel" not in order.results:
        return
    found: SingleWheel = order.results["wheel"]
    yield Datum(tr("kind of the wheel"), text=tr("ring") if found.task.kind == "internal" else tr("external"))
    yield from data_of(dict(given_of_wheel(found)))
    task, measured = found.task, found.task.measuring
    yield from _rounding(task, str)
    if not task.undercut:
        yield Datum(tr("undercut"), text=tr("none"))
    if task.tip_thickness:
        yield Datum(tr("least thickness of the tips, in modules"), (), (task.tip_thickness,))
    if measured.span_teeth is not None:
        yield Datum(tr("number of teeth in the span"), ("z_w",), (float(measured.span_teeth),))
    if measured.ball is not None:
        said = tr("diameter of the pins") if measured.body == "pins" else tr("diameter of the balls")
        yield Datum(said, ("D",), (MM * measured.ball,), "mm")
    elif measured.body == "pins":
        yield Datum(tr("measured over"), text=tr("pins"))
    yield from _width(task, measured.rule, str)
    if task.circles:
        diameters = tuple(2 * MM * radius for radius in task.circles)
        yield Datum(tr("diameters of circles on which the tooth is asked for"), (), diameters, "mm")
