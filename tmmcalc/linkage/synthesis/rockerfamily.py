"""The family of all crank-rockers with one swing 2 phi and one time ratio, of rocker length 1.

The ends B1 (stretched, A B1 = l + r) and B2 (folded, A B2 = l - r) of the rocker pin are seen from the crank's pivot A
under the overlap angle psi. With the chord c = 2 R sin(phi), the triangle A B1 B2 gives

    (l sin(psi/2))^2 + (r cos(psi/2))^2 = (c/2)^2

so the coupler l, between c/2 and c/(2 sin(psi/2)), is the one free size; 1/l is the parameter, for K = 1 has l endless.
A stands 2 l r/c along the chord from its middle, and (l^2 - r^2) sin(psi)/c off it, on either side.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane, Real, cross


class Family(NamedTuple):
    """Crank-rockers of rocker length 1 with one swing and overlap, by x = c/(2 l) (m,), on one side of the chord."""

    crank: Real
    coupler: Real
    frame: Real
    pivot: Plane  # A, with the rocker's pivot at 0 and its swing about the y axis
    transmission: Real  # least transmission angle [rad]; negative where it is no crank-rocker

    @property
    def longest(self) -> Real:
        """Longest link (m,)."""
        return np.maximum(np.maximum(self.coupler, self.frame), 1.0)


def family(x: Real, half: float, psi: float, side: int) -> Family:
    """The crank-rockers at x = c/(2 l) in (sin(psi/2), 1) with the half swing and overlap angle [rad]."""
    c = 2 * np.sin(half)
    s, k = np.sin(psi / 2), np.cos(psi / 2)
    l = c / 2 / x
    r = l * np.sqrt(np.maximum((x - s) * (x + s), 0)) / k
    off = (l - r) * (l + r) * np.sin(psi) / c
    pivot = 2 * l * r / c + 1j * (np.cos(half) + side * off)
    ends = np.exp(1j * (math.pi / 2 + half)), np.exp(1j * (math.pi / 2 - half))
    frame = np.abs(pivot)
    sizes = np.array([r, l, np.ones_like(l), frame])
    shortest = np.all(r[None, :] <= sizes[1:], axis=0)
    turns = r + sizes.max(axis=0) < sizes.sum(axis=0) - r - sizes.max(axis=0)
    same = cross(pivot, np.asarray(ends[0])) * cross(pivot, np.asarray(ends[1])) > 0
    found = Family(r, l, frame, pivot, np.empty(0))
    angle = np.arccos(np.clip(np.max(np.abs(cosines(found)), axis=0), 0, 1))
    return found._replace(transmission=np.where(shortest & turns & same, angle, -1.0))


def cosines(found: Family) -> Real:
    """Of the transmission angle where the crank is in line with the frame (2, m): stretched and folded."""
    r, l, frame = found[:3]
    return np.array([(l**2 + 1 - (frame + sign * r) ** 2) / (2 * l) for sign in (1, -1)])


class Slopes(NamedTuple):
    """How the family changes with x."""

    cosines: Real  # (2, m) those of the transmission angle
    ratio: Real  # (m,) longest link to the crank


def slopes(x: Real, found: Family, half: float, psi: float, side: int) -> Slopes:
    """Exact derivatives against x of the crank-rockers ``found`` there."""
    r, l, frame = found[:3]
    c, s = 2 * np.sin(half), np.sin(psi / 2)
    dl = -l / x
    dr = r * s**2 / (x * (x - s) * (x + s))
    along, off = 2 * (dl * r + l * dr) / c, 2 * (l * dl - r * dr) * np.sin(psi) / c
    dframe = (found.pivot.real * along + found.pivot.imag * side * off) / frame
    reach = np.array([(frame + sign * r) * (dframe + sign * dr) for sign in (1, -1)])
    links, rates = np.array([l, np.ones_like(l), frame]), np.array([dl, np.zeros_like(l), dframe])
    k = np.argmax(links, axis=0)[None]
    longest, grows = (np.take_along_axis(each, k, axis=0)[0] for each in (links, rates))
    return Slopes(dl - reach / l - cosines(found) * dl / l, (grows - longest * dr / r) / r)
