"""What the strength and the working of the cam ask: pin, slip, contact, shaft, stem, guide; all limits in a table."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.cams.notes.lexicon import quantities_table, table_rows
from tmmcalc.cams.notes.loaded.carrying import shaft, stem
from tmmcalc.cams.notes.loaded.judged import Judging
from tmmcalc.cams.notes.loaded.margins import margins
from tmmcalc.cams.notes.loaded.quantities import loaded_of
from tmmcalc.cams.notes.loaded.roller import contact, pin, rolling_blocks
from tmmcalc.cams.pictures.cam_strength import draw_requirements
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Figure, Heading, Paragraph, Table
from tmmcalc.report.telling import WIDE, tabulated

GIVEN = (  # without the limits of the profile, which stand with its sizes
    *("b", "E_n", "sigma_HP", "k_r", "f_r", "f_0", "p_0P", "alpha_2", "alpha_0", "rho_s", "l_s", "sigma_FP", "Delta_P"),
    *("E", "alpha_e", "r_T", "l_H", "p_gP"),
)
NEEDS = {  # without what these are not given
    "E_n": "b",
    "alpha_2": "p_0P",
    "alpha_0": "r_0",
    "rho_s": "C_1",
    "f_0": "C_1",
    "E": "Delta_P",
    "alpha_e": "l_s",
}
HIGH = 45.0  # of one diagram [mm]


def blocks(order: Order) -> Iterator[Block]:
    """The requirements of the cam of the spec, as far as there are data."""
    of = Judging(loaded_of(order), order.results["cam_strength"])
    yield Heading(tr("Strength and working of the cam mechanism"))
    scene = of.scene
    names = [name for name in GIVEN if name in scene and (name not in NEEDS or NEEDS[name] in scene)]
    if names:
        yield Paragraph(tr("The given data of the requirements are in table {tab:cam_needs}."))
        yield quantities_table(tr("Given data of the requirements"), names, scene, "cam_needs")
    yield from pin(of)
    yield from rolling_blocks(of)
    yield from shaft(of)
    yield from stem(of)
    yield from contact(of, order.spec.cam.requirements.material)
    yield from _course(of)
    yield from margins(of)


def _course(of: Judging) -> Iterator[Block]:
    """The table over the turn, and the diagrams."""
    table = _table(of)
    if table is not None:
        yield Heading(tr("Requirements over the turn"), 3)
        yield Paragraph(tr("The values that are judged stand in table {tab:cam_judged}, for the positions $i$."))
        yield table
    found = of.found
    count = sum(values is not None for values in (found.slip, found.stress, found.reduced))
    if count:
        yield Paragraph(tr("Figure {fig:cam_requirements} shows their course over the turn."))
        draw = partial(draw_requirements, task=of.of.task, result=found)
        yield Figure(tr("Requirements over the turn"), draw, (WIDE, count * HIGH + 10.0), "cam_requirements")


def _table(of: Judging) -> Table | None:
    """What is judged in the positions; a dash where nothing presses on the roller."""
    found, rows = of.found, table_rows(of.of.told)
    slip = None if found.slip is None else np.where(found.touching, found.slip, np.nan)
    values = {
        "$D$": (slip, 1.0),
        "$sigma_H$, MPa": (found.stress, 1e-6),
        "$M_E$, N·m": (found.reduced, 1.0),
        "$sigma_F$, MPa": (found.bending, 1e-6),
        "$p_g$, MPa": (found.pressure, 1e-6),
    }
    columns = {name: factor * each[rows] for name, (each, factor) in values.items() if each is not None}
    if not columns:
        return None
    shown = {"$phi$, deg": np.degrees(found.positions.phi)[rows], **columns}
    labels = [found.positions.labels[row] for row in rows]
    caption = tr("Values over the turn")
    return tabulated(caption, shown, labels, head="$i$", key="cam_judged")
