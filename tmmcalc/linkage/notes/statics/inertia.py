"""Weights, inertia forces and couples of the links that have mass (textbook 3.1, table D.2.2)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.freebody import FreeBody
from tmmcalc.linkage.loading import Body
from tmmcalc.linkage.loads.sources import inertia_load
from tmmcalc.linkage.notes.group import plain_name
from tmmcalc.linkage.notes.statics.loaded import NOTHING, Loaded, packed
from tmmcalc.linkage.pins import find_pins
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Paragraph
from tmmcalc.report.telling import located, named, tabulated, vector


def inertia(loaded: Loaded) -> Iterator[Block]:
    """The formulas of every link at the shown positions, then the loads of inertia at all of them."""
    if not loaded.loading.heavy:
        return
    yield Heading(tr("Weights and loads of inertia"), 2)
    said = tr(
        "The inertia force acts at the centre of mass against its acceleration, the inertia couple against the "
        "angular acceleration of the link."
    )
    yield Paragraph(said)
    pins = find_pins(loaded.told.chain.mechanism)
    for body in loaded.loading.heavy:
        link = body.link
        at = next((plain_name(pin.name) for pin in pins if pin.at.get(link) == body.center), None)
        places = {"k": str(link), "S": at or ""}
        for lexicon, each in zip(loaded.told.lexicons, loaded.bodies, strict=True):
            lexicon |= named(_quantities(loaded, body, each[link]))
        texts = []
        if abs(loaded.loading.gravity):
            texts.append("G_<k> = m_<k>*g")
        if at is not None:
            texts += ["P_{<k>x} = -m_<k>*a_{<S>x}", "P_{<k>y} = -m_<k>*a_{<S>y}"]
        yield from loaded.lines([*texts, "M_<k> = -J_<k>*eps_<k>"], places)
    yield from _tables(loaded)


def _quantities(loaded: Loaded, body: Body, found: FreeBody) -> dict[str, Given]:
    """Mass, inertia and weight of a link, its loads of inertia without what is rounding."""
    loading, link = loaded.loading, body.link
    force = loaded.clean(next((f.value for f in found.forces if f.kind == "inertia"), 0j))
    couple = next((c.value for c in found.couples if c.kind == "inertia"), 0.0)
    centre = tr("moment of inertia of link {link} about its centre of mass", link=link)
    return {
        f"m_{link}": Given(body.mass, "kg", tr("mass of link {link}", link=link)),
        f"J_{link}": Given(body.inertia, "kg*m^2", centre),
        "g": Given(abs(loading.gravity), "m/s^2", tr("acceleration of gravity")),
        f"G_{link}": Given(body.mass * abs(loading.gravity), "N", tr("weight of link {link}", link=link)),
        **vector(f"P_{{{link}%}}", force, "N", tr("inertia force of link {link}", link=link)),
        f"M_{link}": Given(couple, "N*m", tr("inertia couple of link {link}", link=link)),
    }


def _tables(loaded: Loaded) -> Iterator[Block]:
    """The loads of inertia at all positions, some links to a table; what is nothing everywhere is left out."""
    labels = loaded.result.labels
    whole = [k for k, label in enumerate(labels) if not label.endswith("-")]  # inertia does not jump with friction
    columns = [each for body in loaded.loading.heavy if (each := _columns(loaded, body, whole))]
    parts = [*packed(columns)] if columns else []
    if parts:
        caption, rows = tr("Inertia forces and couples of the links"), [labels[row] for row in whole]
        tables = [
            tabulated(caption, part, rows, head=tr("No."), key=f"forces_inertia_{k}") for k, part in enumerate(parts)
        ]
        yield Paragraph(tr("Their values at all positions are {where}.", where=located(tables)))
        yield from tables


def _columns(loaded: Loaded, body: Body, rows: list[int]) -> dict[str, Real]:
    """The columns of a link, without what is nothing."""
    place, travel = loaded.every.place, loaded.statics.scene.travel
    load = inertia_load(body, place.configuration.motions[body.link], travel.speed, travel.acceleration)
    force = np.broadcast_to(load.force, loaded.result.theta.shape)[rows]
    couple = np.broadcast_to(load.couple, loaded.result.theta.shape)[rows]
    found = {
        f"$P_{{{body.link}x}}$, N": force.real,
        f"$P_{{{body.link}y}}$, N": force.imag,
        f"$M_{{{body.link}}}$, N*m": couple,
    }
    largest = max(float(np.max(np.abs(force))), NOTHING)
    return {
        head: np.where(np.abs(values) > NOTHING * largest, values, 0.0)
        for head, values in found.items()
        if np.max(np.abs(values)) > NOTHING * largest
    }
