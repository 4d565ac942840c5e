"""What carries cam and follower: the camshaft by strength and stiffness, the stem, its guide."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.cams.notes.lexicon import mm
from tmmcalc.cams.notes.loaded.judged import Judging
from tmmcalc.cams.notes.loaded.quantities import Found
from tmmcalc.cams.strength.formulas import guide_pressure, reduced_moment, stem_moment, stem_stress
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Paragraph
from tmmcalc.report.telling import plainly

REDUCED = "M_E = sqrt((R*l_s/(4*10**3))**2 + alpha_e*T**2)"
STRENGTH = "r'_1 = (4*10**3*M_E/(pi*sigma_FP))**(1/3)"
STIFFNESS = "r''_1 = (R_max*l_s**3/(12*pi*E*Delta_P))**(1/4)"


def shaft(of: Judging) -> Iterator[Block]:
    """r1' at the largest reduced moment, r1'' at the largest force, the whole millimetre above (5.73 to 5.78)."""
    found = of.found.shaft
    if found is None:
        return
    yield Heading(tr("Camshaft"), 3)
    yield Paragraph(tr("The camshaft lies on two supports with the cam in the middle."))
    radii: Lexicon = {"r_1^{*}": mm(found.radius, tr("least radius of the camshaft, in whole millimetres"))}
    if found.strength is not None and found.moment is not None and found.moment_phi is not None:
        place = of.of.where(found.moment_phi, found.moment, lambda place: _reduced(of, place))
        yield Paragraph(tr("Bending and torque together are largest {where}:", where=place))
        there = of.of.found(found.moment_phi, found.moment, lambda place: _reduced(of, place))
        radii["r'_1"] = mm(found.strength, tr("radius of the camshaft by its strength"))
        yield from of.lines([REDUCED, STRENGTH], of.at(there, reduced=found.moment) | radii)
        rubbed = found.moment_rubbed
        if rubbed is not None and rubbed > found.moment * (1 + 1e-9):
            yield Paragraph(tr("With the torque that friction adds it would be {moment} N·m.", moment=plainly(rubbed)))
    if found.stiffness is not None:
        yield Paragraph(tr("The deflection under the largest force asks for"))
        radii["r''_1"] = mm(found.stiffness, tr("radius of the camshaft by its stiffness"))
        yield from of.lines([STIFFNESS], radii)
    known = [name for name in ("r'_1", "r''_1") if name in radii]
    larger = f"max({known[0]}, {known[1]})" if len(known) > 1 else known[0]
    yield Paragraph(tr("The radius is rounded up to a whole millimetre:"))
    yield from of.lines([f"r_1^{{*}} = ceil({larger})"], radii)


def _reduced(of: Judging, found: Found) -> np.ndarray:
    """M_E at points."""
    return reduced_moment(found.now.contact, found.now.torque, of.needs.span or 0.0, of.needs.torsion)


def stem(of: Judging) -> Iterator[Block]:
    """Bending at the lower edge of the guide and the pressure of its edges (5.79, fig. 5.26)."""
    bent, pressed = of.margin("bending of the stem"), of.margin("pressure in the guide")
    if bent is None and pressed is None:
        return
    yield Heading(tr("Stem and guide"), 3)
    if bent is not None and bent.phi is not None and bent.value is not None:
        place = of.of.where(bent.phi, bent.value, lambda found: _bending(of, found))
        yield Paragraph(tr("The bending moment of the stem is largest {where}:", where=place))
        there = of.of.found(bent.phi, bent.value, lambda found: _bending(of, found))
        moment = "abs(R*S')" if of.of.kind == "flat" else "abs(R*sin(theta)*q)"
        texts = (f"M_T = {moment}/10**3", "sigma_F = 4*10**3*M_T/(pi*r_T**3)")
        yield from of.lines(texts, of.at(there, bending=bent.value))
    if pressed is not None and pressed.phi is not None and pressed.value is not None:
        place = of.of.where(pressed.phi, pressed.value, lambda found: _pressure(of, found))
        yield Paragraph(tr("The larger reaction of the guide is largest {where}:", where=place))
        there = of.of.found(pressed.phi, pressed.value, lambda found: _pressure(of, found))
        lower, upper = (abs(float(each[0])) for each in (there.now.lower, there.now.upper))
        edge = "N_1" if lower >= upper else "N_2"
        yield from of.lines([f"p_g = abs({edge})/(2*l_H*r_T)"], of.at(there, pressure=pressed.value))


def _bending(of: Judging, found: Found) -> np.ndarray:
    """sigma_F [Pa] at points."""
    now, radius = found.now, of.of.task.guide.stem or 1.0
    moment = stem_moment(of.found.follower, found.points.motion, now.contact, now.sine, now.protrusion)
    return np.asarray(stem_stress(moment, radius))


def _pressure(of: Judging, found: Found) -> np.ndarray:
    """The larger pressure [Pa] of both edges at points."""
    guide, now = of.of.task.guide, found.now
    edge = np.maximum(np.abs(now.lower), np.abs(now.upper))
    return np.asarray(guide_pressure(edge, guide.land or 1.0, guide.stem or 1.0))
