"""A mass on a spring and damper whose other end the cam moves: the response along the turn, in closed form on panels.

    z'' + 2 zeta w z' + w^2 z = -y''        z = x - y, in time; zeta < 1

With lambda = -zeta w + i w_d, w_d = w sqrt(1 - zeta^2), the number q = z' - conj(lambda) z obeys q' = lambda q - y'':

    q(t) = e^(lambda (t - t0)) (q(t0) - int e^(-lambda (s - t0)) y''(s) ds),   z = Im q/w_d,   z' = Re q - zeta w z

The integral is that of an analytic function over a panel with no jump in it, so Gauss points give it to rounding. The
cam may turn at a varying speed: dt = dphi/omega and y'' in time is y'' omega^2 + y' omega domega/dphi.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.cams.laws.law import Law, Values
from tmmcalc.cams.program import Program
from tmmcalc.cams.speed import Speed
from tmmcalc.core.errors import AccuracyError, SingularityError
from tmmcalc.core.numerics.gauss import rule
from tmmcalc.core.numerics.panels import Panels, panels
from tmmcalc.core.records import record

Complex = NDArray[np.complexfloating]
SPAN = 2.0  # of |lambda| t on a panel
MANY = 40_000  # panels of a turn
RESONANT = 1e-9  # what a turn takes from a vibration: below it there is no steady state


@record
class Response:
    """The steady vibration over a turn at the points (K, N) of panels, and q at their edges."""

    panels: Panels
    lift: Values  # y (K, N) [m or rad]
    given: Values  # y'' in time (K, N)
    stretch: Values  # z (K, N)
    mass: Values  # x'' (K, N) of the mass
    edges: Complex  # q (K + 1,)
    time: Values  # of the edges (K + 1,) [s]
    ratio: Complex  # (K,) of q over a panel
    kicks: Complex  # (K,) what a panel adds to q


def steady(program: Program, speed: Speed, frequency: float, damping: float) -> Response:
    """The periodic response at the natural frequency w [rad/s] and damping zeta.

    Raises `SingularityError` at resonance without damping, `AccuracyError` where w is too high to follow.
    """
    rate = rate_of(frequency, damping)
    on = _followed(program, speed, abs(rate))
    lift, given, inverse = _forcing(program, speed, on)
    _, time = on.primitive(inverse)
    ratio, kicks, inner = _panels(on, given, inverse, rate)
    total = np.exp(rate * time[-1])
    if abs(1 - total) < RESONANT:
        turns = frequency * time[-1] / (2 * np.pi)
        raise SingularityError(
            f"resonance: the natural frequency is {turns:.6g} times that of the cam and nothing damps it",
            where="cam_elastic",
            value=float(turns),
            remedy="give [cam.elastic] damping, another stiffness or another speed",
        )
    edges = _chained(ratio, kicks, 0j)
    edges = _chained(ratio, kicks, edges[-1] / (1 - total))
    q = inner + edges[:-1, None] * np.exp(rate * _inside(on, inverse))
    z = q.imag / rate.imag
    mass = -2 * damping * frequency * (q.real + rate.real * z) - frequency**2 * z
    return Response(on, lift, given, z, mass, edges, time, ratio, kicks)


def rate_of(frequency: float, damping: float) -> complex:
    """lambda [rad/s] of the free vibration, -zeta w + i w_d."""
    return complex(-damping * frequency, frequency * np.sqrt(1 - damping**2))


def kicks_of(program: Program, speed: Speed, on: Panels, rate: Any) -> tuple[Complex, Complex]:
    """Factor and addition of q over every panel (K,), as precise as the edges of the panels."""
    _, given, inverse = _forcing(program, speed, on)
    return _panels(on, given, inverse, rate)[:2]


def _followed(program: Program, speed: Speed, rate: float) -> Panels:
    """Panels on which |lambda| t is small."""
    slow = float(np.min(speed.omega))
    widest = SPAN * slow / rate
    end = float(program.starts[-1])
    if end / widest > MANY:
        raise AccuracyError(
            f"the natural frequency is {rate / slow:.4g} times that of the cam: the follower is rigid at this speed",
            where="cam_elastic",
            value=rate / slow,
            limit=MANY * SPAN / end,
            remedy="leave [cam.elastic] out, or check its stiffness",
        )
    return panels(0.0, end, [*program.panels.edges.tolist(), *speed.edges.tolist()], min(widest, np.pi / 12))


def _forcing(program: Program, speed: Speed, on: Panels) -> tuple[Values, Values, Values]:
    """y, y'' in time and dt/dphi (K, N) on panels."""
    x, middle = on.x, (on.edges[:-1] + on.edges[1:]) / 2
    piece = np.clip(np.searchsorted(program.edges, middle) - 1, 0, len(program.edges) - 2)
    motion = program.at(x.ravel(), np.repeat(piece, on.order))
    given = speed.acceleration(x.ravel(), motion)
    inverse = 1 / speed.at(x.ravel())[0]
    return motion[0].reshape(x.shape), given.reshape(x.shape), inverse.reshape(x.shape)


def _inside(on: Panels, inverse: Values) -> Values:
    """Time (K, N) since the lower edge of the panel."""
    found: Values = inverse @ rule(on.order).primitive.T * on.width[:, None]
    return found


def _panels(on: Panels, given: Values, inverse: Values, rate: Any) -> tuple[Complex, Complex, Complex]:
    """Factor and addition of q over every panel (K,), and q (K, N) at its points from rest at its lower edge."""
    r, time = rule(on.order), _inside(on, inverse)
    whole = inverse @ r.weights * on.width
    kernel = np.exp(-rate * time) * given * inverse * on.width[:, None]
    ratio = np.exp(rate * whole)
    return ratio, -ratio * (kernel @ r.weights), -np.exp(rate * time) * (kernel @ r.primitive.T)


def _chained(ratio: Complex, kicks: Complex, first: complex) -> Complex:
    """q (K + 1,) at the edges from q at the first one."""
    found, q = [first], first
    for factor, kick in zip(ratio.tolist(), kicks.tolist(), strict=True):
        q = factor * q + kick
        found.append(q)
    return np.array(found)


def residual(law: Law, ratio: Values, damping: float = 0.0) -> Values:
    """Amplitude (n,) of the vibration after a rise from rest, over the stroke.

    ``ratio`` (n,) is the time of the phase over the natural period.

    >>> from tmmcalc.cams.laws.catalogue import LAWS
    >>> residual(LAWS["sine"], np.array([1.5])).round(12).tolist()
    [0.169765272631]
    """
    frequency = 2 * np.pi * ratio
    rate = frequency * complex(-damping, np.sqrt(1 - damping**2))
    on = panels(0.0, 1.0, law.breaks.tolist(), SPAN / max(float(np.max(frequency)), 8.0))
    middle = (on.edges[:-1] + on.edges[1:]) / 2
    piece = np.clip(np.searchsorted(law.breaks, middle) - 1, 0, law.count - 1)
    k = on.x.ravel()
    given = law.at(k, np.repeat(piece, on.order))[2]
    weights = (on.width[:, None] * rule(on.order).weights).ravel() * given
    found: Values = np.abs(np.exp(rate[:, None] * (1 - k)) @ weights) / np.abs(rate.imag)
    return found


@record
class Share:
    """What an end of a piece of a law adds to the free vibration after its phase, over the stroke and by the part k.

    On the piece the stretch is a forced part w, which obeys w'' + 2 zeta W w' + W^2 w = -s'', and a free vibration.
    """

    k: float  # of the end, as the phase runs
    begins: bool  # whether the piece begins there
    angle: float  # [rad] of the harmonic
    harmonic: tuple[float, float, float, float] | None  # B of s'', its angle by k, that over W, |lambda^2 + n^2|^2/W^4
    law: tuple[float, ...]  # s'', s''', ... as far as a polynomial has them
    forced: tuple[float, ...]  # w, w', ... of it; of a harmonic w and w'
    state: complex  # q of the forced motion
    fading: complex  # lambda (1 - k)
    left: complex  # q of the free vibration at the end of the phase


def shares(law: Law, frequency: float, damping: float, *, back: bool = False) -> tuple[Share, ...]:
    """The shares (2 P,) of all ends of pieces in their order; their sum is the integral of e^(lambda (1 - k)) s''.

    ``frequency`` W is the natural one times the time of the phase; ``back``: the law runs from k = 1 to 0, as on a
    return. A natural vibration without damping that is as fast as a harmonic of the law has no shares.

    >>> from tmmcalc.cams.laws.catalogue import LAWS
    >>> whole = sum(each.left for each in shares(LAWS["sine"], 3 * np.pi, 0.0))
    >>> round(abs(whole) / (3 * np.pi), 12)
    0.169765272631
    """
    rate, sense = rate_of(frequency, damping), -1.0 if back else 1.0
    found = []
    for piece in range(law.count)[:: -1 if back else 1]:
        low, high = law.breaks[piece : piece + 2].tolist()
        for begins, at in zip((True, False), (high, low) if back else (low, high), strict=True):
            given = _polynomial(law, piece, at - low, sense)
            q = np.zeros(max(2, len(given)), complex)
            for n in range(len(given)):
                q[n] = sum(each / rate ** (m + 1) for m, each in enumerate(given[n:]))
            turned, angle, harmonic = sense * float(law.frequency[piece]), 0.0, None
            if law.amplitude[piece]:
                angle = float(law.frequency[piece] * (at - low) + law.phase[piece])
                given_most, apart = float(-law.amplitude[piece]) * turned**2, rate**2 + turned**2
                harmonic = given_most, turned, turned / frequency, abs(apart) ** 2 / frequency**4
                size = given_most / apart if apart else complex("nan")
                q[0] += size * (rate * np.sin(angle) + turned * np.cos(angle))
                q[1] += size * turned * (rate * np.cos(angle) - turned * np.sin(angle))
            forced = tuple((q.imag / rate.imag).tolist())
            k = 1.0 - at if back else at
            own, fading = complex(forced[1] - np.conj(rate) * forced[0]), rate * (1.0 - k)
            left = complex(np.exp(fading)) * own * (1.0 if begins else -1.0)
            found.append(Share(k, begins, angle, harmonic, given, forced, own, fading, left))
    return tuple(found)


def _polynomial(law: Law, piece: int, t: float, sense: float) -> tuple[float, ...]:
    """s'', s''', ... of the polynomial of a piece, up to the last that is not zero all along it."""
    c = np.trim_zeros(law.coefficients[piece], "b")
    found = []
    for order in range(2, len(c)):
        c = np.polynomial.polynomial.polyder(c, 2 if order == 2 else 1)
        found.append(float(sense**order * np.polynomial.polynomial.polyval(t, c)))
    return tuple(found)
