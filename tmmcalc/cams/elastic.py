"""The follower as one mass on an elastic train: what the law of motion leaves of vibration.

    m x'' + c (x' - y') + k (x - y) = 0         y the lift that the cam gives, x that of the mass

The residual vibration is what goes on after a rise from rest; the steady one repeats every turn. The train is pressed
together by -(k z + c z') = m x'', and the roller stays on the cam where that and the other forces press on it.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import pi, sqrt
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.cams.elasticerrors import spectrum_error, vibration_errors
from tmmcalc.cams.follower import Follower, along
from tmmcalc.cams.forces.formulas import resultant
from tmmcalc.cams.forces.spring import solve_spring
from tmmcalc.cams.forces.turn import at_angles, loads_of
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.laws.law import Law, Values
from tmmcalc.cams.program import SAME, PhaseKind
from tmmcalc.cams.response import Response, residual, steady
from tmmcalc.cams.rounding import Errors
from tmmcalc.cams.separation import Contact, contact_notes, contact_of
from tmmcalc.cams.speed import constant_speed
from tmmcalc.cams.task import CamTask, Loads
from tmmcalc.core.errors import UsageError
from tmmcalc.core.notes import Said
from tmmcalc.core.numerics.panels import Panels
from tmmcalc.core.quantity import derived, headed, quantity
from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.machine.motion import Motion

RATIOS = np.arange(1, 241) / 20  # of the spectra: phase time over natural period
COMPARED = ("sine", "cosine", "const", "shun", "modified_trapezoid", "modified_sine")
SHOWN, MANY = 9, 500  # points of the curves to a panel, where there are many panels; else all points


@record
class Spectrum:
    """Residual vibration of a law over the ratio of phase time and natural period."""

    law: str
    residual: Values = quantity("A/h_at_{ratio}", "amplitude over the stroke")  # (m,)
    acceleration: Values = quantity("a_residual/a_max", "amplitude of x'' over the largest y''")  # (m,)


@record
class PhaseVibration:
    """What a moving phase leaves for the dwell after it."""

    kind: PhaseKind  # rise or return
    law: str
    ratio: float = quantity("ratio_{phase}", "time of the {phase} over the natural period")
    residual: float = quantity("residual_{phase}[{size}]", "amplitude after the {phase} alone, from rest")
    relative: float  # the same over the stroke
    steady: float = quantity("steady_{phase}[{size}]", "amplitude after the {phase} in the steady motion")


@record
class ElasticResult:
    """Vibration of the follower at n angles of the turn."""

    turns: bool  # a rocker: y in rad, else in m
    stiffness: float  # k [N/m] or [N*m/rad]
    mass: float  # m [kg] or [kg*m^2]
    damping: float = quantity("zeta", "damping ratio")
    frequency: float  # natural, w [rad/s]
    multiple: float = quantity("multiple", "natural frequency over that of the cam")
    stroke: float  # [m or rad]
    phi: Values = quantity("phi[rad]", "angle of the cam")  # (n,) as all curves
    lift: Values = quantity("y[{size}]", "lift that the cam gives")
    stretch: Values = quantity("z[{size}]", "stretch of the train, x - y")
    given: Values = quantity("a_y[{size}/s^2]", "acceleration that the cam gives", symbol="y''")
    response: Values = quantity("a_x[{size}/s^2]", "acceleration of the mass", symbol="x''")
    load: Values = quantity("P_c[{force}]", "load along the lift; it presses on the cam where it is negative")
    rigid: Values = quantity("P_c_rigid[{force}]", "load along the lift of a rigid train")
    phases: tuple[PhaseVibration, ...]
    peak_given: float = quantity("a_y_max[{size}/s^2]", "largest acceleration that the cam gives")
    peak_response: float = quantity("a_x_max[{size}/s^2]", "largest acceleration of the mass")
    peak_phi: float = quantity("a_x_max_at_phi[rad]", "angle of the cam where the mass accelerates most")
    train: float = quantity("train_max[{force}]", "largest force in the train", symbol="max|k z + c z'|")
    largest: float = quantity("z_max[{size}]", "largest deflection of the train")
    contact: Contact
    ratios: Values  # (m,)
    spectra: tuple[Spectrum, ...]
    notes: tuple[Said, ...]
    error: Errors  # estimates, relative: of z, of x'', of what is left over a phase, of the spectra

    @derived("frequency[Hz]", "natural frequency of the mass on its train", symbol="f")
    def hertz(self) -> float:
        """Without the damping."""
        return self.frequency / (2 * pi)


def solve_elastic(task: CamTask, follower: Follower, motion: Motion | None = None) -> ElasticResult:
    """Residual and steady vibration of the follower, at the speed of the machine if it is known.

    Raises `UsageError` without [cam.elastic], a mass or a speed, `SingularityError` at resonance without damping.
    """
    task = task.at_speed(motion)
    train, loads = task.elastic, loads_of(task, "cam_elastic")
    if train is None:
        raise UsageError("nothing is known of the elastic train", where="cam_elastic", remedy="add [cam.elastic]")
    mass = loads.mass if train.mass is None else train.mass
    if mass <= 0:
        raise UsageError("the elastic follower has no mass", where="cam_elastic", remedy="[cam.elastic] mass")
    frequency = sqrt(train.stiffness / mass)
    speed = constant_speed(loads.speed) if task.turning is None else task.turning
    course = steady(task.program, speed, frequency, train.damping)
    on = course.panels
    (low, low_at), (high, high_at) = on.extremes(course.mass)
    peak, place = (high, high_at) if high >= -low else (-low, low_at)
    load, rigid = _loads(task, loads, course, mass)
    contact = contact_of(task, loads, on, load, rigid)
    phi, (lift, stretch, given, response, shown, stiff) = _curves(
        task, on, np.stack((course.lift, course.stretch, course.given, course.mass, load, rigid))
    )
    laws = [phase.law for phase in task.program.phases if phase.law is not None]
    spectra = tuple(_spectra(laws, train.damping))
    error = vibration_errors(task.program, speed, course, frequency, train.damping)
    return ElasticResult(
        turns=follower.kind == "oscillating",
        stiffness=train.stiffness,
        mass=mass,
        damping=train.damping,
        frequency=frequency,
        multiple=frequency * float(course.time[-1]) / (2 * pi),
        stroke=task.program.stroke,
        phi=phi,
        lift=lift,
        stretch=stretch,
        given=given,
        response=response,
        load=shown,
        rigid=stiff,
        phases=tuple(_phases(task, course, frequency, train.damping)),
        peak_given=max(map(abs, (each[0] for each in on.extremes(course.given)))),
        peak_response=peak,
        peak_phi=place,
        train=mass * peak,
        largest=max(abs(each[0]) for each in on.extremes(course.stretch)),
        contact=contact,
        ratios=RATIOS,
        spectra=spectra,
        notes=tuple(contact_notes(contact)),
        error=error | {"spectra": spectrum_error(laws[0], RATIOS, spectra[0].residual, train.damping)},
    )


def _loads(task: CamTask, loads: Loads, course: Response, mass: float) -> tuple[Values, Values]:
    """P_c (K, N) with the acceleration of the mass, and with that of the cam."""
    on = course.panels
    at = at_angles(task, loads, on.x.ravel())
    spring = solve_spring(task, loads)
    still = resultant(at.motion, 0.0, spring.stiffness, spring.preload, at.force).reshape(on.x.shape)
    return still - mass * course.mass, still - mass * course.given


def _curves(task: CamTask, on: Panels, values: Values) -> tuple[Values, Values]:
    """Angles (n,) and values (Q, n) of curves (Q, K, N): points and edges, with both limits where the motion jumps."""
    few = np.arange(on.order) if on.count <= MANY else np.linspace(0, on.order - 1, SHOWN).round().astype(int)
    low, high = on.ends(values)
    rows = np.concatenate((low[..., None], values[..., few], high[..., None]), axis=-1)
    phi = np.concatenate((on.edges[:-1, None], on.x[:, few], on.edges[1:, None]), axis=1)
    kept = np.ones(phi.shape, bool)
    kept[:, -1] = np.min(np.abs(on.edges[1:, None] - task.program.edges), axis=1) < SAME
    return phi[kept], rows[:, kept]


def _phases(task: CamTask, course: Response, frequency: float, damping: float) -> Iterator[PhaseVibration]:
    program, on = task.program, course.panels
    free = frequency * sqrt(1 - damping**2)
    for phase, begin, end in zip(program.phases, program.starts, program.starts[1:], strict=False):
        if phase.law is None:
            continue
        first, last = (int(np.argmin(np.abs(on.edges - x))) for x in (begin, end))
        duration = course.time[last] - course.time[first]
        fading = np.exp(complex(-damping * frequency, free) * duration)
        alone = abs(course.edges[last] - fading * course.edges[first]) / free
        yield PhaseVibration(
            phase.kind,
            phase.law.name,
            float(duration * frequency / (2 * pi)),
            float(alone),
            float(alone / program.stroke),
            float(abs(course.edges[last]) / free),
        )


def _spectra(own: list[Law], damping: float) -> Iterator[Spectrum]:
    """Of the laws of the cam, and of some others beside them."""
    laws = {law.name: law for law in own} | {name: LAWS[name] for name in COMPARED if name not in [o.name for o in own]}
    for law in laws.values():
        found = residual(law, RATIOS, damping)
        k = np.concatenate([np.linspace(a, b, 200) for a, b in zip(law.breaks, law.breaks[1:], strict=False)])
        piece = np.repeat(np.arange(law.count), 200)
        peak = float(np.max(np.abs(law.at(k, piece)[2])))
        yield Spectrum(law.name, found, found * (2 * pi * RATIOS) ** 2 / peak)


def elastic_columns(result: ElasticResult) -> dict[str, Values]:
    """The table: y, z and accelerations along the turn by their headers."""
    curves = ("lift", "stretch", "given", "response", "load", "rigid")
    return headed(result, "phi[deg]", *curves, **along(result.turns))
