"""The picture of the elastic follower: accelerations and load over the turn, residual vibration of the laws."""

from __future__ import annotations

from math import degrees

import numpy as np

from tmmcalc.cams.elastic import ElasticResult
from tmmcalc.cams.pictures.cam_forces import LOST
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.pictures.wording import phase_name
from tmmcalc.cams.separation import Contact
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import input_axis
from tmmcalc.report.drawing.diagram import Axis
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.panels import Panel, panels
from tmmcalc.report.drawing.pens import INK, OTHER, Pen
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.numbers import number

WALL = "#e4e4e4"
LOWEST, TOP = 1e-4, 2.0  # of the spectra's amplitude that are drawn, parts of the stroke
OWN = Pen("OWN_RATIO", 0.3, (2.4, 0.9))
HEAD = 12.0  # room of the heading [mm]


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return elastic_drawing(cam_of(order), order.results["cam_elastic"])


def elastic_drawing(task: CamTask, result: ElasticResult) -> Drawing:
    """Two sheets: the turn, and the spectra."""
    drawing, (first, second) = sheets(2)
    multiple = number(result.multiple, 5)
    heading = tr("Elastic follower, natural frequency {multiple} times that of the cam", multiple=multiple)
    heading += _shaded(result.contact)
    drawing.add(Words(complex(first.middle.real, first.top), heading, 3.2, 1j))
    draw_vibration(drawing, first.inset(3, 0, 0, HEAD), task, result)
    text = tr("Residual vibration after a rise from rest")
    drawing.add(Words(complex(second.middle.real, second.top), text, 3.2, 1j))
    draw_spectra(drawing, second.inset(3, 0, 0, 6), result)
    return drawing


def draw_vibration(drawing: Drawing, box: Box, task: CamTask, result: ElasticResult) -> None:
    """Accelerations and load over the turn; where the follower leaves the cam is shaded."""
    phi = np.degrees(result.phi)
    unit, force = (tr_unit(each) for each in (("rad/s²", "N*m") if result.turns else ("m/s²", "N")))
    rows = [
        Panel(
            tr("acceleration, {unit}", unit=unit),
            ((tr("of the mass"), result.response), (tr("of the cam's law"), result.given)),
        ),
        Panel(
            tr("load along the lift $P_c$, {unit}", unit=force),
            ((tr("elastic train"), result.load), (tr("rigid train"), result.rigid)),
        ),
    ]
    upper, lower = panels(drawing, box, phi, input_axis(True, phi), rows)
    colour = LOST if result.contact.closure == "force" else WALL
    for begin, end in result.contact.beyond if result.contact.judged else ():
        lower.band(degrees(begin), degrees(end), colour)
    for diagram in (upper, lower):
        for start in np.degrees(task.program.starts[1:-1]).tolist():
            diagram.vertical(start, OTHER)


def _shaded(contact: Contact) -> str:
    """What is shaded, as a second line of the heading."""
    if not contact.beyond or not contact.judged:
        return ""
    if contact.lost:
        return "\n" + tr("shaded: the follower leaves the cam")
    return "\n" + tr("shaded: the outer wall of the groove presses")


def draw_spectra(drawing: Drawing, box: Box, result: ElasticResult) -> None:
    """Amplitude over the stroke by the ratio of phase time and natural period; the cam's own ratio is marked."""
    along = Axis(tr("time of the phase over the natural period"), 0.0, float(result.ratios[-1]))
    lines = tuple((tr_name(each.law), each.residual) for each in result.spectra)
    row = Panel(tr("amplitude over the stroke"), lines, log=True, ends=(LOWEST, TOP))
    (diagram,) = panels(drawing, box, result.ratios, along, [row])
    for phase in result.phases:
        if phase.ratio < result.ratios[-1]:
            diagram.vertical(phase.ratio, OWN)
            at = diagram.place(complex(phase.ratio, TOP)) - 1j * (3.0 if phase.kind == "rise" else 7.0)
            words = f"{phase_name(phase.kind)}: {number(phase.ratio, 4)}"
            drawing.add(Words(at + 1.5, words, 2.5, -1, colour=INK, clear=True), level=20)
