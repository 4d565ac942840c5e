"""The motor's characteristic on the input shaft: all forms that its data allow, and where the machine works on it."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, MaxNLocator

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record
from tmmcalc.machine.driver import driver_of
from tmmcalc.machine.motion import Motion
from tmmcalc.machine.motors.characteristics import Characteristic
from tmmcalc.machine.motors.model import CharacteristicKind
from tmmcalc.machine.power import MotorDuty
from tmmcalc.machine.regime import Regime
from tmmcalc.report.drawing.curves import suited
from tmmcalc.report.drawing.labels import Labels, signed
from tmmcalc.report.drawing.style import CURVES, INK

FORMS: tuple[tuple[CharacteristicKind, str], ...] = (
    ("parabolic", "parabola"),
    ("linear", "line"),
    ("kloss", "Kloss"),
    ("shunt", "shunt"),
    ("series", "series"),
    ("table", "by points"),
    ("constant", "constant"),
)
USUAL = ("parabolic", "linear", "kloss")  # of an induction motor: drawn beside each other
SAMPLES = 400
MARGIN = 0.12  # of the range of speeds, on both sides
HEADROOM = 1.15
PATH: dict[str, Any] = {"color": "#0072b2", "linewidth": 6, "alpha": 0.3, "solid_capstyle": "butt", "zorder": 3}
BAND: dict[str, Any] = {"color": "#0072b2", "alpha": 0.12, "linewidth": 0, "zorder": 1}
MEAN: dict[str, Any] = {"color": INK, "linewidth": 0.8, "linestyle": (0, (8, 2, 1.5, 2)), "zorder": 2}
POINT: dict[str, Any] = {"color": INK, "markerfacecolor": "white", "markersize": 4.5, "zorder": 8, "linestyle": ""}


@record
class Curve:
    """A form of the characteristic with the look of its curve."""

    name: str
    form: Characteristic
    style: dict[str, Any]


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
    for kind, name in sorted(FORMS, key=lambda form: form[0] != result.characteristic):
        if kind != result.characteristic and kind not in beside:
            continue
        try:
            form = driver_of(duty.motor, kind, duty.ratio, efficiency).characteristic
        except UsageError:
            continue
        style = CURVES[len(found) % len(CURVES)]
        found.append(Curve(name, form, {"linewidth": 1.9 if not found else 1.1, "zorder": 5, **style}))
    return MotorCurves(tuple(found), result.regime)


def draw_near(axes: Axes, motor: MotorCurves) -> float:
    """All forms about the working range, and the path of the regime on them; returns the factor of the moments."""
    low, high = motor.range
    omega = np.linspace(low, high, SAMPLES)
    moments = [np.broadcast_to(curve.form.moment(omega), omega.shape) for curve in motor.curves]
    regime = motor.regime
    peak = max(float(np.max(np.abs(moment))) for moment in [*moments, regime.driving])
    factor, unit = suited(peak, "N*m")
    axes.plot(_closed(regime.omega), _closed(regime.driving) * factor, **PATH)
    for curve, moment in zip(motor.curves, moments, strict=True):
        axes.plot(omega, moment * factor, **curve.style)
    axes.axhline(regime.mean_moment * factor, **MEAN)
    _frame(axes, unit)
    axes.set_xlim(low, high)
    return factor


def draw_whole(axes: Axes, motor: MotorCurves) -> float:
    """The whole curve from standstill on, with the range that the near view shows; returns the factor."""
    whole = motor.kloss
    assert whole is not None
    low, high = motor.range
    # the peak of a motor with little slip is a line, which even steps would miss
    marked = [speed for speed in (whole.nominal, whole.critical) if speed is not None]
    omega = np.union1d(np.linspace(0.0, high, SAMPLES), marked)
    moment = whole.moment(omega)
    factor, unit = suited(float(np.max(np.abs(moment))), "N*m")
    inside = np.linspace(max(low, 0.0), high, SAMPLES)
    for curve in motor.curves:
        x = omega if curve.form is whole else inside
        axes.plot(x, curve.form.moment(x) * factor, **curve.style)
    axes.axvspan(motor.regime.omega_min, motor.regime.omega_max, **BAND)
    _frame(axes, unit)
    axes.set_xlim(0.0, high)
    axes.set_title("H rated point, C without load, K break-down; shaded: the range above", loc="left", fontsize=7.5)
    top = HEADROOM * float(np.max(moment))
    axes.set_ylim(min(float(moment[-1]), -0.1 * top) * factor, top * factor)
    return factor


def legend(axes: Axes, motor: MotorCurves) -> None:
    """The forms, the path of the regime, the mean moment."""
    used, *others = motor.curves
    handles = [Line2D([], [], label=f"{used.name}, in use", **used.style)]
    handles += [Line2D([], [], label=curve.name, **curve.style) for curve in others]
    handles.append(Line2D([], [], label="steady motion", **PATH))
    handles.append(Line2D([], [], label="mean moment", **MEAN))
    axes.legend(
        handles=handles, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=3, handlelength=2.4, columnspacing=1.0
    )


def label_near(axes: Axes, motor: MotorCurves, factor: float) -> None:
    """Rated and no-load point, and the extreme speeds."""
    labels, regime = _avoiding(axes, motor, factor, np.linspace(*motor.range, SAMPLES)), motor.regime
    form = motor.curves[0].form
    _points(axes, labels, form, factor, (("H", form.nominal), ("C", form.synchronous)))
    for omega, text in ((regime.omega_min, "min"), (regime.omega_max, "max")):
        moment = float(np.interp(omega, [regime.omega_min, regime.omega_max], _at_extremes(regime)))
        at = complex(omega, moment * factor)
        axes.plot(at.real, at.imag, "D", markersize=3.6, markerfacecolor="white", color="#0072b2", zorder=9)
        name = f"$\\omega_\\mathrm{{{text}}}$ = {signed(omega, 5)}"
        labels.put(name, [at], size=7, gaps=(1.2, 2.0, 3.2, 5.0), color="#0072b2")


def label_whole(axes: Axes, motor: MotorCurves, factor: float) -> None:
    """Rated, no-load and break-down point."""
    form = motor.kloss
    assert form is not None
    labels = _avoiding(axes, motor, factor, np.linspace(0.0, axes.get_xlim()[1], SAMPLES))
    _points(axes, labels, form, factor, (("H", form.nominal), ("C", form.synchronous), ("K", form.critical)))


def _at_extremes(regime: Regime) -> tuple[float, float]:
    """Driving moment where the speed is least and where it is largest."""
    low, high = regime.panels.at(regime.driving, np.array([regime.theta_min, regime.theta_max]))
    return float(low), float(high)


def _points(
    axes: Axes, labels: Labels, form: Characteristic, factor: float, points: tuple[tuple[str, float | None], ...]
) -> None:
    for name, omega in points:
        if omega is not None:
            at = complex(omega, float(form.moment(omega)) * factor)
            axes.plot(at.real, at.imag, "o", **POINT)
            labels.put(name, [at], size=8, gaps=(1.0, 1.6, 2.6))


def _avoiding(axes: Axes, motor: MotorCurves, factor: float, omega: Values) -> Labels:
    labels = Labels(axes)
    for curve in motor.curves:
        moment = np.broadcast_to(curve.form.moment(omega), omega.shape)
        labels.avoid(omega + 1j * moment * factor, 0.7)
    return labels


def _closed(values: Values) -> Values:
    flat = values.ravel()
    return np.append(flat, flat[0])


def _frame(axes: Axes, unit: str) -> None:
    axes.axhline(0, color="#333333", linewidth=0.8, zorder=1.5)
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.set_axisbelow(True)
    axes.set_ylabel(f"$M_\\mathrm{{d}}$, {unit}")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(6))
        axis.set_major_formatter(FuncFormatter(lambda v, _: signed(v, 6)))
    axes.set_xlabel("$\\omega$ of the input shaft, rad/s")
    axes.tick_params(length=2.5)
