"""Balancing with masses a million times apart, and of a rotor whose unbalance is far below what can be made."""

from __future__ import annotations

import cmath

import numpy as np
import pytest

from .scenes import solved
from .truth import TURN, Slider

EVEN = np.arange(256) * TURN / 256  # harmonics of the slider's motion die within far fewer


def harmonic(values: np.ndarray, order: int) -> complex:
    return complex(np.mean(values * np.exp(-1j * order * EVEN)))


def shaking(rod: float, slider: float) -> np.ndarray:
    """Shaking force (256,) over omega^2: -sum m d2r/dphi2 of the two centres of mass, from their places by Fourier."""
    body = Slider(m2=rod, s=0.08, m3=slider)
    lean = body.lean(EVEN)
    centre = body.r * np.exp(1j * EVEN) + body.s * np.exp(-1j * lean)
    together = rod * centre + slider * body.x(EVEN)
    orders = np.fft.fftfreq(256, 1 / 256)
    return np.asarray(np.fft.ifft(np.fft.fft(together) * orders**2))


@pytest.mark.parametrize(
    ("rod", "slider"), [(1e-3, 1e3), (1e3, 1e-3), (1.0, 0.0), (0.0, 1.0), (1e-9, 1e-9), (1e9, 1e9)]
)
def test_counterweights(rod: float, slider: float) -> None:
    masses = f"mechanism.links[id=2].mass={rod!r}", f"mechanism.links[id=3].mass={slider!r}"
    linkage = solved("mass-ratio", *masses, target="balance").results["balance"].linkage
    force, size = shaking(rod, slider), rod + slider
    first, counter = harmonic(force, 1), harmonic(force, -1)
    schemes = {scheme.name: scheme.balance for scheme in linkage.schemes}
    (weight,) = schemes["least squares"].weights
    assert weight.moment == pytest.approx(-first, abs=1e-13 * size)
    moments = {each.order: each.moment for each in schemes["lanchester"].weights}
    assert moments[1] == pytest.approx(-first, abs=1e-13 * size)
    assert moments[-1] == pytest.approx(-counter, abs=1e-13 * size)
    left = np.mean(np.abs(force) ** 2) - abs(first) ** 2
    assert schemes["least squares"].after.rms == pytest.approx(25 * np.sqrt(left), abs=1e-11 * size)


def test_masses_far_below_all_others_change_nothing() -> None:
    heavy = solved("mass-ratio", target="balance").results["balance"].linkage
    alone = solved("mass-ratio", "mechanism.links[id=2].mass=0", target="balance").results["balance"].linkage
    assert np.max(np.abs(heavy.shaking.force - alone.shaking.force)) < 2e-6 * np.max(np.abs(alone.shaking.force))


@pytest.mark.parametrize("gap", [1e-9, 1e-6, 1e-3])
@pytest.mark.parametrize("moment", [1e-6, 1.0, 1e6])
def test_rotor_between_near_planes(gap: float, moment: float) -> None:
    """The lever rule: U at a distance a from the first plane asks for U a/gap in the second."""
    planes, unbalance = (
        f"rotor.planes=[0.5, {0.5 + gap!r}]",
        f'rotor.unbalances=[{{moment="{moment!r} g*mm", position=1}}]',
    )
    rotor = solved("rotor-ratio", planes, unbalance).results["balance"].rotor
    given, apart = moment * 1e-6, (0.5 + gap) - 0.5
    second = -given * 0.5 / apart
    first = -given - second
    found = rotor.balance.moments
    assert found[1] == pytest.approx(second, rel=1e-12)
    assert found[0] == pytest.approx(first, rel=1e-12)
    for weight, asked in zip(rotor.dynamic, (first, second), strict=True):
        assert weight.mass == pytest.approx(abs(asked) / 0.5, rel=1e-12)
        assert cmath.rect(1, weight.angle).real == pytest.approx(np.sign(asked), abs=1e-12)
    assert abs(rotor.balance.dynamic.resultant) <= 1e-15 * abs(second) * 4
