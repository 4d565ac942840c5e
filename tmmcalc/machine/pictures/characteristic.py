"""The motor's characteristic on the input shaft: all forms that its data allow, and where the machine works on it."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record
from tmmcalc.machine.driver import driver_of
from tmmcalc.machine.motion import Motion
from tmmcalc.machine.motors.characteristics import Characteristic
from tmmcalc.machine.motors.model import CharacteristicKind
from tmmcalc.machine.pictures.words import form_name
from tmmcalc.machine.power import MotorDuty
from tmmcalc.machine.regime import Regime
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import BELOW, scale_factor, sides, suited, to_scale
from tmmcalc.report.drawing.diagram import ROW, Axis, Diagram, key_rows
from tmmcalc.report.drawing.lettering import minus, width
from tmmcalc.report.drawing.pens import AXIS, CURVES, INK, Pen
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number

FORMS: tuple[CharacteristicKind, ...] = ("parabolic", "linear", "kloss", "shunt", "series", "table", "constant")
USUAL = ("parabolic", "linear", "kloss")  # of an induction motor: drawn beside each other
SAMPLES = 400
MARGIN = 0.12  # of the range of speeds, on both sides
HEADROOM = 1.15
PATH = Pen("MOTION", 1.6, colour="#b3d4e8")  # of the steady motion on the characteristic
BAND = "#e3f0f7"
MEAN = AXIS._replace(layer="MEAN")
POINT = Pen("POINTS", 0.3, colour=INK)
SPEEDS = "#0072b2"


@record
class Curve:
    """A form of the characteristic with the look of its curve."""

    name: str
    form: Characteristic
    pen: Pen


@record
class MotorCurves:
    """The forms on the input shaft, the one of the result first, and the regime."""

    curves: tuple[Curve, ...]
    regime: Regime

    @property
    def range(self) -> tuple[float, float]:
        """Speeds that the near view shows: those of the regime and of the rated and no-load points [rad/s]."""
        form, regime = self.curves[0].form, self.regime
        marked = [speed for speed in (form.nominal, form.synchronous) if speed is not None]
        low, high = min(regime.omega_min, *marked), max(regime.omega_max, *marked)
        return low - MARGIN * (high - low), high + MARGIN * (high - low)

    @property
    def kloss(self) -> Characteristic | None:
        """The form that tells the whole curve."""
        return next((curve.form for curve in self.curves if curve.form.name == "kloss"), None)


def motor_curves(result: Motion, duty: MotorDuty, efficiency: float) -> MotorCurves:
    """The forms that the data of the motor allow; ``efficiency`` is that of the gears."""
    beside = USUAL if duty.motor.kind == "induction" else ()
    found: list[Curve] = []
    for kind in sorted(FORMS, key=lambda form: form != result.characteristic):
        if kind != result.characteristic and kind not in beside:
            continue
        try:
            form = driver_of(duty.motor, kind, duty.ratio, efficiency).characteristic
        except UsageError:
            continue
        pen = CURVES[len(found) % len(CURVES)]
        found.append(Curve(form_name(kind), form, pen._replace(width=0.35 if found else 0.6)))
    return MotorCurves(tuple(found), result.regime)


def draw_motor(drawing: Drawing, box: Box, motor: MotorCurves, *, scaled: bool = False) -> None:
    """The working range, and under it the whole curve if it is known; ``scaled``: to standard scale factors."""
    parts = box.split(1, 1) if motor.kloss is not None else [box]
    _draw_near(drawing, parts[0], motor, scaled)
    for part in parts[1:]:
        _draw_whole(drawing, part, motor, scaled)


def _diagram(drawing: Drawing, frame: Box, ends: tuple[Axis, Axis], unit: str, scaled: bool) -> Diagram:
    """The diagram of a characteristic, with both scale factors beside the name of its abscissa or without."""
    if not scaled:
        return Diagram(drawing, frame, *ends)
    (along, mu_along), (up, mu_up) = map(to_scale, ends, (frame.width, frame.height))
    factors = f"{scale_factor('ω', mu_along, 'rad/s')}, {scale_factor('M', mu_up, unit)}"
    return Diagram(drawing, frame, along._replace(name=f"$ω$, {tr_unit('rad/s')}; {factors}"), up)


def _draw_near(drawing: Drawing, box: Box, motor: MotorCurves, scaled: bool) -> None:
    """All forms about the working range, the path of the regime on them, marked points and extreme speeds."""
    low, high = motor.range
    omega = np.linspace(low, high, SAMPLES)
    moments = [np.broadcast_to(curve.form.moment(omega), omega.shape) for curve in motor.curves]
    regime, used = motor.regime, motor.curves[0].form
    peak = max(float(np.max(np.abs(moment))) for moment in [*moments, regime.driving])
    factor, unit = suited(peak, "N*m")
    names = _names(motor)
    larger = drawing.letters
    left, bottom, right, top = sides(larger)
    rows = larger * ROW * len(key_rows(names, box.width - left - right, larger)) + top
    driving = _closed(regime.driving) * factor
    heights = np.concatenate([*(moment * factor for moment in moments), driving, [0.0]])
    air = MARGIN * float(np.ptp(heights))
    up = Axis(f"{tr('$M_d$')}, {unit}", float(heights.min()) - air, float(heights.max()) + air)
    frame = box.inset(left, BELOW * larger + bottom, right, rows)
    diagram = _diagram(drawing, frame, (Axis(_abscissa(), low, high), up), unit, scaled)
    diagram.curve(_closed(regime.omega) + 1j * driving, PATH, level=2)
    for curve, moment in zip(motor.curves, moments, strict=True):
        diagram.curve(omega + 1j * moment * factor, curve.pen)
    diagram.level(regime.mean_moment * factor, MEAN)
    diagram.key(names)
    _points(diagram, used, factor, (("H", used.nominal), ("C", used.synchronous)))
    for speed, written, index in _extremes(regime):
        driving_there = float(np.interp(speed, [regime.omega_min, regime.omega_max], _at_extremes(regime)))
        at = diagram.point(complex(speed, driving_there * factor), Pen("POINTS", 0.3, colour=SPEEDS), 0.6)
        text = f"$ω{index}$ = {minus(written)}"
        diagram.labels.put(text, [at], height=2.2, gaps=(1.0, 1.8, 3.0, 4.6), colour=SPEEDS)


def _extremes(regime: Regime) -> list[tuple[float, str, str]]:
    """The extreme speeds as they are written, with their indices; one where they are the same."""
    least, largest = number(regime.omega_min, 5), number(regime.omega_max, 5)
    if least == largest:
        return [(regime.mean, least, "")]
    return [(regime.omega_min, least, "_{min}"), (regime.omega_max, largest, "_{max}")]


def _draw_whole(drawing: Drawing, box: Box, motor: MotorCurves, scaled: bool) -> None:
    """The whole curve from standstill on, with the range of the speeds."""
    whole = motor.kloss
    assert whole is not None
    low, high = motor.range
    # the peak of a motor with little slip is a line, which even steps would miss
    marked = [speed for speed in (whole.nominal, whole.critical) if speed is not None]
    omega = np.union1d(np.linspace(0.0, high, SAMPLES), marked)
    moment = whole.moment(omega)
    factor, unit = suited(float(np.max(np.abs(moment))), "N*m")
    inside = np.linspace(max(low, 0.0), high, SAMPLES)
    top = HEADROOM * float(np.max(moment))
    up = Axis(f"{tr('$M_d$')}, {unit}", min(float(moment[-1]), -0.1 * top) * factor, top * factor)
    larger = drawing.letters
    left, bottom, right, over = sides(larger)
    frame = box.inset(left, BELOW * larger + bottom, right, over + ROW * larger)
    diagram = _diagram(drawing, frame, (Axis(_abscissa(), 0.0, high), up), unit, scaled)
    for curve in motor.curves:
        x = omega if curve.form is whole else inside
        diagram.curve(x + 1j * np.broadcast_to(curve.form.moment(x), x.shape) * factor, curve.pen)
    diagram.band(motor.regime.omega_min, motor.regime.omega_max, BAND)
    text = tr("$H$ rated point, $C$ without load, $K$ break-down; shaded: the range above")
    height = min(2.0 * larger, frame.width / width(text))
    drawing.add(Words(complex(frame.left, frame.top + 1.2), text, height, -1 - 1j))
    _points(diagram, whole, factor, (("H", whole.nominal), ("C", whole.synchronous), ("K", whole.critical)))


def _names(motor: MotorCurves) -> list[tuple[str, Pen]]:
    """The forms, the path of the regime, the mean moment."""
    used, *others = motor.curves
    forms = [(tr("{form}, in use", form=used.name), used.pen), *((curve.name, curve.pen) for curve in others)]
    return [*forms, (tr("steady motion"), PATH), (tr("mean moment"), MEAN)]


def _abscissa() -> str:
    return tr("$ω$ of the input shaft, rad/s")


def _at_extremes(regime: Regime) -> tuple[float, float]:
    """Driving moment where the speed is least and where it is largest."""
    low, high = regime.panels.at(regime.driving, np.array([regime.theta_min, regime.theta_max]))
    return float(low), float(high)


def _points(
    diagram: Diagram, form: Characteristic, factor: float, points: tuple[tuple[str, float | None], ...]
) -> None:
    for name, omega in points:
        if omega is not None:
            at = diagram.point(complex(omega, float(form.moment(omega)) * factor), POINT, 0.75)
            diagram.labels.put(f"${name}$", [at], gaps=(0.9, 1.5, 2.5))


def _closed(values: Values) -> Values:
    flat = values.ravel()
    return np.append(flat, flat[0])
