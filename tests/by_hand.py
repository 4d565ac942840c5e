"""The six-bar of configs/shaper.toml as one would write it in numpy for this mechanism alone: a yardstick of speed."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

CRANK, PIVOT, SLOTTED, CENTRE_3 = 0.2, 0.62j, 1.02, 0.5  # lengths [m]; the crank's pivot above that of the slotted link
ROD, CENTRE_4, LINE = 0.29, 0.12, 1.0


def shaper(x: NDArray[np.float64], speed: float) -> dict[str, tuple[NDArray[Any], ...]]:
    """What moves at crank angles ``x`` (n,), each with its first and second transfer function and derivative in time.

    Points A, C, D, S3, S4 [m], angles of links 1, 3 and 4 [rad], and the slides A3 and D0 [m].
    """
    u = np.cos(x) + 1j * np.sin(x)
    a, a1, a2 = PIVOT + CRANK * u, 1j * CRANK * u, -CRANK * u
    s = np.sqrt(a.real**2 + a.imag**2)
    e = a / s
    along, across = a1 * e.conj(), a2 * e.conj()
    ds, omega3 = along.real, along.imag / s
    dds, eps3 = across.real + s * omega3**2, (across.imag - 2 * ds * omega3) / s
    e1, e2 = 1j * omega3 * e, (1j * eps3 - omega3**2) * e
    c, c1, c2 = SLOTTED * e, SLOTTED * e1, SLOTTED * e2
    height = LINE - c.imag
    base = np.sqrt(ROD**2 - height**2)
    omega4 = -c1.imag / base
    eps4 = (omega4**2 * height - c2.imag) / base
    rod = base + 1j * height
    rod1, rod2 = 1j * omega4 * rod, (1j * eps4 - omega4**2) * rod
    part = CENTRE_4 / ROD
    found = {
        "A": (a, a1, a2),
        "C": (c, c1, c2),
        "D": (c + rod, c1 + rod1, c2 + rod2),
        "S3": (CENTRE_3 * e, CENTRE_3 * e1, CENTRE_3 * e2),
        "S4": (c + part * rod, c1 + part * rod1, c2 + part * rod2),
        "1": (x, np.ones_like(x), np.zeros_like(x)),
        "3": (np.arctan2(e.imag, e.real), omega3, eps3),
        "4": (np.arctan2(height, base), omega4, eps4),
        "A3": (s, ds, dds),
        "D0": (c.real + base, c1.real - omega4 * height, c2.real - eps4 * height - omega4**2 * base),
    }
    return {name: (*each, speed * each[1], speed**2 * each[2]) for name, each in found.items()}
