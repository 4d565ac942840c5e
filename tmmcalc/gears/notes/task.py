"""What is given of a gear train: its layout, the ratio that is asked for, the numbers of planets, the steel."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.gears.notes.strength import steel_word
from tmmcalc.gears.pictures.words import layout_word
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Datum


def blocks(order: Order) -> Iterator[Block]:
    """The data; those of pairs and wheels stand with their chapters."""
    train, strength = order.spec.train, order.spec.strength
    if train is None:
        return
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
