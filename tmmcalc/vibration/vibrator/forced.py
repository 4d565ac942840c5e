"""Steady vibration at a constant speed by complex amplitudes: (-w^2 M + i w B + C) X = P.

The sum is solved in the coordinates of the modes, where it is diagonal but for the damping. What the unbalance does
in a turn is what the dampers take: the difference of the two is the check of every amplitude.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import SingularityError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.vibration.vibrator.energies import COUNT, Excitation
from tmmcalc.vibration.vibrator.modes import Modes

Complex = NDArray[np.complexfloating]
NOISE = 1e-14  # of the largest amplitude
SINGULAR = 1e-10  # of the scaled dynamic stiffness: below it nothing holds the amplitude
PASSES = 8  # of the search for a peak
AROUND = 25  # speeds of a pass


@record
class Steady:
    """The steady vibration at one speed."""

    speed: float = quantity("omega[rad/s]", "speed of the rotor")
    amplitude: Values = quantity("amplitude", "amplitudes of the coordinates")  # (7,) [m] and [rad]
    phase: Values = quantity(  # (7,) from -pi to pi
        "phase[rad]", "angles of the coordinates behind the angle psi of the unbalance"
    )
    cosine: Values  # (7,) q = cosine cos(psi) + sine sin(psi)
    sine: Values  # (7,)
    power: float = quantity("power[W]", "power that the dampers take")
    moment: float = quantity("rotor_moment[N*m]", "moment of the rotor that gives this power")
    balance: float = quantity(
        "power_balance", "power of the unbalance less that of the dampers, over the reactive power"
    )


@record
class Peak:
    """The largest amplitude of a coordinate on the resonance curve."""

    coordinate: str
    speed: float = quantity("omega[rad/s]", "speed of the rotor")
    amplitude: float = quantity("amplitude[{unit}]", "largest amplitude")


def amplitudes(modes: Modes, excitation: Excitation, omega: Values) -> Complex:
    """Complex amplitudes (m, 7) at speeds (m,) [rad/s]; raises `SingularityError` at an undamped resonance."""
    return _of_device(modes, _solved(modes, excitation, omega))


def _of_device(modes: Modes, eta: Complex) -> Complex:
    """Amplitudes (m, 7) of the coordinates from those of the modes; what is rounding beside the others is none."""
    found: Complex = eta @ modes.shapes.T
    sizes = np.abs(found) * modes.weight
    return np.where(sizes > NOISE * np.max(sizes, axis=1, keepdims=True), found, 0.0)


def _solved(modes: Modes, excitation: Excitation, omega: Values) -> Complex:
    """Amplitudes (m, 7) of the modes; raises `SingularityError` next to a singular speed."""
    w = modes.frequency
    scale = 1 / np.hypot(w, omega[:, None])
    dynamic = 1j * omega[:, None, None] * modes.damping
    rows = np.arange(COUNT)
    dynamic[:, rows, rows] += (w - omega[:, None]) * (w + omega[:, None])
    scaled = dynamic * scale[:, :, None] * scale[:, None, :]
    nearness = np.linalg.svd(scaled, compute_uv=False)[:, -1]
    worst = int(np.argmin(nearness))
    if nearness[worst] < SINGULAR:
        speed = float(omega[worst])
        raise SingularityError(
            f"resonance without damping at {speed:.9g} rad/s: no amplitude is steady",
            where="vibrator",
            value=float(nearness[worst]),
            limit=SINGULAR,
            remedy="give [vibrator.damping], or another speed",
        )
    load = (excitation.amplitude(omega) @ modes.shapes) * scale
    found: Complex = np.linalg.solve(scaled, load[..., None])[..., 0] * scale
    return found


def steady(modes: Modes, excitation: Excitation, speed: float) -> Steady:
    """The steady vibration at a speed [rad/s]."""
    at = np.array([speed])
    eta = _solved(modes, excitation, at)
    amplitude = _of_device(modes, eta)[0]
    given, taken = powers(modes, excitation, at, eta)
    force = excitation.amplitude(at)[0]
    reactive = float(np.sum(np.abs(force * amplitude))) * speed / 2
    return Steady(
        speed=speed,
        amplitude=np.abs(amplitude),
        phase=np.where(amplitude != 0, -np.angle(amplitude), 0.0),
        cosine=amplitude.real,
        sine=-amplitude.imag,
        power=float(taken[0]),
        moment=float(taken[0]) / speed,
        balance=float(given[0] - taken[0]) / reactive if reactive else 0.0,
    )


def powers(modes: Modes, excitation: Excitation, omega: Values, eta: Complex) -> tuple[Values, Values]:
    """Mean power [W] (m,) that the unbalance gives, and that the dampers take."""
    load = excitation.amplitude(omega) @ modes.shapes
    given = omega / 2 * np.imag(load * eta.conj()).sum(axis=1)
    taken = omega**2 / 2 * np.real(np.einsum("mi,ij,mj->m", eta.conj(), modes.damping, eta))
    return given, taken


def load_moment(modes: Modes, excitation: Excitation, omega: Values) -> Values:
    """Mean moment (m,) [N*m] that the vibration asks of the rotor at steady speeds (m,)."""
    eta = _solved(modes, excitation, omega)
    found: Values = powers(modes, excitation, omega, eta)[1] / omega
    return found


def peaks(modes: Modes, excitation: Excitation, omega: Values, found: Complex, names: tuple[str, ...]) -> list[Peak]:
    """The largest amplitudes of the curve (m, 7), each refined between its neighbours.

    A resonance without damping has no largest amplitude: there the search stops short of it.
    """
    listed = []
    for k, name in enumerate(names):
        sizes = np.abs(found[:, k])
        if np.max(sizes) > 0:
            at = int(np.argmax(sizes))
            low, high = float(omega[max(at - 1, 0)]), float(omega[min(at + 1, len(omega) - 1)])
            listed.append(_refined(modes, excitation, k, Peak(name, float(omega[at]), float(sizes[at])), low, high))
    return listed


def _refined(modes: Modes, excitation: Excitation, k: int, peak: Peak, low: float, high: float) -> Peak:
    """The largest amplitude of coordinate k between two speeds, by ever closer speeds."""
    for _ in range(PASSES):
        tried = np.linspace(low, high, AROUND)
        try:
            sizes = np.abs(amplitudes(modes, excitation, tried)[:, k])
        except SingularityError:
            return peak
        at = int(np.argmax(sizes))
        if sizes[at] > peak.amplitude:
            peak = Peak(peak.coordinate, float(tried[at]), float(sizes[at]))
        low, high = float(tried[max(at - 1, 0)]), float(tried[min(at + 1, AROUND - 1)])
    return peak
