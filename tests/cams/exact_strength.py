"""What the requirements are judged by, written out by hand, in plain floats or 50 digits (see `exact_peaks`)."""

from __future__ import annotations

from mpmath import mp, mpf

from cams.exact_peaks import EXACT, extremes
from cams.exact_rims import bend_of, curve


class Judged:
    """Rows and extremes of a loaded follower (see `exact_forces`)."""

    def __init__(self, loaded):
        self.loaded, self.task, self.follower = loaded, loaded.task, loaded.follower
        self.needs, self.flat = self.task.requirements, loaded.follower.kind == "flat"
        self.top = max(map(abs, self.ends(loaded.value("contact"))))

    def ends(self, f):
        """Least and largest value over the turn."""
        return [value for value, _ in extremes(self.loaded.program, f)]

    def curvature(self, lib, phi, m, piece):
        """kappa of the pitch curve; of the profile under a flat face."""
        found = bend_of(self.follower)(lib, phi, m, piece)
        return 1 / found if self.flat else found

    def run(self, lib, phi, m, piece):
        """How fast the roller's speed grows: the tangential part of the acceleration along the pitch curve."""
        _, z1, z2 = curve(lib, self.follower, phi, m)
        found = (lib.conj(z1) * z2).real / abs(z1)
        if self.loaded.rate is None:
            return found
        omega, eps = self.loaded.rate(lib, phi)
        side = lib.sign(self.loaded.at(lib, phi, m, piece).contact) * lib.mpf(self.follower.roller)
        return (omega**2 * found + eps * (abs(z1) - side)) / lib.mpf(self.task.loads.speed) ** 2

    @property
    def pin(self):
        """r0 in 50 digits; None: nothing is known of it."""
        needs = self.needs
        if needs.pin is not None:
            return mpf(needs.pin)
        if needs.pin_pressure is None:
            return None
        return mp.sqrt(self.top / (mpf(needs.pin_ratio) * mpf(needs.pin_pressure))) / 2

    def factors(self):
        """C1 and C2 of the slip function."""
        needs, r2, r0 = self.needs, mpf(self.follower.roller), self.pin
        friction = mpf(needs.roller_friction)
        inertia = mp.pi / 2 * mpf(needs.width) * mpf(needs.roller_density) * (r2**4 - r0**4)
        if needs.roller_inertia is not None:
            inertia = mpf(needs.roller_inertia)
        c1 = (mpf(needs.rolling_arm) + mpf(needs.pin_friction) * r0) / (friction * r2)
        return c1, inertia * mpf(self.task.loads.speed) ** 2 / (friction * r2**2)

    def slip(self, c1, c2):
        """D as a function of the turn; 0 where nothing presses."""

        def found(lib, phi, m, piece):
            size = abs(self.loaded.at(lib, phi, m, piece).contact)
            a, b = (c1, c2) if lib is EXACT else (float(c1), float(c2))
            return abs(a + b * self.run(lib, phi, m, piece) / lib.most(size, lib.mpf(1e-280)))

        return found

    def stress(self, lib, phi, m, piece):
        """sigma_H of the wall that presses (5.86 to 5.90)."""
        needs, contact = self.needs, self.loaded.at(lib, phi, m, piece).contact
        kappa, r2 = self.curvature(lib, phi, m, piece), lib.mpf(self.follower.roller)
        inverse = abs(kappa) if self.flat else 1 / (r2 * (1 - lib.sign(contact) * kappa * r2))
        return lib.mpf(0.418) * lib.sqrt(lib.mpf(needs.modulus) / lib.mpf(needs.width) * abs(contact) * inverse)

    def reduced(self, lib, phi, m, piece):
        """M_E (5.73, 5.74)."""
        now = self.loaded.at(lib, phi, m, piece)
        bend = now.contact * lib.mpf(self.needs.span) / 4
        return lib.sqrt(bend**2 + lib.mpf(self.needs.torsion) * now.torque**2)

    def bending(self, lib, phi, m, piece):
        """Stress of the stem at the lower edge of its guide."""
        now = self.loaded.at(lib, phi, m, piece)
        moment = now.contact * (m[1] if self.flat else lib.sin(now.theta) * now.protrusion)
        return abs(moment) * 4 / (lib.pi * lib.mpf(self.task.guide.stem) ** 3)

    def pressure(self, lib, phi, m, piece):
        """Of the edge of the guide that is pressed more."""
        now, guide = self.loaded.at(lib, phi, m, piece), self.task.guide
        return lib.most(abs(now.lower), abs(now.upper)) / (2 * lib.mpf(guide.land) * lib.mpf(guide.stem))

    def shafts(self):
        """r1' and r1'' (5.77, 5.78)."""
        needs = self.needs
        strength = mp.cbrt(4 * self.ends(self.reduced)[1] / (mp.pi * mpf(needs.bending)))
        bent = 12 * mp.pi * mpf(needs.young) * mpf(needs.deflection)
        return strength, mp.root(self.top * mpf(needs.span) ** 3 / bent, 4)
