"""The best sizes of the cam: what is sought, what was found against the synthesis, constraints, blocking contour."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from math import degrees

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.formulas import resultant
from tmmcalc.cams.forces.turn import at_rows, loads_of
from tmmcalc.cams.notes.lexicon import angle, mm, of_follower
from tmmcalc.cams.notes.loaded.best import (
    Size,
    constraints,
    game,
    relaxations,
    search,
    sizes_of,
    sizes_table,
    sought,
)
from tmmcalc.cams.notes.loaded.judged import of_needs
from tmmcalc.cams.optimum.margins import Judged, judge
from tmmcalc.cams.optimum.options import changed, variants
from tmmcalc.cams.optimum.results import CamOptimum, Choice, FlatChart
from tmmcalc.cams.optimum.rocker import follower_of
from tmmcalc.cams.optimum.rockersizes import Sizes, judge_rocker, rocker_scene
from tmmcalc.cams.optimum.scene import Phases, scene_of
from tmmcalc.cams.pictures.cam_optimum import contour_heading, draw_chart, draw_contour, draw_section, section_heading
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.rounding import sides
from tmmcalc.cams.task import CamTask, Optimum
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Figure, Heading, Lexicon, Paragraph, Place, Result
from tmmcalc.report.telling import WIDE, lines, named, titled

NAMES = (1.0, 3.0, 1.0, 0.0)  # room that names of axes take around a diagram [mm]
CONTOUR, SECTION, CHART = (WIDE, 105.0), (WIDE, 100.0), (WIDE, 95.0)  # sizes of the pictures [mm]


def blocks(order: Order) -> Iterator[Block]:
    """The search of the spec with what it found."""
    result: CamOptimum = order.results["cam_optimum"]
    follower: Follower = order.results["cam_synthesis"].follower
    task = _task(order, result)
    forces = order.results.get("cam_forces")
    guide = None if forces is None else forces.guide
    yield Heading(tr("Best sizes of the cam mechanism"))
    sizes = sizes_of(result, follower, guide and guide.top, guide and guide.length)
    yield from sought(result, task, sizes)
    yield from search(result)
    yield from sizes_table(sizes)
    yield from _worked(task, follower, result)
    if result.flat is not None:
        yield from _chart(task, result, result.flat)
    yield from constraints(result, concave=task.limits.allow_concave)
    yield from _pressed(task, result)
    yield from relaxations(result)
    yield from _pictures(result)
    yield from game(result)
    yield from _results(sizes)


def _task(order: Order, result: CamOptimum) -> CamTask:
    """What the result is of: the cam as asked, or with the changes of the option that is shown."""
    task = cam_of(order)
    if not result.shown:
        return task
    options = variants(task, task.optimum or Optimum())
    return changed(task, next(each for each in options if tuple(one.words for one in each) == result.shown))


def _worked(task: CamTask, follower: Follower, result: CamOptimum) -> Iterator[Block]:
    """What follows from the sizes, in whole steps and of any sizes: the guide or the triangle, pin, shaft, pressure."""
    choices = (result.chosen, result.least)
    phases: Phases = "rise" if result.phases == "rise" else "turn"
    if result.kind == "flat":
        own = [_flat_sizes(task, follower, choice) for choice in choices]
        texts: list[str] = ["l = H_2 - S_0 - h - Delta_g"]
    elif result.kind == "oscillating":
        of = rocker_scene(task, follower, phases)
        four = Sizes(*(np.array([getattr(c, key) for c in choices]) for key in ("length", "start", "roller", "height")))
        found = judge_rocker(of, four)
        own = [
            _rocker_sizes(task, follower, choice, of.top, float(found.reach[k])) | _loaded(task, found.shared, k)
            for k, choice in enumerate(choices)
        ]
        texts = [
            "psi_0 = acos((l_0**2 + l_2**2 - R_0**2)/(2*l_0*l_2))",
            "r_max = sqrt(l_0**2 + l_2**2 - 2*l_0*l_2*cos(psi_0 + psi_max)) - r_2",
        ]
    else:
        scene = scene_of(task, follower, phases)
        sizes = (np.array([getattr(choice, key) for choice in choices]) for key in ("start", "roller", "height"))
        shared = judge(scene, *sizes)
        own = [_stem_sizes(task, follower, choice) | _loaded(task, shared, k) for k, choice in enumerate(choices)]
        texts = ["l = H_2 - S_0 - h - r_2 - Delta_g", "R_0 = sqrt(S_0**2 + e**2)"]
    names = (tr("in whole steps"), tr("of any sizes"))
    places = [Place(name, named(of_needs(task) | each)) for name, each in zip(names, own, strict=True)]
    yield Paragraph(tr("From these sizes follow:"))
    yield from lines([*texts, *_strong(task, places)], places)


def _strong(task: CamTask, places: list[Place]) -> list[str]:
    """Formulas of pin, shaft and guide at the largest forces of the turn, as far as they have data."""
    needs, guide, known = task.requirements, task.guide, places[0].lexicon
    if "R_max" not in known:
        return []
    texts = []
    if needs.pin is None and needs.pin_pressure is not None:
        texts.append("r_0 = sqrt(R_max/(alpha_2*p_0P))/2")
    if "r_2^{*}" in known:
        texts.append("r_2^{*} = alpha_0*r_0")
    if "r''_1" in known:
        texts.append("r''_1 = (R_max*l_s**3/(12*pi*E*Delta_P))**(1/4)")
    radii = ", ".join(name for name in ("r'_1", "r''_1", "r_1") if name in known)
    if radii:
        texts.append(f"r_1^{{*}} = ceil(max({radii}))" if "," in radii else f"r_1^{{*}} = ceil({radii})")
    if "N_max" in known and guide.stem is not None and guide.land is not None:
        texts.append("p_g = N_max/(2*l_H*r_T)")
    return texts


def _loaded(task: CamTask, found: Judged, k: int) -> Lexicon:
    """The largest forces of the turn and the radii by them."""
    needs = task.requirements
    own: Lexicon = {"R_max": Given(float(found.contact[k]), "N", tr("largest force of the cam"))}
    if needs.pin is not None or needs.pin_pressure is not None:
        own["r_0"] = mm(float(found.pin[k]), tr("radius of the pin"))
        own["r_2^{*}"] = mm(float(found.roller[k]), tr("least radius of the roller"))
    strong, stiff, whole = (float(each) for each in found.shaft[:, k])
    if strong:
        own["r'_1"] = mm(strong, tr("radius of the camshaft by its strength"))
    if stiff:
        own["r''_1"] = mm(stiff, tr("radius of the camshaft by its stiffness"))
    if whole:
        own["r_1^{*}"] = mm(whole, tr("least radius of the camshaft, in whole millimetres"))
    if task.guide.stem is not None and task.guide.land is not None and found.edge[k]:
        own["N_max"] = Given(float(found.edge[k]), "N", tr("largest reaction of the guide"))
        own["p_g"] = Given(1e-6 * float(found.pressure[k]), "MPa", tr("pressure in the guide"))
    return own


def _flat_sizes(task: CamTask, follower: Follower, choice: Choice) -> Lexicon:
    return {
        "H_2": mm(choice.height, tr("height of the upper edge of the guide above the axis of the cam")),
        "S_0": mm(choice.start, of_follower(follower)["S_0"].meaning),
        "l": mm(choice.length, tr("length of the guide")),
        "h": mm(task.program.highest, tr("stroke")),
        "Delta_g": mm(task.guide.gap, tr("gap between the roller at its highest and the guide")),
    }


def _stem_sizes(task: CamTask, follower: Follower, choice: Choice) -> Lexicon:
    return _flat_sizes(task, follower, choice) | {
        "r_2": mm(choice.roller, tr("radius of the roller")),
        "e": of_follower(follower)["e"],
        "R_0": mm(float(np.hypot(choice.start, follower.offset)), tr("radius of the base circle of the pitch curve")),
    }


def _rocker_sizes(task: CamTask, follower: Follower, choice: Choice, top: float, reach: float) -> Lexicon:
    found = of_follower(follower_of(follower, choice))
    found["psi_max"] = angle(top, tr("largest angle of the rocker from its lowest position"))
    return found | {"r_max": mm(reach, tr("largest radius of the working profile"))}


def _chart(task: CamTask, result: CamOptimum, chart: FlatChart) -> Iterator[Block]:
    """S0 by convexity, the length of the guide by its pressure, the least height (fig. 5.37)."""
    loads, needs, guide = loads_of(task), task.requirements, task.guide
    start, force = result.least.start, named(of_needs(task))
    found = {
        "F_min": mm(chart.convexity, tr("least sum of the displacement and its second derivative")),
        "S_{0,min}": mm(chart.least_start, tr("least start distance by convexity")),
        "l^{*}": mm(chart.least_length, tr("least length of the guide by its pressure")),
        "H_{2,min}": mm(chart.least_height, tr("least height by convexity and guide")),
        "h": mm(chart.stroke, tr("stroke")),
        "Delta_g": mm(chart.gap, tr("gap between the roller at its highest and the guide")),
        "f_T": Given(loads.friction, "", tr("coefficient of friction of the stem in its guide")),
    }
    lexicon = force | named(found)
    yield Paragraph(tr("Convexity of the profile asks for a start distance, whatever the height:"))
    yield from lines(["F_min = DeltaS + S''"], [Place("", lexicon | _there(task, result, chart.phi, chart.convexity))])
    if chart.least_start > 0:
        yield from lines(["S_{0,min} = r_m - F_min"], [Place("", lexicon)])
    assert needs.guide_pressure is not None
    assert guide.stem is not None
    assert guide.land is not None
    limit = 2 * guide.land * guide.stem * needs.guide_pressure
    lexicon |= named({"N_P": Given(limit, "N", tr("permissible reaction of an edge of the guide"))})
    yield Paragraph(tr("The pressure in the guide asks for a length, which is largest where"))
    yield from lines(["N_P = 2*l_H*r_T*p_gP"], [Place("", lexicon)])
    place = Place("", lexicon | _there(task, result, chart.length_phi, None))
    yield from lines(["l^{*} = P_n*abs(S')/N_P + 2*f_T*S'"], [place])
    yield from lines(["H_{2,min} = S_{0,min} + h + Delta_g + l^{*}"], [place])
    if start > chart.least_start * (1 + 1e-9):
        yield Paragraph(tr("Other constraints ask for a larger start distance or a longer guide."))


def _there(task: CamTask, result: CamOptimum, phi: float, convexity: float | None) -> Lexicon:
    """The motion and the force that presses on the cam, on the side of a jump that is meant."""
    loads = loads_of(task)
    at = at_rows(task, loads, sides(task.program, np.array([phi])))
    inertia = loads.mass * loads.speed**2
    pressing = -resultant(at.motion, inertia, result.stiffness, result.preload, at.force, at.acceleration)
    k = int(np.argmax(pressing))
    if convexity is not None:
        k = int(np.argmin(np.abs(at.motion[0] + at.motion[2] - convexity)))
    y, y1, y2 = at.motion[:3, k].tolist()
    return named(
        {
            "DeltaS": mm(y, tr("displacement of the follower from its lowest position")),
            "S'": mm(y1, tr("first derivative of the displacement at this angle")),
            "S''": mm(y2, tr("second derivative of the displacement at this angle")),
            "P_n": Given(float(pressing[k]), "N", tr("force along the lift that presses on the cam")),
        }
    )


def _pressed(task: CamTask, result: CamOptimum) -> Iterator[Block]:
    """The pressure angles at the sizes in whole steps, which are no constraint of a stem."""
    if result.theta is None or result.kind == "oscillating":
        return
    limits = (task.limits.rise, task.limits.back)
    names = (tr("rise"), tr("return"))
    said = [
        tr("{phase}: $deg({angle})$", phase=name, angle=f"{degrees(value):.5g}")
        + ("" if limit is None else " " + tr("(limit $deg({angle})$)", angle=f"{degrees(limit):.5g}"))
        for name, value, limit in zip(names, result.theta, limits, strict=True)
    ]
    yield Paragraph(
        tr(
            "The pressure angle is none of the constraints, which judge what it does to the guide, the stem and the "
            "roller. At the sizes in whole steps it is largest on the {phases}.",
            phases=", ".join(said),
        )
    )


def _pictures(result: CamOptimum) -> Iterator[Block]:
    """The blocking contours with their key, the section along the radius of the roller, the chart of a flat face."""
    if result.flat is not None:
        yield Paragraph(tr("Figure {fig:cam_chart} shows the admissible start distances over the height."))
        draw = partial(_in_room, of=partial(draw_chart, result=result, chart=result.flat))
        yield Figure(tr("Admissible start distances over the height"), draw, CHART, "cam_chart")
    figures = ", ".join(f"{{fig:cam_contour{k}}}" for k, _ in enumerate(result.contours, 1))
    if len(result.contours) > 1:
        yield Paragraph(
            tr(
                "Figures {figures} show the blocking contours: the regions of the sizes that keep all constraints at "
                "each height, every border with the number of its constraint.",
                figures=figures,
            )
        )
    elif result.contours:
        yield Paragraph(
            tr(
                "Figure {figure} shows the blocking contour: the region of the sizes that keep all constraints, each "
                "border with the number of its constraint.",
                figure=figures,
            )
        )
    for k, contour in enumerate(result.contours, 1):
        draw = partial(_in_room, of=partial(draw_contour, result=result, contour=contour))
        yield Figure(titled(contour_heading(result, contour)), draw, CONTOUR, f"cam_contour{k}")
    if result.section is not None:
        yield Paragraph(
            tr("Figure {fig:cam_section} shows the reaction of the guide and the contact stress over the radius.")
        )
        draw = partial(_in_room, of=partial(draw_section, result=result, section=result.section))
        yield Figure(titled(section_heading(result.section)), draw, SECTION, "cam_section")


def _in_room(drawing: Drawing, box: Box, of: Callable[[Drawing, Box], str]) -> None:
    """A picture with room for the names of its axes around it."""
    of(drawing, box.inset(*NAMES))


def _results(sizes: list[Size]) -> Iterator[Block]:
    """The sizes in whole steps."""
    for each in sizes:
        yield Result(each.name, mm(each.steps, each.meaning), place=tr("best in whole steps"))
