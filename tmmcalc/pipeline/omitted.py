"""What the stages that run leave out within themselves, because the scene has it not: sentences for ``plan --why``.

Each is asked of the same plain inputs, and by the same properties, that the stage itself goes by.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.pipeline.store import CSV_ROWS, csv_wanted

if TYPE_CHECKING:
    from tmmcalc.linkage.loading import Loading
    from tmmcalc.linkage.tables.grid import GridTable
    from tmmcalc.project import Spec

Sentences = tuple[str, ...]

LOOPS = "all groups are dyads, in closed form: no loops are iterated, no branches followed"
EXTRA = "no extra positions and no dead centres among the positions: equal steps alone"
FRICTION = "no friction in any pair: no friction is solved, no self-locking sought"
INERTIA = "massless links: no loads of inertia"
REDUCED = "massless links: no reduced inertia is summed up"
SPRINGS = "no [[springs]]: no forces of springs and dampers"
GEAR = "no gear on the crank: no force of a mesh"
RODS = "no connecting rods with mass: nothing is lumped in two masses"
DIAGRAM = "[torque] in place of a linkage: nothing is reduced, the diagram is taken as it is"
NO_MOTOR = "no [motor]: it is not asked for power and speed"
GIVEN_MOTOR = "the motor is given: none is chosen from the catalogue"
NO_REGIME = "a constant moment drives: no regime under a motor is integrated"
NO_WHEEL = "no [flywheel]: the motion has none"
NO_SHAFTS = "no [[shafts]]: one mass, no rigid drive beside it"
NO_STEADY = "no motion in time begins in the steady one: that is not found first"
NO_LINKAGE = "no linkage with masses: no shaking force over positions"
NO_ENGINE = "no [engine]: no orders of cylinders"
NO_ROTOR = "no [rotor]: no correction planes"
NO_KEPT = "no [[constraints]] on its rows: none is judged"
NO_SIFT = "no [[constraints]]: solutions are not sifted"
CLOSED = "solutions in closed form, all listed: they are not sifted by the constraints"
NO_SEARCH = "no [synthesis.dwell.optimum]: no search for the best dwell"
NO_EXCITATION = "no [vibrator.unbalance] or no speed: no steady vibration"
NO_CURVE = "no [vibrator.curve]: no resonance curve"
NO_START = "no [vibrator.start]: no start with a given angle"
NO_DRIVE = "no [vibrator.drive]: no start under a motor"
NO_OBSTACLES = "no obstacles: no distance to any is taken"
NO_CSV = f"its csv is not written: more than {CSV_ROWS} rows"


def kinematics(spec: Spec) -> Sentences:
    """Positions and groups that the mechanism has not."""
    grid = spec.linkage.grid
    return _kept(
        (_dyads(spec), LOOPS),
        (not grid.extra and not grid.extremes, EXTRA),
        (_long(spec), NO_CSV),
    )


def forces(spec: Spec) -> Sentences:
    """What does not act."""
    from tmmcalc.linkage.loading import GearDrive

    loading = _loading(spec)
    return _kept(
        (not loading.rubs, FRICTION),
        (not loading.heavy, INERTIA),
        (not loading.springs, SPRINGS),
        (not isinstance(loading.drive, GearDrive), GEAR),
        (_long(spec), NO_CSV),
    )


def reduction(spec: Spec) -> Sentences:
    """What does not act, and has no mass."""
    if spec.torque is not None:
        return (DIAGRAM,)
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
    from tmmcalc.machine.reduction.inertia import rods_of

    loading = _loading(spec)
    return _kept(
        (not loading.rubs, FRICTION),
        (not loading.heavy, REDUCED),
        (not loading.springs, SPRINGS),
        (not rods_of(to_linkage(spec.linkage), loading), RODS),
        (_long(spec), NO_CSV),
    )


def power(spec: Spec) -> Sentences:
    """What is not asked of a motor."""
    from tmmcalc.machine.tables.tasks.machine import CHOOSE

    motor = spec.motor
    return _kept((motor is None, NO_MOTOR), (motor is not None and motor.name != CHOOSE, GIVEN_MOTOR))


def flywheel(spec: Spec) -> Sentences:
    """The regime of a motor that the machine has not."""
    return _kept((_constant_moment(spec), NO_REGIME))


def motion(spec: Spec) -> Sentences:
    """As of the flywheel; and a flywheel that is not there."""
    return _kept(
        (_constant_moment(spec), NO_REGIME),
        (spec.flywheel is None, NO_WHEEL),
        (_long(spec), NO_CSV),
    )


def transient(spec: Spec) -> Sentences:
    """Shafts that the drive has not, a motion that none begins in."""
    return _kept((not spec.shafts, NO_SHAFTS), (all(each.begin != "steady" for each in spec.transients), NO_STEADY))


def balance(spec: Spec) -> Sentences:
    """What is not there to be balanced."""
    from tmmcalc.pipeline.wanted import shakes

    linkage = shakes(spec)
    return _kept(
        (not linkage, NO_LINKAGE),
        (spec.engine is None, NO_ENGINE),
        (spec.rotor is None, NO_ROTOR),
        (linkage and _long(spec), NO_CSV),
    )


def train(spec: Spec) -> Sentences:
    """Constraints on tooth sets."""
    from tmmcalc.feasibility.tables.tasks.kept_rows import kept_rows

    return _kept((kept_rows(spec, "train") is None, NO_KEPT))


def criteria(spec: Spec) -> Sentences:
    """Constraints on trains."""
    from tmmcalc.feasibility.tables.tasks.kept_rows import kept_rows

    return _kept((kept_rows(spec, "criteria") is None, NO_KEPT))


def synthesis(spec: Spec) -> Sentences:
    """Searches that are not asked for."""
    from tmmcalc.linkage.synthesis.dwell.task import DwellTask
    from tmmcalc.linkage.synthesis.kinds import SEARCHES
    from tmmcalc.linkage.tables.tasks.synthesis import to_synthesis

    task = to_synthesis(spec)
    asked = task.asked
    return _kept(
        (isinstance(asked, DwellTask) and asked.optimum is None, NO_SEARCH),
        (task.constraints is None, NO_SIFT),
        (task.constraints is not None and task.kind not in SEARCHES, CLOSED),
    )


def manipulator(spec: Spec) -> Sentences:
    """Obstacles."""
    table = spec.manipulator
    return _kept((table is not None and not table.obstacles, NO_OBSTACLES))


def vibrator(spec: Spec) -> Sentences:
    """Kinds of motion that are not asked for."""
    table = spec.vibrator
    if table is None:
        return ()
    return _kept(
        (table.unbalance is None or table.speed is None, NO_EXCITATION),
        (table.curve is None or table.unbalance is None, NO_CURVE),
        (table.start is None, NO_START),
        (table.drive is None, NO_DRIVE),
    )


def _kept(*said: tuple[object, str]) -> Sentences:
    return tuple(sentence for holds, sentence in said if holds)


def _loading(spec: Spec) -> Loading:
    from tmmcalc.linkage.tables.tasks.loading import to_loading

    return to_loading(spec)


def _dyads(spec: Spec) -> bool:
    """Whether all groups have a kind of dyad, as the chain asks when it places them."""
    from tmmcalc.linkage.structure import solve_structure
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    return all(group.kind for group in solve_structure(to_linkage(spec.linkage)).groups)


def _constant_moment(spec: Spec) -> bool:
    """Whether no motor drives the steady motion, and not the loads alone."""
    from tmmcalc.machine.tables.tasks.machine import to_motion

    task = to_motion(spec)
    return (task.positional or spec.motor is None) and not task.undriven


def _long(spec: Spec) -> bool:
    """Whether the equal steps alone make more rows than a CSV is written of."""
    return spec.mechanism is not None and not csv_wanted(_rows(spec.mechanism.grid), None)


def _rows(grid: GridTable) -> int:
    """Rows of the equal steps, or of those of both strokes."""
    both = grid.working is not None and grid.idle is not None
    return (grid.working or 0) + (grid.idle or 0) + 1 if both else grid.positions + 1
