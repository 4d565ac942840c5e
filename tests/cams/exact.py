"""Laws of motion, pitch curves and pressure angles at 50 digits, written out by hand; and how estimates are judged."""

from __future__ import annotations

from functools import cache

import numpy as np
from bounding import assert_bounds, part
from mpmath import mp, mpc, mpf

from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.laws.own import of_accelerations
from tmmcalc.cams.program import Phase, Program
from tmmcalc.core.numerics.extended import WIDER

mp.dps = 50
HALF = mpf(1) / 2
POLYNOMIALS = {
    "linear": [0, 0, 3, -2],
    "shun": [0, 0, 0, 10, -15, 6],
    "poly5": [0, 0, 0, 18, -55, 78, -56, 16],
    "poly4567": [0, 0, 0, 0, 35, -84, 70, -20],
}
TRAPEZOID = [(0, 0, 1, 4, 0), (HALF / 4, 1, 0, 1, 0), (3 * HALF / 4, 0, 1, 4, HALF), (5 * HALF / 4, -1, 0, 1, 0),
             (7 * HALF / 4, 0, -1, 4, HALF)]  # fmt: skip
SINE = [(0, 0, 1, 4, 0), (HALF / 4, 0, 1, mpf(4) / 3, HALF), (7 * HALF / 4, 0, -1, 4, HALF)]
SCENES = part(200, 8)


def law_at(law, k, piece):
    """s, s', s'', s''' at k on a piece of a law."""
    name = law.name
    if name == "sine":
        w = 2 * mp.pi
        return [k - mp.sin(w * k) / w, 1 - mp.cos(w * k), w * mp.sin(w * k), w * w * mp.cos(w * k)]
    if name == "cosine":
        w = mp.pi
        return [(1 - mp.cos(w * k)) / 2, w * mp.sin(w * k) / 2, w**2 * mp.cos(w * k) / 2, -(w**3) * mp.sin(w * k) / 2]
    if name in POLYNOMIALS:
        return _of_powers(POLYNOMIALS[name], k)
    if name in ("parab2", "const"):
        first = [0, 0, 0, 8, -8] if name == "parab2" else [0, 0, 2]
        if piece == 0:
            return _of_powers(first, k)
        s, v, a, j = _of_powers(first, 1 - k)
        return [1 - s, v, -a, j]
    if name in ("modified_trapezoid", "modified_sine"):
        waves = TRAPEZOID if name == "modified_trapezoid" else SINE
        return _of_waves(waves, k, piece)
    return _of_lines(law, k, piece)


def _of_powers(c, k):
    found = []
    for _ in range(4):
        value = mpf(0)
        for each in reversed(c):
            value = value * k + each
        found.append(value)
        c = [n * each for n, each in enumerate(c)][1:]
    return found


def _of_waves(waves, k, piece):
    """s'' = c + A sin(pi (w t + p)), pieces (start, c, A, w, p), integrated and brought to s(1) = 1."""
    starts = _begins(len(waves) == len(TRAPEZOID))
    start, s, v = starts[piece]
    return [each / starts[-1][1] for each in _of_wave(waves[piece], k - start, s, v)]


def _of_wave(wave, t, s, v):
    _, c, size, w, p = wave
    w, p = mp.pi * w, mp.pi * p
    sine, cosine = mp.sin(w * t + p), mp.cos(w * t + p)
    return [
        s + v * t + c * t * t / 2 - size / w**2 * (sine - mp.sin(p)) + size / w * mp.cos(p) * t,
        v + c * t - size / w * (cosine - mp.cos(p)),
        c + size * sine,
        size * w * cosine,
    ]


@cache
def _begins(trapezoid):
    """Start, s and s' of every piece of a law of waves, and of its end, before it is brought to s(1) = 1."""
    waves, s, v = TRAPEZOID if trapezoid else SINE, mpf(0), mpf(0)
    starts = [mpf(each[0]) for each in waves] + [mpf(1)]
    found = [(starts[0], s, v)]
    for wave, start, end in zip(waves, starts, starts[1:], strict=False):
        s, v, *_ = _of_wave(wave, end - start, s, v)
        found.append((end, s, v))
    return found


OWN = {}  # tables k, s'' of the random laws, by name


def _of_lines(law, k, piece):
    """s'' straight between the points of a table."""
    starts = _corners(law.name)
    start, s, v, low, slope = starts[piece]
    t = k - start
    found = [s + v * t + low * t**2 / 2 + slope * t**3 / 6, v + low * t + slope * t**2 / 2, low + slope * t, slope]
    return [each / starts[-1][1] for each in found]


@cache
def _corners(name):
    """Begins of the pieces of a law of lines with s, s', s'' and the slope there, and its end, not yet at s(1) = 1."""
    at, values = (list(map(mpf, each)) for each in OWN[name])
    s, v, found = mpf(0), mpf(0), []
    for start, end, low, high in zip(at, at[1:], values, values[1:], strict=False):
        t, slope = end - start, (high - low) / (end - start)
        found.append((start, s, v, low, slope))
        s, v = s + v * t + low * t**2 / 2 + slope * t**3 / 6, v + low * t + slope * t**2 / 2
    return [*found, (at[-1], s, v, values[-1], mpf(0))]


def random_own(random, name):
    """A law of random accelerations in a table, antisymmetric so that it ends at rest."""
    count = int(random.integers(2, 6))
    k = np.concatenate(([0.0], np.sort(random.uniform(0.03, 0.47, count)), [0.5]))
    a = np.append(random.uniform(0.2, 2.0, count + 1), 0.0)
    k, a = np.concatenate((k, 1 - k[-2::-1])), np.concatenate((a, -a[-2::-1]))
    OWN[name] = k, a
    return of_accelerations(k, a, name)


def random_program(random, stroke, own=True):
    """Phases, laws and stroke at random; one in six has laws of its own."""
    names = list(LAWS)
    laws = [LAWS[names[random.integers(len(names))]] for _ in range(2)]
    if own and random.random() < 1 / 6:
        laws = [random_own(random, f"own {k} {len(OWN)}") for k in range(2)]
    rise, back = np.radians(random.uniform(50, 150, 2)).tolist()
    high = float(np.radians(random.uniform(5, 50)))
    moves = (
        Phase("rise", rise, 0.0, stroke, laws[0]),
        Phase("high dwell", high, stroke, stroke),
        Phase("return", back, stroke, 0.0, laws[1]),
        Phase("low dwell", 2 * np.pi - rise - high - back, 0.0, 0.0),
    )
    return Program(moves)


def motion_at(program, phi, piece):
    """y, y', y'', y''' at an angle on a piece of a program."""
    phase, inner, start, lowest, scales = _placed(program, piece)
    if phase.law is None:
        return [lowest, mpf(0), mpf(0), mpf(0)]
    at = phi if isinstance(phi, mpf) else mpf(float(phi))
    k = (at - start) / mpf(phase.angle)
    s = law_at(phase.law, 1 - k if phase.end < phase.start else k, inner)
    found = [scale * each for scale, each in zip(scales, s, strict=True)]
    return [found[0] + lowest, *found[1:]]


PLACED = {}  # programs with what `_placed` tells of them, by the identity of the program, the piece and the precision


def _placed(program, piece):
    """Of a piece: its phase, its number in the law, where the phase begins, the lowest y, scales of s, s' and so on."""
    key = id(program), piece, mp.prec
    if key not in PLACED:
        number, inner = program.places[0][piece], int(program.places[1][piece])
        phase = program.phases[number]
        start = sum((mpf(each.angle) for each in program.phases[:number]), mpf(0))
        lowest, height = min(mpf(phase.start), mpf(phase.end)), abs(mpf(phase.end) - mpf(phase.start))
        way = mpf(-1 if phase.end < phase.start else 1) / mpf(phase.angle)
        PLACED[key] = program, (phase, inner, start, lowest, [height * way**n for n in range(4)])
    return PLACED[key][1]


def pitch_at(follower, phi, motion):
    """Point, tangent and curvature of the pitch curve; under a flat face of the profile, its curvature 1/rho."""
    y, y1, y2, _ = motion
    phi = mpf(float(phi))
    turn = mp.expjpi(phi / mp.pi)
    if follower.kind == "oscillating":
        d = follower.assembly
        g1, g2 = 1 - d * y1, -d * y2
        arm = mpf(follower.rocker) * mp.expj(phi - d * (mpf(follower.start) + y))
        axis = mpf(follower.centres) * turn
        z, z1, z2 = axis - arm, mpc(0, 1) * (axis - g1 * arm), -axis - (mpc(0, 1) * g2 - g1**2) * arm
    else:
        s = mpf(follower.start) + y
        if follower.kind == "flat":
            return mpc(-y1, s) * turn, -turn, 1 / (s + y2)
        f, f1, f2 = mpc(follower.offset, s), mpc(0, y1), mpc(0, y2)
        z, z1, z2 = f * turn, (f1 + mpc(0, 1) * f) * turn, (f2 + 2 * mpc(0, 1) * f1 - f) * turn
    return z, z1 / abs(z1), (mp.conj(z1) * z2).imag / abs(z1) ** 3


def theta_at(follower, motion):
    """The pressure angle, from its tangent (5.42), (5.48)."""
    y, y1, *_ = motion
    if follower.kind == "flat":
        return mpf(0)
    if follower.kind == "translating":
        return mp.atan2(y1 + mpf(follower.offset), mpf(follower.start) + y)
    psi, l0 = mpf(follower.start) + y, mpf(follower.centres)
    return mp.atan2(mpf(follower.rocker) * (1 - follower.assembly * y1) - l0 * mp.cos(psi), l0 * mp.sin(psi))


def missed(found, exact, size=None):
    """Largest difference of numbers from numbers of 50 digits, over the largest of them or over ``size``."""
    pairs = list(zip(np.asarray(found).tolist(), exact, strict=True))
    scale = max((abs(true) for _, true in pairs), default=mpf(0)) if size is None else mpf(size)
    worst = max((abs((mpc(each) if isinstance(each, complex) else mpf(each)) - true) for each, true in pairs))
    return float(worst / scale) if scale else 0.0


def judge(pairs, scenes=SCENES):
    """Of estimates and true errors, by quantity: the estimate bounds 99 in 100 and is not useless."""
    assert WIDER
    for name, both in pairs.items():
        assert_bounds(both, name, scenes=scenes)
