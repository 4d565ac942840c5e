"""Spring, reactions with friction, torque of the cam: what is given, formulas, positions, diagrams."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from tmmcalc.cams.notes.cam_load import told_load
from tmmcalc.cams.notes.lexicon import quantities_table
from tmmcalc.cams.notes.loaded.quantities import Loaded, loaded_of, of_scene
from tmmcalc.cams.notes.loaded.reactions import course, reactions
from tmmcalc.cams.notes.loaded.spring import spring_blocks
from tmmcalc.cams.pictures.cam_forces import draw_course, draw_spring
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Figure, Heading, Lexicon, Paragraph
from tmmcalc.report.telling import WIDE

GIVEN = (
    "m_T",
    "J_T",
    "Q_y",
    "Q_c",
    "M_Qy",
    "M_Qc",
    "g_s",
    "f_T",
    "f_A",
    "r_A",
    "K_1",
    "f_1",
    "F_min",
    "c",
    "Q_0",
    "M_0",
)
SPRING, COURSE = (WIDE, 80.0), (WIDE, 130.0)  # sizes of the pictures [mm]
NAMES = (5.0, 4.0, 2.0, 0.0)  # room that names of axes take around a diagram [mm]


def blocks(order: Order) -> Iterator[Block]:
    """The forces of the cam of the spec."""
    of = loaded_of(order)
    yield Heading(tr("Forces in the cam mechanism"))
    yield from _data(of)
    yield from spring_blocks(of)
    yield from reactions(of)
    yield from course(of)
    yield from _pictures(of)
    if order.spec.cam.shaft is not None:
        yield from told_load(order)


def _data(of: Loaded) -> Iterator[Block]:
    """Masses, loads, friction, what is said of the spring and of the speed."""
    known = of.named(given_loads(of))
    names = [name for name in GIVEN if name in known and known[name].value]
    if names:
        yield Paragraph(tr("The given data of the forces are in table {tab:cam_loads_given}."))
        yield quantities_table(tr("Given data of the forces"), names, known, "cam_loads_given")
    force = of.loads.force
    if force.phi is not None:
        yield Paragraph(tr("The technological load is given by a table over the angle of the cam, linear between."))
    if of.task.turning is not None:
        yield Paragraph(
            tr(
                "The cam turns with the crank of the machine, whose angular velocity varies; so inertia follows from "
                "both $omega$ and $eps$ of the position."
            )
        )


def given_loads(of: Loaded) -> Lexicon:
    """What the spec says of loads, friction and the spring."""
    loads, asked = of.loads, of.loads.spring
    scene = of_scene(of)
    found: Lexicon = {name: scene[name] for name in ("<m>", "f_T", "f_A", "r_A") if name in scene}
    unit, letter = ("N*m", "M_Q") if of.turns else ("N", "Q_")
    if loads.force.phi is None:
        found[f"{letter}y"] = Given(loads.force.rise, unit, tr("technological load on the rise and in the far dwell"))
        found[f"{letter}c"] = Given(
            loads.force.back, unit, tr("technological load on the return and in the near dwell")
        )
    if not of.turns:
        found["g_s"] = Given(loads.gravity, "m/s^2", tr("gravity along the lift"))
    if asked.method == "given":
        found |= {name: scene[name] for name in ("c", "<Q>_0")}
    elif asked.method == "safety":
        found["K_1"] = Given(asked.safety, "", tr("safety factor of the closure of the pair"))
    elif asked.method == "preload":
        found["F_min"] = Given(asked.least, unit, tr("least load of the contact"))
    return found


def _pictures(of: Loaded) -> Iterator[Block]:
    """The line of the spring over the lifting force, and the forces over the turn."""
    spring, task = of.result.spring, of.task
    if spring.stiffness or spring.preload:
        yield Paragraph(
            tr("Figure {fig:cam_spring} shows the lifting force over the displacement and the line of the spring.")
        )

        def draw_lifting(drawing: Drawing, box: Box) -> None:
            draw_spring(drawing, box.inset(*NAMES), task, of.loads, of.result)

        yield Figure(tr("Lifting force and spring"), draw_lifting, SPRING, "cam_spring")
    yield Paragraph(tr("Figure {fig:cam_course} shows the forces and the torque over the turn of the cam."))
    draw = partial(draw_course, task=task, result=of.result)
    yield Figure(tr("Forces and torque over the turn"), draw, COURSE, "cam_course")
