"""Exact derivatives: against extrapolated differences of the whole program, fifty digits, and laws of similarity."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from sparing import sparing

from tests.linkage.scenes import CONFIGS, crank_slider, four_bar
from tmmcalc.core.numerics.alike import numbers, paths
from tmmcalc.linkage.columns import columns
from tmmcalc.linkage.derivatives.forces import differentiate_forces
from tmmcalc.linkage.derivatives.kinematics import differentiate_kinematics
from tmmcalc.linkage.forces.columns import columns as force_columns
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.tables.tasks.loading import to_loading
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.project import parse_spec

# config, key with the place of its value, value there, step of the first difference
KEYS = [
    ("shaper", "mechanism.links[id=1].points.A[0]={}", 0.2, 2e-3),
    ("shaper", "mechanism.links[id=3].mass={}", 55.0, 5.0),
    ("shaper", "mechanism.links[id=4].center[1]={}", 0.0, 0.01),
    ("shaper", "mechanism.joints[name='D0'].guide.through[1]={}", 1.0, 2e-3),
    ("shaper", "mechanism.joints[name='A3'].friction={}", 0.1, 5e-3),
    ("four-bar", "mechanism.links[id=2].points.B[0]={}", None, 5e-4),
    ("four-bar", "mechanism.input.start={}", 0.0, 0.02),
    ("class-three", "mechanism.links[id=1].points.A[0]={}", None, 2e-4),
    ("class-four", "mechanism.input.speed={}", 10.0, 5e-3),
    ("class-three-slider", "mechanism.links[id=3].mass={}", None, 0.1),
    ("crank-slider", "mechanism.links[id=2].points.B[0]={}", None, 5e-4),
    ("slotted-link", "mechanism.links[id=1].points.A[0]={}", None, 2e-4),
    ("scissor-lift", "mechanism.input.start={}", 1.18, 2e-3),
    ("hydraulic-lift", "mechanism.input.speed={}", 0.05, 2e-3),
    ("press", "mechanism.links[id=2].mass={}", None, 0.05),
]
LEVELS = 4


def extrapolated(f: Callable[[float], Any], h: float) -> Any:
    """The derivative at 0 by central differences, extrapolated to the step 0 (Richardson)."""
    row = [(f(h / 2**i) - f(-h / 2**i)) / (2 * h / 2**i) for i in range(LEVELS)]
    for m in range(1, LEVELS):
        row = [(4**m * fine - coarse) / (4**m - 1) for coarse, fine in pairwise(row)]
    return row[0]


class Scene:
    """A config as it is solved where one key has another value."""

    def __init__(self, config: str, key: str, at: float | None) -> None:
        self.text, self.key = (CONFIGS / f"{config}.toml").read_text(encoding="utf-8"), key
        self.at = self._given() if at is None else at

    def _given(self) -> float:
        value: Any = parse_spec(self.text, folder=CONFIGS).mechanism
        for part in self.key.removeprefix("mechanism.").removesuffix("={}").replace("]", "").split("."):
            name, *rest = part.split("[")
            value = value[name] if isinstance(value, dict) else getattr(value, name)
            for each in rest:
                number = each.removeprefix("id=")
                value = next(v for v in value if v.id == int(number)) if "id=" in each else value[int(each)]
        return float(value)

    def tree(self, d: float) -> Any:
        spec = parse_spec(self.text, overrides=[self.key.format(repr(self.at + d))], folder=CONFIGS)
        return to_linkage(spec.linkage), to_loading(spec)

    def solved(self, d: float) -> tuple[dict[str, Any], dict[str, Any]]:
        """Columns of both tables; where friction jumps, rows before it left out."""
        mechanism, loading = self.tree(d)
        kinematics = solve_kinematics(mechanism)
        forces = solve_forces(mechanism, loading, kinematics)
        rows = [i for i, label in enumerate(forces.labels) if not label.endswith("-")]
        told = {column.header: column.make()[rows] for column in force_columns(forces)}
        return {column.header: column.make() for column in columns(kinematics)}, told

    def slopes(self, h: float) -> Any:
        return extrapolated(lambda d: np.array(numbers(self.tree(d)), complex), h)[None]


def scale_of(told: dict[str, Any], header: str) -> float:
    """Largest value among all columns of the same unit; of moments among the forces, whose arms they are made of."""
    unit = header[header.index("[") :].replace("[N*m]", "[N]")
    return max(float(np.max(np.abs(value))) for key, value in told.items() if key.endswith(unit)) or 1.0


@sparing(("config", "key", "at", "h"), KEYS, every=3, first=1)
def test_derivatives_are_those_of_the_whole_program(config: str, key: str, at: float | None, h: float) -> None:
    scene = Scene(config, key, at)
    mechanism, loading = scene.tree(0.0)
    slopes = scene.slopes(h)
    kinematics = solve_kinematics(mechanism)
    forces = solve_forces(mechanism, loading, kinematics)
    moved = differentiate_kinematics(mechanism, kinematics, slopes[:, : len(numbers(mechanism))])
    pressed = differentiate_forces(mechanism, loading, kinematics, forces, slopes)
    assert pressed is not None
    cache: dict[float, Any] = {}

    def solved(d: float) -> Any:
        if d not in cache:
            cache[d] = scene.solved(d)
        return cache[d]

    kept = [i for i, label in enumerate(forces.labels) if not label.endswith("-")]
    jumps = {label.removesuffix("-") for label in forces.labels if label.endswith("-")}
    steady = [i for i, row in enumerate(kept) if forces.labels[row] not in jumps]
    for part, found, rows, these in ((0, moved, slice(None), slice(None)), (1, pressed, kept, steady)):
        told = solved(0.0)[part]
        for header, derivative in found.columns.items():
            expected = extrapolated(lambda d, part=part, header=header: solved(d)[part][header], h)[these]
            value = derivative.value[0][rows][these]
            rounding = 1e-11 * scale_of(told, header) / h  # of the differences
            least = 1e-8 * float(np.max(np.abs(expected)))
            assert np.max(np.abs(value - expected)) < least + rounding, header


def test_every_column_of_the_motion_has_a_derivative() -> None:
    mechanism = to_linkage(parse_spec((CONFIGS / "shaper.toml").read_text(), folder=CONFIGS).linkage)
    kinematics = solve_kinematics(mechanism)
    found = differentiate_kinematics(mechanism, kinematics, np.zeros((2, len(numbers(mechanism)))))
    assert [*found.columns] == [column.header for column in columns(kinematics)]
    assert all(not each.value.any() and each.value.shape == (2, 25) for each in found.columns.values())


def directions(mechanism: Any, slope: Callable[[str, complex], complex]) -> Any:
    return np.array([[slope(p, complex(v)) for p, v in zip(paths(mechanism), numbers(mechanism), strict=True)]])


def is_length(path: str) -> bool:
    return ".points." in path or path.startswith("frame.points")


@pytest.mark.parametrize("mechanism", [four_bar(0.1, 0.3, 0.25, 0.28 + 0.05j), crank_slider(0.1, 0.35, 0.02)])
def test_all_lengths_together_scale_the_motion(mechanism: Any) -> None:
    kinematics = solve_kinematics(mechanism)
    found = differentiate_kinematics(mechanism, kinematics, directions(mechanism, lambda p, v: v * is_length(p)))
    for column in columns(kinematics):
        expected = column.make() if "[m" in column.header else 0.0
        derivative = found.columns[column.header]
        assert np.allclose(derivative.value[0], expected, rtol=1e-12, atol=1e-12 * 50), column.header


def test_velocities_go_with_the_speed_and_accelerations_with_its_square() -> None:
    mechanism = four_bar(0.1, 0.3, 0.25, 0.28 + 0.05j)
    kinematics = solve_kinematics(mechanism)
    slopes = directions(mechanism, lambda p, v: v if p == "input.speed" else 0)
    found = differentiate_kinematics(mechanism, kinematics, slopes)
    power = {"m/s": 1, "rad/s": 1, "m/s^2": 2, "rad/s^2": 2}
    for column in columns(kinematics):
        value = found.columns[column.header].value[0]
        assert np.allclose(value, power.get(column.unit, 0) * column.make(), rtol=1e-13, atol=1e-15), column.header
    (output,) = found.outputs
    for derivative, extreme in zip(output.acceleration, kinematics.summaries[0].acceleration, strict=True):
        assert derivative.value[0] == pytest.approx(2 * extreme.value, rel=1e-12)


def test_extremes_of_a_shaper_follow_their_places() -> None:
    scene = Scene("shaper", "mechanism.links[id=1].points.A[0]={}", 0.2)
    mechanism, _ = scene.tree(0.0)
    slopes = scene.slopes(2e-3)[:, : len(numbers(mechanism))]

    def told(d: float) -> Any:
        own = solve_kinematics(scene.tree(d)[0]).summaries[0]
        centres = [(centre.x, centre.value) for centre in own.dead_centres]
        numbers_told = (own.stroke, own.working_angle, own.idle_angle, own.time_ratio)
        extremes = [e.value for e in (*own.velocity, *own.acceleration)]
        return np.array([*np.ravel(np.array(centres).T), *numbers_told, *extremes], float)

    (found,) = differentiate_kinematics(mechanism, solve_kinematics(mechanism), slopes).outputs
    parts: Any = (found.stroke, found.working_angle, found.idle_angle, found.time_ratio)
    parts = (*parts, *found.velocity, *found.acceleration)
    value = [*found.dead_centres.value[0], *found.dead_values.value[0], *(part.value[0] for part in parts)]
    expected = extrapolated(told, 2e-3)
    assert np.allclose(value, expected, rtol=1e-8, atol=1e-7)
    # closed forms of a slotted link with pivots a = 620 mm apart: sin(beta) = r / a, stroke of the slot's end
    r, a, full = 0.2, 0.62, np.pi
    working = full + 2 * np.arcsin(r / a)
    assert solve_kinematics(mechanism).summaries[0].working_angle == pytest.approx(working)
    assert parts[1].value[0] == pytest.approx(2 / np.sqrt(a**2 - r**2), rel=1e-10)


def truth(lengths: Any, x: Any) -> Any:
    """B (complex, 50 digits) of a four-bar O(0, 0), A, B, C of the assembly +1, at the crank angle x."""
    l1, l2, l3, cx, cy = lengths
    a, c = l1 * mp.expj(x), mp.mpc(cx, cy)
    q = c - a
    d = (l2**2 - l3**2 + abs(q) ** 2) / (2 * abs(q))
    return a + (d + 1j * mp.sqrt(l2**2 - d**2)) * q / abs(q)


def test_a_dyad_against_fifty_digits() -> None:
    lengths = [0.1, 0.3, 0.25, 0.28, 0.05]
    mechanism = four_bar(*lengths[:3], complex(*lengths[3:]))
    kinematics = solve_kinematics(mechanism)
    names = {
        0: lambda p, v: 1 if v == 0.1 and is_length(p) else 0,
        1: lambda p, v: 1 if v == 0.3 and is_length(p) else 0,
        2: lambda p, v: 1 if v == 0.25 and is_length(p) else 0,
        3: lambda p, v: 1 if v == 0.28 + 0.05j else 0,
        4: lambda p, v: 1j if v == 0.28 + 0.05j else 0,
    }
    slopes = np.concatenate([directions(mechanism, names[k]) for k in range(5)])
    found = differentiate_kinematics(mechanism, kinematics, slopes)
    with mp.workdps(60):
        h = mp.mpf(10) ** -15
        own = [mp.mpf(v) for v in lengths]

        def at(k: int, s: int, x: Any) -> Any:
            return truth([v + s * h * (i == k) for i, v in enumerate(own)], x)

        for k in range(5):
            for row in range(0, len(kinematics.x), 5):
                x = mp.mpf(float(kinematics.x[row]))

                def slope(x: Any, k: int = k) -> Any:
                    return (at(k, 1, x) - at(k, -1, x)) / (2 * h)

                t = mp.mpf(10) ** -8
                jet = slope(x - t), slope(x), slope(x + t)
                expected = (jet[1], (jet[2] - jet[0]) / (2 * t), (jet[2] - 2 * jet[1] + jet[0]) / t**2)
                for prefix, value in zip(("", "v", "a"), expected, strict=True):
                    unit = {"": "m", "v": "m/s", "a": "m/s^2"}[prefix]
                    for axis, part in (("x", value.real), ("y", value.imag)):
                        derivative = found.columns[f"{prefix}{axis}_B[{unit}]"]
                        scale = float(np.max(np.abs(derivative.value[k])))
                        off = abs(float(derivative.value[k, row] - part))
                        assert off < 1e-12 * max(scale, 1.0)
                        assert off < derivative.error[k] + 1e-14 * scale


def test_forces_go_with_all_masses_and_loads() -> None:
    spec = parse_spec((CONFIGS / "shaper.toml").read_text(), folder=CONFIGS)
    tree = to_linkage(spec.linkage), to_loading(spec)
    kinematics = solve_kinematics(tree[0])
    forces = solve_forces(*tree, kinematics)
    given = (".mass", ".inertia", "law.value")
    slopes = directions(tree, lambda p, v: v if p.startswith("1.") and p.endswith(given) else 0)
    found = differentiate_forces(*tree, kinematics, forces, slopes)
    assert found is not None
    for column in force_columns(forces)[1:-2]:
        value, own = found.columns[column.header].value[0], column.make()
        assert np.max(np.abs(value - own)) < 1e-11 * float(np.max(np.abs(forces.reaction))), column.header


def test_an_indicator_diagram_is_left_to_differences() -> None:
    spec = parse_spec((CONFIGS / "four-stroke-engine.toml").read_text(), folder=CONFIGS)
    tree = to_linkage(spec.linkage), to_loading(spec)
    kinematics = solve_kinematics(tree[0])
    slopes = np.zeros((1, len(numbers(tree))))
    assert differentiate_forces(*tree, kinematics, solve_forces(*tree, kinematics), slopes) is None
