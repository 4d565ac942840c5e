"""What a page shows moving of cams: followers that touch the drawn profile, motion as in the tables."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from sparing import sparing

from tmmcalc.cams.views import indexing
from tmmcalc.cams.views.flatregion import region_under_face
from tmmcalc.cams.views.motion import CamInMotion
from tmmcalc.cams.views.region import region_of_axis
from tmmcalc.pipeline.picturing import order_of
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.moving import Body, Mark, Track

STAGES = ("cam_law", "cam_synthesis", "cam_profile", "cam_pressure", "cam_forces")
MOTION = """
[cam]
stroke = "{stroke}"
rise = "70 deg"
high_dwell = "20 deg"
return_angle = "80 deg"
rise_law = "{law}"
return_law = "sine"
speed = "20 rad/s"
rotation = "{rotation}"
step = "5 deg"
"""
LOADS = """
[cam.loads]
{mass}
[cam.spring]
safety = 1.3
"""
STEM = {"stroke": "20 mm", "mass": 'mass = "0.4 kg"'}
ROCKER = {"stroke": "20 deg", "mass": 'inertia = "1e-3 kg*m^2"'}
KINDS = {
    "roller": (STEM, 'follower = "translating"\nstart_distance = "50 mm"\noffset = "6 mm"\nroller_radius = "8 mm"'),
    "knife": (STEM, 'follower = "translating"\nstart_distance = "60 mm"\noffset = "-6 mm"\nroller_radius = 0'),
    "flat": (STEM, 'follower = "flat"\nbase_radius = "70 mm"\nface_margin = "2 mm"'),
    "groove": (STEM, 'follower = "translating"\nclosure = "groove"\nstart_distance = "60 mm"\nroller_radius = "7 mm"'),
    "with": (ROCKER, 'follower = "oscillating"\ncentre_distance = "90 mm"\nrocker_length = "80 mm"\n'
                     'start_angle = "35 deg"\nroller_radius = "8 mm"'),
    "against": (ROCKER, 'follower = "oscillating"\nrocker_turn = "against"\ncentre_distance = "90 mm"\n'
                        'rocker_length = "80 mm"\nstart_angle = "35 deg"\nroller_radius = "8 mm"'),
}  # fmt: skip
SCENES = [(kind, sense, "poly5") for kind in KINDS for sense in ("clockwise", "counter-clockwise")]
SCENES += [("roller", "clockwise", "cosine"), ("with", "counter-clockwise", "linear")]  # jumps


class Scene:
    """A view with what it is made of."""

    def __init__(self, path: Path) -> None:
        done = run(load_spec(path), target=STAGES)
        self.results = done.results
        self.made = CamInMotion(order_of(done.spec, done.results))
        self.view = self.made.view()

    def body(self, name: str) -> Body:
        return next(body for body in self.view.bodies if body.name == name)

    def at(self, name: str, point: complex = 0j) -> np.ndarray:
        """Where a point of a body goes."""
        body = self.body(name)
        return body.x.values + 1j * body.y.values + np.exp(1j * body.angle.values) * point

    def marks(self, kind: str, name: str = "cam") -> list[Mark]:
        return [mark for mark in self.body(name).marks if mark.kind == kind]


@pytest.fixture(scope="module", params=SCENES, ids="-".join)
def scene(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Scene:
    kind, sense, law = request.param
    own, sizes = KINDS[kind]
    loads = LOADS.partition("[cam.spring]")[0] if kind == "groove" else LOADS
    path = tmp_path_factory.mktemp("cam") / "spec.toml"
    path.write_text((MOTION + sizes + loads).format(**own, law=law, rotation=sense), encoding="utf-8")
    return Scene(path)


def distances(points: np.ndarray, polygon: Sequence[complex]) -> np.ndarray:
    """From each point to the nearest side of a polygon."""
    corners = np.array(polygon)
    sides = np.roll(corners, -1) - corners
    sides, corners = sides[sides != 0], corners[sides != 0]
    part = np.clip(((points[:, None] - corners) * np.conj(sides)).real / np.abs(sides) ** 2, 0, 1)
    found: np.ndarray = np.abs(points[:, None] - corners - part * sides).min(axis=1)
    return found


def test_the_follower_touches_the_drawn_profile(scene: Scene) -> None:
    if scene.made.follower.kind == "flat":
        face_touches(scene)
        return
    roller = scene.made.follower.roller
    in_cam = scene.at("centre") * np.exp(-1j * scene.body("cam").angle.values)
    for mark in (scene.marks("plate")[-1], *scene.marks("hole")):
        assert np.abs(distances(in_cam, mark.points) - roller).max() < 1e-5 * scene.made.size
    ring = scene.marks("roller", "follower")
    assert [mark.size for mark in ring] == ([roller] if roller else [])
    for mark in ring:
        assert scene.at("follower", mark.points[0]) == pytest.approx(scene.at("centre"), abs=1e-12)


def face_touches(scene: Scene) -> None:
    """No point of the profile is above the face, and one is on it, within the face."""
    drawn = np.array(scene.marks("plate")[0].points) * np.exp(1j * scene.body("cam").angle.values[:, None])
    face = scene.at("follower").imag
    assert np.abs(drawn.imag.max(axis=1) - face).max() < 1e-5 * scene.made.size
    (bar,) = scene.marks("bar", "follower")
    contact = scene.at("contact")
    assert np.abs(contact.imag - face).max() < 1e-9
    assert bar.points[0].real < contact.real.min()
    assert contact.real.max() < bar.points[1].real


def test_the_follower_goes_as_the_law_says(scene: Scene) -> None:
    lift = scene.results["cam_law"].motion[0]
    assert scene.view.values == pytest.approx(scene.results["cam_law"].positions.degrees)
    if scene.made.follower.kind == "oscillating":
        arm = scene.at("centre") - scene.made.pivot
        psi = np.abs(np.angle(arm / -scene.made.pivot))  # from the line of centres
        assert psi - scene.made.follower.start == pytest.approx(lift, abs=1e-9)
        assert np.abs(arm) == pytest.approx(scene.made.follower.rocker)
    else:
        assert scene.at("follower").imag - scene.made.follower.start == pytest.approx(lift, abs=1e-12)


def test_rates_are_those_of_the_tracks(scene: Scene) -> None:
    """A cubic with these rates meets the middle of a step as the law has it."""
    at, task = scene.view.values, scene.made.task
    step = np.diff(at)
    some = np.flatnonzero(step > 1e-9)
    piece = scene.made.profile.positions.piece
    some = some[piece[some] == piece[some + 1]]
    y = task.program.at(np.radians(at[some] + step[some] / 2), piece[some])[0]
    track = scene.body("follower").angle if scene.made.rocks else scene.body("follower").y
    middle = (track.values[some] + track.values[some + 1]) / 2 + step[some] * (
        track.rates[some] - track.rates[some + 1]
    ) / 8
    way = -scene.made._side if scene.made.rocks else 1
    base = track.values[0] - way * scene.made.motion[0][0]
    assert middle == pytest.approx(base + way * y, abs=2e-4 * task.program.stroke)


def test_the_pressure_angle_is_that_of_the_stage(scene: Scene) -> None:
    layers = {layer.name: layer for layer in scene.view.layers}
    if scene.made.follower.kind == "flat":
        assert "pressure" not in layers
        return
    (angle,) = layers["pressure"].angles
    opened = np.abs(angle.end.values - angle.start.values)
    assert opened == pytest.approx(np.abs(scene.results["cam_pressure"].theta), abs=1e-9)


def test_forces_are_along_the_normal_with_their_parts(scene: Scene) -> None:
    layers = {layer.name: layer for layer in scene.view.layers}
    found = {vector.sign: of(vector.x) + 1j * of(vector.y) for vector in layers["force"].vectors}
    contact = scene.results["cam_forces"].contact
    assert np.abs(found["R"]) == pytest.approx(np.abs(contact))
    if scene.made.follower.kind != "flat":
        assert found["R cos θ"] + found["R sin θ"] == pytest.approx(found["R"])
        useful = np.abs(contact * np.cos(scene.results["cam_pressure"].theta))
        assert np.abs(found["R cos θ"]) == pytest.approx(useful, abs=1e-9)
    (velocity,) = layers["velocity"].vectors
    size = np.abs(scene.results["cam_law"].in_time[0]) * (scene.made.follower.rocker if scene.made.rocks else 1.0)
    assert np.abs(of(velocity.x) + 1j * of(velocity.y)) == pytest.approx(size, abs=1e-12)


def test_the_axis_is_in_its_region_where_the_pressure_angle_is_within_its_limits(scene: Scene) -> None:
    found = list(region_of_axis(scene.made, scene.results["cam_synthesis"]))
    if scene.made.follower.kind == "flat":
        assert not found
        return
    (view,) = found
    (angle,) = view.layers[0].angles
    opened = np.abs(angle.end.values - angle.start.values)
    assert opened == pytest.approx(np.abs(scene.results["cam_pressure"].theta), abs=1e-9)
    (region,) = (mark for body in view.bodies for mark in body.marks if mark.kind == "gear")
    turns = np.angle(np.roll(region.points, -1) / np.array(region.points)).sum() / (2 * math.pi)
    assert (abs(turns) > 0.5) == (scene.results["cam_pressure"].verdict == "ok")


def of(track: Track) -> np.ndarray:
    return track.values


def test_stops_are_the_ends_of_phases(scene: Scene) -> None:
    begins = [stop.at for stop in scene.view.stops if str(stop.title).startswith("beginning")]
    assert begins == pytest.approx([0, 70, 90, 170])
    pressed = [stop.at for stop in scene.view.stops if str(stop.title).startswith("largest")]
    if scene.made.follower.kind != "flat":
        reached = scene.results["cam_pressure"]
        assert pressed == pytest.approx(np.degrees([reached.rise.worst.phi, reached.back.worst.phi]))


CONFIGS = sorted(
    path
    for path in (Path(__file__).parent.parent.parent / "configs").glob("*.toml")
    if "\n[cam]" in path.read_text(encoding="utf-8")
)


@sparing("path", CONFIGS, ids=lambda path: path.stem, every=6)
def test_every_spec_with_a_cam_moves(path: Path) -> None:
    view = Scene(path).view
    assert view.whole
    assert len(set(view.shown)) == len(view.shown) >= 3
    assert all(math.isfinite(each) for corner in view.box for each in (corner.real, corner.imag))


@pytest.mark.parametrize("name", ["cam-lantern", "cam-lantern-unequal"])
def test_rollers_of_an_indexing_drive_touch_its_cams(name: str) -> None:
    """Nowhere does a roller cut into its cam; everywhere one touches the front cam or the one behind."""
    done = run(load_spec(CONFIGS[0].parent / f"{name}.toml"), target=("indexing",))
    (view,) = indexing.views(order_of(done.spec, done.results))
    size = done.results["indexing"].wheel
    bodies = {body.name: body for body in view.bodies}
    free = []
    for cam, row in (("front cam", "front rollers"), ("rear cam", "wheel")):
        (profile,) = [mark for mark in bodies[cam].marks if mark.kind == "gear"]
        apart = []
        for mark in bodies[row].marks:
            if mark.kind == "roller":
                at = bodies[row].x.values + np.exp(1j * bodies[row].angle.values) * mark.points[0]
                in_cam = at * np.exp(-1j * bodies[cam].angle.values)
                apart.append(distances(in_cam, profile.points) - mark.size)
        free.append(np.min(apart, axis=0))
    assert np.min(free) > -2e-5 * size
    assert np.min(free, axis=0).max() < 2e-5 * size
    angle = bodies["wheel"].angle.values
    assert angle[-1] - angle[0] == pytest.approx(-4 * math.pi / done.results["indexing"].rollers)
    assert view.values[-1] == pytest.approx(360)


def test_a_flat_face_has_its_region() -> None:
    """The line cuts off the radius of the profile, least where the stage says; the axis stands within the region."""
    spec = load_spec(CONFIGS[0].parent / "cam-flat.toml")
    results = run(spec, target=("cam_synthesis", "cam_profile")).results
    found = results["cam_synthesis"].convexity
    [view] = region_under_face(CamInMotion(order_of(spec, results)), results["cam_synthesis"])
    [radius] = view.readings
    assert radius.value.values.min() == pytest.approx(1e3 * found.radius, rel=1e-3)
    [region] = [mark for mark in view.bodies[0].marks if mark.kind == "gear"]
    axis = next(spot.at for spot in view.spots if spot.name == "O")
    left, right = region.points[:2]
    top = left.imag + (right.imag - left.imag) * (axis.real - left.real) / (right.real - left.real)
    assert axis.imag < top + 1e-9
    [line, point] = view.bodies[1:]
    np.testing.assert_allclose(line.y.values, point.x.values + point.y.values, atol=1e-15)
