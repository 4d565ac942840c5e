"""Pitch curve, its offsets and curvature written out by hand, in plain floats or 50 digits (see `exact_peaks`)."""

from __future__ import annotations

from mpmath import mp, mpf

from cams.exact import motion_at
from cams.exact_peaks import EXACT


def curve(lib, follower, phi, motion):
    """z, z', z'' of the pitch curve; of the profile under a flat face z and rho."""
    y, y1, y2, *_ = motion
    turn = lib.expj(phi)
    if follower.kind == "oscillating":
        d, l2 = follower.assembly, lib.mpf(follower.rocker)
        g1, g2 = 1 - d * y1, -d * y2
        arm = l2 * lib.expj(phi - d * (lib.mpf(follower.start) + y))
        axis = lib.mpf(follower.centres) * turn
        return axis - arm, 1j * (axis - g1 * arm), -axis - (1j * g2 - g1**2) * arm
    s = lib.mpf(follower.start) + y
    if follower.kind == "flat":
        return (1j * s - y1) * turn, s + y2
    f, f1 = lib.mpf(follower.offset) + 1j * s, 1j * y1
    return f * turn, (f1 + 1j * f) * turn, (1j * y2 + 2j * f1 - f) * turn


def bend_of(follower):
    """kappa of the pitch curve; rho under a flat face."""

    def bend(lib, phi, motion, piece):
        found = curve(lib, follower, phi, motion)
        if follower.kind == "flat":
            return found[1]
        _, z1, z2 = found
        return (lib.conj(z1) * z2).imag / abs(z1) ** 3

    return bend


def offset_of(follower, distance):
    """The curve that lies inwards by a distance."""

    def offset(lib, phi, motion, piece):
        found = curve(lib, follower, phi, motion)
        tangent = -lib.expj(phi) if follower.kind == "flat" else found[1] / abs(found[1])
        return found[0] + lib.mpf(distance) * 1j * tangent

    return offset


def away_of(follower, distance):
    """How far the curve is from the axis of the cam."""
    offset = offset_of(follower, distance)
    return lambda lib, phi, motion, piece: abs(offset(lib, phi, motion, piece))


def placed(follower, z):
    """In the user's axes."""
    if follower.sense > 0:
        return z
    return mp.conj(z) if follower.kind == "oscillating" else -mp.conj(z)


def both_at(program, first, second, phi, pieces):
    """Two angles in 50 digits near ``phi`` at which two functions of (frame, frame) are 0, by Newton."""
    x, h = mp.matrix(list(map(mpf, phi))), mpf(10) ** -20

    def rest(a, b):
        at = [motion_at(program, each, piece) for each, piece in zip((a, b), pieces, strict=True)]
        return first((a, at[0]), (b, at[1])), second((a, at[0]), (b, at[1]))

    for _ in range(5):
        value = rest(*x)
        columns = [rest(x[0] + h, x[1]), rest(x[0], x[1] + h)]
        slope = mp.matrix(2, 2)
        for j, column in enumerate(columns):
            for i in range(2):
                slope[i, j] = (column[i] - value[i]) / h
        x -= mp.lu_solve(slope, mp.matrix(value))
    return x


def neck_at(program, follower, phi, pieces):
    """Half the chord in 50 digits that is square to the pitch curve at both ends."""

    def square(k):
        def rest(a, b):
            ends = [curve(EXACT, follower, *each) for each in (a, b)]
            chord = ends[1][0] - ends[0][0]
            return (mp.conj(ends[k][1]) * chord).real

        return rest

    a, b = both_at(program, square(0), square(1), phi, pieces)
    ends = [curve(EXACT, follower, x, motion_at(program, x, piece)) for x, piece in zip((a, b), pieces, strict=True)]
    return abs(ends[1][0] - ends[0][0]) / 2


def crossing_at(program, follower, distance, phi, pieces):
    """The two angles in 50 digits at which an offset passes one point."""
    offset = offset_of(follower, distance)

    def gap(a, b):
        return offset(EXACT, *b, None) - offset(EXACT, *a, None)

    return both_at(program, lambda a, b: gap(a, b).real, lambda a, b: gap(a, b).imag, phi, pieces)
