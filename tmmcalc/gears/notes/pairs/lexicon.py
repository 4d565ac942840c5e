"""The quantities of a pair and of a wheel alone by their names in formulas; lengths in mm, angles in degrees.

Names of a wheel have a place for its index, ``<_i>`` alone and ``<i>`` after other letters: ``r<_i>``, ``r_a<i>``. A
formula of both wheels of a pair has the index i and is worked out for 1 and 2; where they differ, as a ring does, each
has its own. Words stand for what differs in helical wheels, ``<t>`` is the transverse profile angle, and in internal
pairs, ``<+>`` and ``<->`` are signs.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import degrees, tan
from typing import NamedTuple

from tmmcalc.gears.involute.internal.ring import Ring, cutting
from tmmcalc.gears.involute.rack import Rack
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.meshing.angles import PairAngles, WheelAngles, helix_at, pair_angles, pressure_at
from tmmcalc.gears.meshing.geometry import pinion_on_rack, ring_of
from tmmcalc.gears.meshing.results import NOISE, MeshPair, WheelSizes
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.gears.single.results import SingleWheel
from tmmcalc.gears.single.task import WheelTask
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Lexicon, Line, Place
from tmmcalc.report.telling import filled, lines, named

DIGITS = 6  # of a result: thousandths of a millimetre
SPUR = {"t": "alpha", "sn": "s<_i>", "st": "s<_i>", "sta": "s_a<i>", "sna": "s_a<i>"}
HELICAL = {"t": "alpha_t", "sn": "s_n<i>", "st": "s_t<i>", "sta": "s_ta<i>", "sna": "s_na<i>"}
WHOLE = {"s1": "rho_p1", "s2": "rho_a2", "e1": "rho_a1", "e2": "rho_p2"}  # radii of curvature at the ends of contact
SHORT = {"s1": "rho_s1", "s2": "rho_s2", "e1": "rho_e1", "e2": "rho_e2"}
CUTTER = "z_0", "x_0", "rho_0"  # what is given of one
PLUS, MINUS = {"+": "+", "-": "-"}, {"+": "-", "-": "+"}


class Wheels(NamedTuple):
    """Wheels that have their formulas in common."""

    numbers: tuple[int, ...]  # of the wheels in their pair, from 0
    places: tuple[Place, ...]
    words: Mapping[str, str]

    def lines(self, *texts: str) -> Iterator[Line]:
        """The formulas worked out for these wheels."""
        yield from worked_out(texts, self.places, self.words)

    def name(self, text: str) -> str:
        """A name with the index that these wheels have in their formulas."""
        return filled(text, self.words)


class Told(NamedTuple):
    """A pair with its quantities."""

    found: MeshPair
    lexicon: Lexicon
    words: Mapping[str, str]
    wheels: tuple[Wheels, ...]
    shared: tuple[Wheels, ...]  # the same for formulas that do not change their signs in a ring
    own: tuple[Lexicon, ...]  # of each wheel, by names with a place for its index

    def lines(self, *texts: str) -> Iterator[Line]:
        """Formulas of the pair worked out."""
        yield from worked_out(texts, (Place("", self.lexicon),), self.words)


def worked_out(texts: Sequence[str], places: Sequence[Place], words: Mapping[str, str]) -> Iterator[Line]:
    """Formulas in as many digits as sizes of teeth need."""
    for line in lines(texts, places, words):
        yield line._replace(digits=DIGITS)


def told_of(found: MeshPair) -> Told:
    """A pair with its quantities; those of a wheel are explained where its own formulas stand."""
    angles, style = pair_angles(found), words_of(found.task)
    own = tuple(
        of_wheel(size, size.teeth, size.shift) | of_flank(wheel)
        for size, wheel in zip(found.sizes, angles.wheels, strict=True)
    )
    silent: dict[str, Given] = {}
    for k, quantities in enumerate(own, 1):
        for name, given in indexed(quantities, str(k), style).items():
            silent[name] = given if name[0] in "zx" else given._replace(meaning="")
    lexicon = named(silent | of_pair(found, angles))
    words = _of_contact(found) | style
    wheels = tuple(_wheels(found, own, lexicon, style))
    shared = wheels if found.task.kind != "internal" else (_both(own, lexicon, style),)
    return Told(found, lexicon, words, wheels, shared, own)


def _of_contact(found: MeshPair) -> dict[str, str]:
    """Words of a pair: its signs, where its involutes end at the root, the ends of its contact."""
    internal = found.task.kind == "internal"
    words = {**(MINUS if internal else PLUS), "z": "(z_2 - z_1)" if internal else "(z_1 + z_2)"}
    both = "inv(alpha_tw)", "inv(<t>)"
    words["larger"], words["smaller"] = both[::-1] if internal else both
    for k, size in enumerate(found.sizes, 1):
        words[f"end{k}"] = f"rho_L{k}" if size.limit is not None and size.limit >= 0 else f"rho_F{k}"
    if found.task.kind == "rack":
        usual = abs(pinion_on_rack(found).addendum - found.task.rack.addendum) <= NOISE
        words["sna2"] = "s_na2" if found.task.helix else "s_a2"
        words["hr"] = "h_a^{*}" if usual else "h_R^{*}"
    return words | (SHORT if shortened(found) else WHOLE)


def shortened(found: MeshPair) -> bool:
    """Whether undercut or a fillet takes something from the contact of the whole flanks."""
    return found.shortened < found.contact_ratio - NOISE


def _both(own: Sequence[Lexicon], lexicon: Lexicon, style: Mapping[str, str]) -> Wheels:
    """Both wheels of a pair, whose formulas have the index i."""
    places = [Place("", lexicon | named(indexed(own[k], "i", style)), str(k + 1)) for k in (0, 1)]
    return Wheels((0, 1), tuple(places), {**of_index("i", style), **PLUS})


def _wheels(found: MeshPair, own: Sequence[Lexicon], lexicon: Lexicon, style: Mapping[str, str]) -> Iterator[Wheels]:
    """Both wheels together where their formulas are the same."""

    if found.task.kind == "external":
        yield _both(own, lexicon, style)
        return
    for k, size in enumerate(found.sizes):
        signs, index = MINUS if size.kind == "ring" else PLUS, str(k + 1)
        place = Place("", lexicon | named(indexed(own[k], index, style)), index)
        yield Wheels((k,), (place,), {**of_index(index, style), **signs})


def alone(found: SingleWheel) -> Wheels:
    """A wheel without a mate, whose quantities have no index."""
    task, style = found.task, words_of(found.task)
    helix = helix_at(found.tip, found.reference, task.helix)
    quantities = {
        **of_rack(task.rack),
        **of_section(task, found.angle_t, found.base_helix),
        **of_wheel(found, task.teeth, task.shift),
        **of_tip(pressure_at(found.tip, found.base), helix, found.base),
        **(of_cutter(task.ring, task.module) if task.kind == "internal" else {}),
    }
    if task.kind == "external" and found.pointed_shift is not None:
        quantities["x_max"] = Given(found.pointed_shift, "", tr("shift coefficient at which whole teeth are pointed"))
    words = {**of_index("", style), **(MINUS if task.kind == "internal" else PLUS)}
    return Wheels((0,), (Place("", named(indexed(quantities, "", style))),), words)


def words_of(task: PairTask | WheelTask) -> dict[str, str]:
    """Words of a helical or a spur wheel; the rack's straight flank ends at its addendum or has a depth of its own."""
    same = abs(task.rack.straight - task.rack.addendum) <= NOISE
    return {**(HELICAL if task.helix else SPUR), "hl": "h_a^{*}" if same else "h_l^{*}"}


def of_index(index: str, style: Mapping[str, str]) -> dict[str, str]:
    """Words of the formulas of a wheel with this index, empty for a wheel alone."""
    least = f"x_{{min,{index}}}" if index else "x_min"
    return {**style, "xmin": least, "_i": f"_{index}" if index else "", "i": index}


def indexed(quantities: Lexicon, index: str, style: Mapping[str, str]) -> dict[str, Given]:
    """The quantities of a wheel with its index."""
    words = of_index(index, style)
    return {filled(name, words): given for name, given in quantities.items()}


def length(value: float, meaning: str = "") -> Given:
    """A length [m] in mm."""
    return Given(1e3 * float(value), "mm", meaning)


def angle(value: float, meaning: str = "") -> Given:
    """An angle [rad] in degrees."""
    return Given(degrees(value), "deg", meaning)


def of_rack(rack: Rack) -> dict[str, Given]:
    """The basic rack; its straight flank is as deep as its addendum unless it has a rounding of its own."""
    return {
        "alpha": angle(rack.angle, tr("profile angle of the rack")),
        "h_a^{*}": Given(rack.addendum, "", tr("addendum coefficient")),
        "h_l^{*}": Given(rack.straight, "", tr("depth of the straight flank of the rack in modules")),
        "c^{*}": Given(rack.clearance, "", tr("clearance coefficient")),
        "rho^{*}": Given(rack.radius, "", tr("radius of the rounding of the rack in modules")),
    }


def of_cutter(ring: Ring, module: float) -> dict[str, Given]:
    """The cutter of a ring and their mesh; ``module`` [m]."""
    cutter = ring.cutter
    if cutter is None:
        return {}
    generating, distance, tip = cutting(ring, cutter)
    base = Wheel(cutter.teeth, 0.0, ring.helix, ring.rack).base
    return {
        "z_0": Given(float(cutter.teeth), "", tr("number of teeth of the cutter")),
        "x_0": Given(cutter.shift, "", tr("shift coefficient of the cutter")),
        "alpha_tw0": angle(generating, tr("pressure angle of the cutter in the ring")),
        "a_w0": length(module * distance, tr("centre distance of the cutter and the ring")),
        "r_a0": length(module * tip, tr("tip radius of the cutter")),
        "r_b0": length(module * base, tr("base radius of the cutter")),
        "rho_0": length(module * cutter.rounding, tr("radius of the rounding of the cutter’s tip")),
    }


def of_section(task: PairTask | WheelTask, transverse: float, base_helix: float) -> dict[str, Given]:
    """Module, helix, transverse section, face width."""
    width = {} if task.face_width is None else {"b": length(task.face_width, tr("face width"))}
    return width | {
        "m": length(task.module, tr("module")),
        "beta": angle(abs(task.helix), tr("helix angle")),
        "m_t": length(task.module * task.section.module, tr("transverse module")),
        "alpha_t": angle(transverse, tr("transverse profile angle")),
        "beta_b": angle(abs(base_helix), tr("base helix angle")),
    }


def of_pair(found: MeshPair, angles: PairAngles) -> dict[str, Given]:
    """What both wheels have in common, what is given of each, and where their contact begins and ends."""
    task, line = found.task, found.line
    begins, ends = tr("radius of curvature where the contact begins"), tr("radius of curvature where the contact ends")
    quantities = of_rack(task.rack) | of_section(task, found.angle_t, found.base_helix)
    quantities |= {
        "x_Sigma": Given(found.shift_sum, "", tr("sum of the shift coefficients")),
        "alpha_tw": angle(found.angle_w, tr("operating pressure angle")),
        "y": Given(found.modification, "", tr("centre distance modification coefficient")),
        "Deltay": Given(found.shortening, "", tr("tip shortening coefficient")),
        "p_b": length(angles.base_pitch, tr("transverse base pitch")),
        "g_alpha": length(angles.path, tr("length of the active part of the line of action")),
        "eps_alpha": Given(found.contact_ratio, "", tr("transverse contact ratio")),
        "eps'_alpha": Given(found.shortened, "", tr("transverse contact ratio of the flanks that are left")),
        "eps_beta": Given(found.overlap, "", tr("overlap ratio")),
        "eps_gamma": Given(found.total, "", tr("total contact ratio")),
        "rho_p1": length(line.start, tr("radius of curvature where the active flank of wheel 1 ends")),
        "rho_s1": length(line.begins, begins),
        "rho_e1": length(line.ends, ends),
        "c_1": length(found.clearances[0], tr("clearance at the root of the wheel")),
        "c_2": length(found.clearances[1], tr("clearance at the root of the wheel")),
    }
    if task.kind == "rack":
        return quantities | of_peaks(found) | _of_rack(found, angles)
    side = -1 if task.kind == "internal" else 1
    if task.kind == "internal":
        quantities |= of_cutter(ring_of(task, found.shifts[1]), task.module)
    assert angles.ratio is not None
    return (
        quantities
        | {
            "u": Given(angles.ratio, "", tr("ratio of the teeth")),
            "a": length(found.reference_distance, tr("reference centre distance")),
            "a_w": length(found.distance, tr("operating centre distance")),
            "g": length(line.between, tr("length of the line of action between the base circles")),
            "rho_p2": length(
                line.between - side * line.end, tr("radius of curvature where the active flank of wheel 2 ends")
            ),
            "rho_s2": length(line.between - side * line.begins, begins),
            "rho_e2": length(line.between - side * line.ends, ends),
        }
        | of_peaks(found)
    )


def _of_rack(found: MeshPair, angles: PairAngles) -> dict[str, Given]:
    """The rack of a pinion."""
    assert angles.rack_addendum is not None
    checks = {(check.name, check.wheel): check for check in found.checks}
    deepest, m = checks["interference", 2].limit, found.task.module
    assert deepest is not None
    return {
        "H": length(found.distance, tr("distance of the datum line of the rack from the axis")),
        "h_R^{*}": Given(angles.rack_addendum, "", tr("addendum of the rack in modules")),
        "rho_R": length(m * deepest, tr("radius of curvature at the end of the straight flank of the rack")),
        "s_na2" if found.task.helix else "s_a2": length(
            m * checks["tip thickness", 2].value, tr("tooth thickness of the rack at its tip")
        ),
    }


def of_peaks(found: MeshPair) -> dict[str, Given]:
    """Sliding and pressure where the contact begins, at the pitch point and where it ends; none without contact."""
    peaks = found.peaks_left if shortened(found) else found.peaks
    if peaks is None:
        return {}
    return {
        "theta_1": Given(peaks.theta1, "", tr("specific sliding of wheel 1 where the contact begins")),
        "theta_2": Given(peaks.theta2, "", tr("specific sliding of wheel 2 where the contact ends")),
        "lambda_s": Given(peaks.pressure_start, "", tr("coefficient of specific pressure where the contact begins")),
        "lambda_P": Given(peaks.pressure_pitch, "", tr("coefficient of specific pressure at the pitch point")),
        "lambda_e": Given(peaks.pressure_end, "", tr("coefficient of specific pressure where the contact ends")),
    }


def of_wheel(size: WheelSizes | SingleWheel, teeth: int, shift: float) -> dict[str, Given]:
    """The circles and the teeth of a wheel, with places for its index."""
    arc = tr("transverse tooth thickness on the reference circle")
    end = size.base * tan(pressure_at(size.form, size.base) or 0.0)
    found = {
        "z<_i>": Given(float(teeth), "", tr("number of teeth")),
        "x<_i>": Given(float(shift), "", tr("shift coefficient")),
        "r<_i>": length(size.reference, tr("reference radius")),
        "r_b<i>": length(size.base, tr("base radius")),
        "r_a<i>": length(size.tip, tr("tip radius")),
        "r_f<i>": length(size.root, tr("root radius")),
        "r_F<i>": length(size.form, tr("radius where the involute ends")),
        "rho_F<i>": length(end, tr("radius of curvature where the involute ends")),
        "h<_i>": length(abs(size.tip - size.root), tr("tooth height")),
        "d<_i>": length(2 * size.reference, tr("reference diameter")),
        "d_b<i>": length(2 * size.base, tr("base diameter")),
        "d_a<i>": length(2 * size.tip, tr("tip diameter")),
        "d_f<i>": length(2 * size.root, tr("root diameter")),
        "<st>": length(size.arc, arc),
        "<sn>": length(size.thickness, tr("tooth thickness on the reference circle")),
        "<sta>": length(size.tip_arc, tr("transverse tooth thickness on the tip circle")),
        "<sna>": length(size.tip_thickness, tr("tooth thickness on the tip circle")),
        "psi<_i>": angle(size.half_angle, tr("half the angle of the tooth on the reference circle")),
    }
    if size.least_shift is not None and size.limit is not None:
        found["<xmin>"] = Given(size.least_shift, "", tr("least shift coefficient without undercut"))
        found["rho_L<i>"] = length(size.limit, tr("radius of curvature at the limit point of the involute"))
    if isinstance(size, WheelSizes):
        found["r_w<i>"] = length(size.operating, tr("pitch radius"))
        found["d_w<i>"] = length(2 * size.operating, tr("pitch diameter"))
    return found


def of_flank(wheel: WheelAngles) -> dict[str, Given]:
    """The flank of a wheel of a pair: where it ends at the tip and at the root, and its pitch point."""
    return of_tip(wheel.tip_angle, wheel.tip_helix, wheel.base) | {
        "rho_w<i>": length(wheel.pitch_curvature, tr("radius of curvature at the pitch point")),
    }


def of_tip(pressure: float | None, helix: float, base: float) -> dict[str, Given]:
    """The involute at the tip circle; nothing of one within the base circle."""
    if pressure is None:
        return {}
    return {
        "alpha_a<i>": angle(pressure, tr("profile angle at the tip circle")),
        "beta_a<i>": angle(helix, tr("helix angle at the tip circle")),
        "rho_a<i>": length(base * tan(pressure), tr("radius of curvature at the tip")),
    }
