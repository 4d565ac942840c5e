"""Spring, forces and work of a follower from its equilibrium, in plain floats or 50 digits (see `exact_peaks`).

The forces on the follower along its lift and across it, and their moments about the lower edge of the guide, add up to
zero; friction opposes the motion with f times the size of the reactions.
"""

from __future__ import annotations

from functools import cache
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
from mpmath import mp, mpf

from cams.exact import motion_at
from cams.exact_peaks import EXACT, PLAIN, edges_of, extremes
from cams.exact_rims import curve

SENSES = {"rise": 1, "return": -1}
LIFTED = ("rise", "high dwell")


class Loaded:
    """A follower with its loads; ``rate`` is (omega, eps) by the angle of the cam of a speed that varies."""

    def __init__(self, task, follower, rate=None):
        self.task, self.follower, self.rate, self.program = task, follower, rate, task.program
        self.turns = follower.kind == "oscillating"
        self.kinds = [self.program.phases[k].kind for k in self.program.places[0]]
        self.stiffness = self.preload = mpf(0)
        self.spring = self.solve_spring()
        self.stiffness, self.preload = self.spring.stiffness, self.spring.preload

    def pressing(self, lib, phi, m):
        """P of inertia and weight along the lift."""
        loads, mpf = self.task.loads, lib.mpf
        second = m[2] * mpf(loads.speed) ** 2
        if self.rate is not None:
            omega, eps = self.rate(lib, phi)
            second = m[2] * omega**2 + m[1] * eps
        return self.weight(lib) - mpf(loads.mass) * second

    def weight(self, lib):
        loads = self.task.loads
        return lib.mpf(0) if self.turns else lib.mpf(loads.mass) * lib.mpf(loads.gravity)

    def own(self, lib, piece):
        """The technological force."""
        force = self.task.loads.force
        return lib.mpf(force.rise if self.kinds[piece] in LIFTED else force.back)

    def solve_spring(self):
        """Stiffness, preload, the least stiffness of the safety, the safety reached."""
        asked, program = self.task.loads.spring, self.program
        stroke = mpf(program.stroke)

        def force(lib, phi, m, piece):
            return self.pressing(lib, phi, m)

        tops = []
        for kind in SENSES:
            _, (size, _) = extremes(program, force, {kind})
            step = abs(size) / stroke

            def low(lib, phi, m, piece, step=step):
                return (
                    self.pressing(lib, phi, m) - (1e-10 * float(step) if lib is PLAIN else mpf(10) ** -28 * step) * m[0]
                )

            _, (value, phi) = extremes(program, low, {kind})
            if value > 0:
                pieces = [k for k, (a, b) in enumerate(zip(edges_of(program), edges_of(program)[1:], strict=False))
                          if self.kinds[k] == kind and a - mpf(10) ** -20 <= phi <= b + mpf(10) ** -20]  # fmt: skip
                tops.append((value, motion_at(program, phi, pieces[0])[0]))
        top = max(tops) if tops else None
        if asked.method == "given":
            c, q = mpf(asked.stiffness), mpf(asked.preload)
        elif asked.method == "none" or (top is None and asked.method == "safety"):
            c = q = mpf(0)
        elif asked.method == "preload":
            f1 = mpf("0.4") * stroke if asked.deflection is None else mpf(asked.deflection)

            def slope(lib, phi, m, piece):
                at = lib.mpf(float(f1)) if lib is PLAIN else f1
                return (self.pressing(lib, phi, m) + lib.mpf(asked.least)) / (at + m[0])

            c = max(extremes(program, slope)[1][0], mpf(0))
            q = c * f1
        else:
            k1 = mpf(asked.safety)
            q = (k1 - 1) * top[0]
            c = max([top[0] / top[1], *((k1 * p - q) / lift for p, lift in tops)])
            if asked.exact:
                c = self._least(k1, q)
        exact = self._least(mpf(asked.safety), q) if asked.method == "safety" and top else None
        reached = self._reached(c, q, top[0]) if top and (c or q) else None
        return SimpleNamespace(stiffness=c, preload=q, highest=q + c * stroke, exact=exact, reached=reached)

    def _least(self, k1, q):
        """The least stiffness that keeps the safety all over the turn."""
        h = mpf(self.program.stroke)

        def needed(lib, phi, m, piece):
            most = lib.most(m[0], lib.mpf(float(h) * 1e-7))
            lack = lib.mpf(self.task.loads.spring.safety) * self.pressing(lib, phi, m)
            return (lack - (float(q) if lib is PLAIN else q)) / most

        return max(extremes(self.program, needed)[1][0], mpf(0))

    def _reached(self, c, q, top):
        def ratio(lib, phi, m, piece):
            spring = float(q) + float(c) * m[0] if lib is PLAIN else q + c * m[0]
            force = lib.most(self.pressing(lib, phi, m), lib.mpf(1e-3) * lib.mpf(float(top)))
            return spring / force

        return extremes(self.program, ratio)[0][0]

    @property
    def length(self):
        """l of the guide in 50 digits; None: there is none."""
        guide, follower = self.task.guide, self.follower
        if self.turns:
            return None
        if guide.top is None:
            return None if guide.length is None else mpf(guide.length)
        roller = mpf(0) if follower.kind == "flat" else mpf(follower.roller)
        return mpf(guide.top) - (mpf(follower.start) + mpf(self.program.stroke) + roller + mpf(guide.gap))

    def at(self, lib, phi, m, piece):
        """All forces at an angle."""
        loads, follower, guide, mpf = self.task.loads, self.follower, self.task.guide, lib.mpf
        y, y1 = m[0], m[1]
        spring = self.preload + self.stiffness * y if lib is EXACT else float(self.preload) + float(self.stiffness) * y
        load = self.pressing(lib, phi, m) + self.own(lib, piece) - spring
        sense, arm, length = SENSES.get(self.kinds[piece], 0), mpf(1), self.length
        length = None if length is None else mpf(length)
        q = None
        if self.turns:
            arm, psi, l0 = mpf(follower.rocker), mpf(follower.start) + y, mpf(follower.centres)
            theta = lib.atan2(arm * (1 - follower.assembly * y1) - l0 * lib.cos(psi), l0 * lib.sin(psi))
            mu = mpf(loads.pivot_friction) * mpf(loads.pivot_radius) / arm + 0 * y
        elif follower.kind == "flat":
            theta = 0 * y
            mu = 0 * y if length is None else 2 * mpf(loads.friction) * abs(y1) / length
        else:
            theta = lib.atan2(y1 + mpf(follower.offset), mpf(follower.start) + y)
            q = mpf(self.program.stroke) + mpf(follower.roller) + mpf(guide.gap) - y
            mu = 0 * y if length is None else mpf(loads.friction) * abs(lib.sin(theta)) * (1 + 2 * q / length)
        lifting = lib.where(load > 0, -sense, sense)
        contact = -load / (arm * (lib.cos(theta) - lifting * mu))
        lower = upper = 0 * y
        if length is not None and follower.kind == "flat":
            lower, upper = contact * y1 / length, -contact * y1 / length
        elif length is not None:
            upper = contact * lib.sin(theta) * q / length
            lower = -contact * lib.sin(theta) - upper
        return SimpleNamespace(
            load=load, theta=theta, mu=mu, contact=contact, lower=follower.sense * lower, upper=follower.sense * upper,
            torque=load * y1, driving=arm * contact * lib.cos(theta) * y1, protrusion=q,
            rubbed=arm * mu * abs(contact * y1), given=self.own(lib, piece) * y1, useful=1 - mu / lib.cos(theta),
        )  # fmt: skip

    def value(self, name):
        """One of them as a function of the turn."""
        return lambda lib, phi, m, piece: getattr(self.at(lib, phi, m, piece), name)

    def pivot(self, phi, m, contact):
        """The force of the frame on the rocker: against that of the cam, along the normal of the pitch curve."""
        _, z1, _ = curve(EXACT, self.follower, phi, m)
        normal = -1j * z1 / abs(z1) * mp.expj(-phi)
        return -contact * (mp.conj(normal) if self.follower.sense < 0 else normal)

    def works(self):
        """Integrals over the turn: driving, its positive part, friction, technological force."""
        total = [mpf(0)] * 4
        for piece, (low, high) in enumerate(zip(edges_of(self.program), edges_of(self.program)[1:], strict=False)):
            if self.kinds[piece] not in SENSES:
                continue
            kinks = self._kinks(piece, low, high)
            for a, b in pairwise(kinks):
                part = _integral(lambda phi, piece=piece: self._rates(phi, piece), a, b)
                total = [have + more for have, more in zip(total, part, strict=True)]
        return total

    def _rates(self, phi, piece):
        now = self.at(EXACT, phi, motion_at(self.program, phi, piece), piece)
        return [now.driving, max(now.driving, mpf(0)), now.rubbed, now.given]

    def _kinks(self, piece, low, high):
        """Edges of a piece, and where load or theta change their sign in it."""
        x = np.linspace(float(low), float(high), 798)[1:-1]  # of a prime number of steps: no joint of a law is a point
        now = self.at(PLAIN, x, self.program.at(x, np.full(len(x), piece)), piece)
        found = [low, high]
        for name in ("load", "theta"):
            values = getattr(now, name) + 0 * x
            for k in np.flatnonzero(values[1:] * values[:-1] < 0):
                f = self.value(name)
                found.append(_bisected(
                    lambda phi, f=f: f(EXACT, phi, motion_at(self.program, phi, piece), piece), mpf(x[k]), mpf(x[k + 1])
                ))  # fmt: skip
        return sorted(found)


def _bisected(g, low, high):
    """The root between two places: the secant from a bracket, halved where it does not close in."""
    below, above = g(low), g(high)
    for _ in range(200):
        x = low - below * (high - low) / (above - below)
        x = min(max(x, low + (high - low) / 1000), high - (high - low) / 1000)
        value = g(x)
        if value == 0 or high - low < mpf(10) ** -25:
            return x
        if (value < 0) == (below < 0):
            low, below, above = x, value, above / 2
        else:
            high, above, below = x, value, below / 2
    return x


@cache
def _gauss(n):
    """Points and weights of Gauss and Legendre on 0 to 1."""
    found = []
    for k in range(n):
        x = mp.cos(mp.pi * (k + mpf(3) / 4) / (n + mpf(1) / 2))
        for _ in range(8):
            p, q = mpf(1), mpf(0)
            for j in range(n):
                p, q = ((2 * j + 1) * x * p - j * q) / (j + 1), p
            slope = n * (x * p - q) / (x * x - 1)
            x -= p / slope
        found.append(((1 + x) / 2, 1 / ((1 - x * x) * slope**2)))
    return found


def _integral(f, low, high, depth=0):
    """Integrals of several functions: whole and in halves, until both agree to 22 digits of the largest."""
    whole, (left, right) = _sum(f, low, high), _halves(f, low, high)
    both = [a + b for a, b in zip(left, right, strict=True)]
    size = max(map(abs, both))
    if depth > 12 or max(abs(a - b) for a, b in zip(whole, both, strict=True)) <= mpf(10) ** -22 * size:
        return both
    middle = (low + high) / 2
    parts = _integral(f, low, middle, depth + 1), _integral(f, middle, high, depth + 1)
    return [a + b for a, b in zip(*parts, strict=True)]


def _halves(f, low, high):
    middle = (low + high) / 2
    return _sum(f, low, middle), _sum(f, middle, high)


def _sum(f, low, high):
    rows = [[w * each for each in f(low + (high - low) * x)] for x, w in _gauss(20)]
    return [(high - low) * sum(column) for column in zip(*rows, strict=True)]
