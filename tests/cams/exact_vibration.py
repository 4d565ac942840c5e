"""Vibration of one mass on an elastic train in closed form at 50 digits: Duhamel's integral, piece by piece.

y'' of a piece of a law is a polynomial of t and a harmonic, whose products with exp(sigma t) have antiderivatives.
"""

from __future__ import annotations

from functools import cached_property

from mpmath import mp, mpf

from cams.exact import OWN, POLYNOMIALS, SINE, TRAPEZOID, law_at


def second(law):
    """s'' of every piece: begin and end in k, coefficients of the powers of t = k - begin, amplitude, w, phase."""
    name, one, half = law.name, mpf(1), mpf(1) / 2
    if name == "sine":
        return [(0 * one, one, [], 2 * mp.pi, 2 * mp.pi, 0 * one)]
    if name == "cosine":
        return [(0 * one, one, [], mp.pi**2 / 2, mp.pi, mp.pi / 2)]
    if name in POLYNOMIALS:
        rows = [n * (n - 1) * mpf(c) for n, c in enumerate(POLYNOMIALS[name])][2:]
        return [(0 * one, one, rows, 0, 0, 0)]
    if name == "parab2":
        return [(0 * one, half, [0, mpf(48), mpf(-96)], 0, 0, 0), (half, one, [0, mpf(-48), mpf(96)], 0, 0, 0)]
    if name == "const":
        return [(0 * one, half, [mpf(4)], 0, 0, 0), (half, one, [mpf(-4)], 0, 0, 0)]
    if name in OWN:
        at, values = (list(map(mpf, each)) for each in OWN[name])
        rows = [(a, b, [c, (d - c) / (b - a)], 0, 0, 0)
                for a, b, c, d in zip(at, at[1:], values, values[1:], strict=False)]  # fmt: skip
    else:
        waves = TRAPEZOID if name == "modified_trapezoid" else SINE
        starts = [mpf(each[0]) for each in waves] + [one]
        rows = [(start, end, [mpf(c)], mpf(size), mp.pi * w, mp.pi * p)
                for (_, c, size, w, p), start, end in zip(waves, starts, starts[1:], strict=False)]  # fmt: skip
    a, *_ = rows[0]
    scale = law_at(law, (a + rows[0][1]) / 3, 0)[2] / _value(rows[0], (a + rows[0][1]) / 3)
    return [(low, high, [scale * each for each in c], scale * size, w, p) for low, high, c, size, w, p in rows]


def _value(piece, k):
    low, _, c, size, w, p = piece
    t = k - low
    return sum((each * t**n for n, each in enumerate(c)), mpf(0)) + size * mp.sin(w * t + p)


def integral(piece, sigma, low, high):
    """Of exp(sigma t) s'' between two t of a piece."""
    return _primitive(piece, sigma, high) - _primitive(piece, sigma, low)


def _primitive(piece, sigma, t):
    _, _, c, size, w, p = piece
    total, sign, rest = mp.mpc(0), 1, list(c)
    power = sigma
    while rest:
        total += sign * sum((each * t**n for n, each in enumerate(rest)), mpf(0)) / power
        rest = [n * each for n, each in enumerate(rest)][1:]
        sign, power = -sign, power * sigma
    wave = size * (sigma * mp.sin(w * t + p) - w * mp.cos(w * t + p)) / (sigma**2 + w**2) if size else 0
    return mp.exp(sigma * t) * (total + wave)


def residual(law, ratio, damping):
    """Amplitude after a rise from rest over the stroke."""
    w, zeta = 2 * mp.pi * mpf(ratio), mpf(damping)
    rate = w * mp.mpc(-zeta, mp.sqrt(1 - zeta**2))
    total = sum(mp.exp(rate * (1 - piece[0])) * integral(piece, -rate, 0, piece[1] - piece[0]) for piece in second(law))
    return abs(total) / rate.imag


class Steady:
    """The vibration z that repeats every turn, at a constant speed of the cam."""

    def __init__(self, program, speed, frequency, damping):
        self.w, self.zeta, self.speed = frequency, mpf(damping), mpf(speed)
        self.rate = self.w * mp.mpc(-self.zeta, mp.sqrt(1 - self.zeta**2))
        self.program = program
        self.parts = list(self._parts())

    def _parts(self):
        """(phi begin, phi end, piece of the law or None, phase) of the turn."""
        start = mpf(0)
        for phase in self.program.phases:
            angle = mpf(phase.angle)
            if phase.law is None:
                yield start, start + angle, None, phase
            else:
                back, pieces = phase.end < phase.start, second(phase.law)
                for piece in reversed(pieces) if back else pieces:
                    low, high = (1 - piece[1], 1 - piece[0]) if back else piece[:2]
                    yield start + angle * low, start + angle * high, piece, phase
            start += angle

    def over(self, part, q, phi):
        """q at an angle of a part from that at its begin."""
        begin, _, piece, phase = part
        time = (phi - begin) / self.speed
        found = q * mp.exp(self.rate * time)
        if piece is None:
            return found
        span, height = mpf(phase.angle) / self.speed, abs(mpf(phase.end) - mpf(phase.start))
        moved, sigma = time / span, self.rate * span
        if phase.end < phase.start:
            d = piece[1] - piece[0]
            total = mp.exp(-sigma * (d - moved)) * integral(piece, sigma, d - moved, d)
        else:
            total = mp.exp(sigma * moved) * integral(piece, -sigma, 0, moved)
        return found - height / span * total

    @cached_property
    def edges(self):
        """q at the begin of every part, and at the end of the turn."""
        rest = self._chained(mp.mpc(0))[-1]
        return self._chained(rest / (1 - mp.exp(self.rate * self.parts[-1][1] / self.speed)))

    def _chained(self, q):
        found = [q]
        for part in self.parts:
            found.append(self.over(part, found[-1], part[1]))
        return found

    @property
    def amplitude(self):
        """The largest over the turn, of a dense row of angles."""
        rows = [(part, q, part[0] + (part[1] - part[0]) * k / 12)
                for part, q in zip(self.parts, self.edges, strict=False) for k in range(13)]  # fmt: skip
        return max(abs(self.over(part, q, phi)) for part, q, phi in rows) / self.rate.imag

    def at(self, phi):
        """z and x'' of the mass at an angle."""
        k = next((k for k, part in enumerate(self.parts) if phi <= part[1]), len(self.parts) - 1)
        q = self.over(self.parts[k], self.edges[k], phi)
        z = q.imag / self.rate.imag
        return z, -2 * self.zeta * self.w * (q.real + self.rate.real * z) - self.w**2 * z

    def phases(self):
        """Of every moving phase the amplitude after it alone, from rest, and at its end in the steady motion."""
        for phase in (each for each in self.program.phases if each.law is not None):
            own = [k for k, part in enumerate(self.parts) if part[3] is phase]
            q = mp.mpc(0)
            for k in own:
                q = self.over(self.parts[k], q, self.parts[k][1])
            yield abs(q) / self.rate.imag, abs(self.edges[own[-1] + 1]) / self.rate.imag
