"""A dyad with given outer joints: the worked cases, mechanisms cut apart, differences, the error estimate, faults."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from bounding import accepted, assert_bounds
from faults import HOSTILE, Faults, check_lines
from typer.testing import CliRunner

import tmmcalc
from linkage.scenes import CONFIGS
from tmmcalc.cli.app import app
from tmmcalc.core.errors import AccuracyError, AssemblyError, SingularityError, TmmError, UsageError
from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.linkage.dyads import KINDS
from tmmcalc.linkage.dyadstate import DyadState, DyadTask, LinkPoint, Port, solve_dyad_task
from tmmcalc.linkage.tables.dyad import METRIC
from tmmcalc.linkage.tables.tasks.dyad import to_dyad
from tmmcalc.project import parse_spec

CASES = {each["id"]: each for each in json.loads((Path(__file__).parents[1] / "cases" / "kinematics.json").read_text())}
READY = (CONFIGS / "dyad.toml").read_text(encoding="utf-8")
RUNNER = CliRunner()


def told(text: str, folder: Path, code: int = 0) -> Any:
    """What ``tmmcalc dyad`` prints of a spec for programs; of a refusal its words."""
    file = folder / "dyad.toml"
    file.write_text(text, encoding="utf-8")
    done = RUNNER.invoke(app, ["dyad", str(file), "--no-store", "-q", "--format", "json"])
    if code:
        assert isinstance(done.exception, TmmError)
        assert done.exception.exit_code == code
        return str(done.exception)
    assert done.exit_code == 0, done.output
    return json.loads(done.stdout)


def pair(x: float, y: float) -> str:
    return f"[{x!r}, {y!r}]"


def port_lines(port: dict[str, float], guide: dict[str, Any] | None = None) -> str:
    lines = [
        f"{key} = {pair(port[names[0]], port[names[1]])}"
        for key, names in (("point", ("x", "y")), ("velocity", ("vx", "vy")), ("acceleration", ("ax", "ay")))
    ]
    if guide is not None:
        lines += [f'angle = "{guide["gamma_deg"]} deg"', f"omega = {guide['omega']}", f"eps = {guide['eps']}"]
    return "\n".join(lines)


def spec_of(kind: str, metric: str, first: str, second: str) -> str:
    return f'[dyad]\nkind = "{kind}"\n{metric}\n[dyad.first]\n{first}\n[dyad.second]\n{second}\n'


def point_keys(name: str) -> dict[str, str]:
    """Keys of the cases to those of the program."""
    units = {"": "m", "v": "m/s", "a": "m/s^2"}
    return {f"{order}{axis}": f"{order}{axis}_{name}[{unit}]" for order, unit in units.items() for axis in "xy"}


def slide_keys(name: str, joint: str) -> dict[str, str]:
    return {name: f"s_{joint}[m]", f"{name}_dot": f"v_{joint}[m/s]", f"{name}_ddot": f"a_{joint}[m/s^2]"}


def link_keys(suffix: str, link: str) -> dict[str, str]:
    units = {"phi": ("angle", "deg"), "omega": ("omega", "rad/s"), "eps": ("eps", "rad/s^2")}
    return {f"{name}{suffix}": f"{key}_{link}[{unit}]" for name, (key, unit) in units.items()}


def worked(name: str) -> tuple[str, dict[str, str]]:
    """The spec of a worked case, and the keys of its answers."""
    given = CASES[name]["inputs"]
    if name == "KIN-S12":
        metric = f"length_a = {given['l_a']}\nlength_b = {given['l_b']}\nvariant = {given['variant']}"
        return spec_of("RRR", metric, port_lines(given["P1"]), port_lines(given["P2"])), {
            **link_keys("_a", "a"),
            **link_keys("_b", "b"),
        }
    if name == "KIN-S14":
        metric = f"offset_a = {given['h']}\nvariant = {given['variant']}"
        return spec_of("RPR", metric, port_lines(given["P1"]), port_lines(given["P2"])), {
            **link_keys("", "b"),
            **slide_keys("s", "inner"),
        }
    if name == "KIN-S15":
        metric = f"offset_a = {given['h1']}\noffset_b = {given['h2']}"
        ports = [port_lines(given[key]["point"], given[key]) for key in ("guide1", "guide2")]
        return spec_of("PRP", metric, *ports), {**slide_keys("s1", "first"), **slide_keys("s2", "second")}
    guide = port_lines(given["guide"]["point"], given["guide"])
    if name == "KIN-S13":
        metric = f"length_a = {given['l']}\noffset_b = {given['h']}\nvariant = {given['variant']}"
        return spec_of("RRP", metric, port_lines(given["P1"]), guide), {
            **link_keys("", "a"),
            **slide_keys("s", "second"),
        }
    metric = f'turn = "{given["delta_deg"]} deg"\noffset_b = {given["h1"]}\noffset_a = {given["h2"]}'
    return spec_of("RPP", metric, port_lines(given["P1"]), guide), {
        **slide_keys("s1", "second"),
        **slide_keys("s2", "inner"),
    }


@pytest.mark.parametrize("name", [f"KIN-S{number}" for number in range(12, 17)])
def test_worked_cases_through_the_command_line(name: str, tmp_path: Path) -> None:
    text, keys = worked(name)
    found, expected, tolerance = told(text, tmp_path), CASES[name]["expected"], CASES[name]["tolerance"]["abs"]
    assert set(expected) - {"B"} == set(keys)
    for case, key in keys.items():
        value = math.radians(found[key]) if key.endswith("[deg]") else found[key]
        assert value == pytest.approx(expected[case], abs=tolerance), key
    for case, key in point_keys("inner").items() if "B" in expected else ():
        assert found[key] == pytest.approx(expected["B"][case], abs=tolerance), key


def test_the_ready_spec_is_the_worked_case(tmp_path: Path) -> None:
    found, other = told(READY, tmp_path), told(worked("KIN-S12")[0], tmp_path)
    assert {key: found[key] for key in other if "[" in key} == pytest.approx(
        {key: other[key] for key in other if "[" in key}, rel=1e-13
    )
    printed = RUNNER.invoke(app, ["dyad", str(CONFIGS / "dyad.toml"), "--no-store", "-q"]).stdout
    assert "omega = 0.4569589 rad/s" in printed
    assert "+1               51.2009" in printed  # the other assembly


def test_stored_results_come_back(tmp_path: Path) -> None:
    scene = tmmcalc.load_spec(CONFIGS / "dyad.toml")
    first, second = (tmmcalc.run(scene, out=tmp_path).results["dyad"] for _ in range(2))
    assert first == second
    assert isinstance(first, DyadState)


# Cut out of solved mechanisms: outer joints from the table of ``kinematics``, which has nothing of the stage.


def solved(name: str, *overrides: str) -> dict[str, Any]:
    done = RUNNER.invoke(
        app,
        ["kinematics", str(CONFIGS / f"{name}.toml"), "--no-store", "-q", "-f", "json"]
        + [word for each in overrides for word in ("--set", each)],
    )
    assert done.exit_code == 0, done.output
    columns: dict[str, Any] = json.loads(done.stdout)["columns"]
    return columns


def moving(table: dict[str, Any], name: str, k: int) -> str:
    return port_lines({key: table[column][k] for key, column in point_keys(name).items()})


def same_turning(
    found: dict[str, Any], link: str, table: dict[str, Any], number: int, k: int, off: float = 0.0
) -> None:
    apart = found[f"angle_{link}[deg]"] + off - table[f"angle_{number}[deg]"][k]
    assert (apart + 180) % 360 - 180 == pytest.approx(0, abs=1e-8)
    for own, column in (("omega", "rad/s"), ("eps", "rad/s^2")):
        assert found[f"{own}_{link}[{column}]"] == pytest.approx(table[f"{own}_{number}[{column}]"][k], abs=1e-9)


@pytest.mark.parametrize("k", [0, 5, 9])
def test_dyads_cut_out_of_a_mechanism(k: int, tmp_path: Path) -> None:
    table = solved("shaper")
    spec = tmmcalc.load_spec(CONFIGS / "shaper.toml").linkage
    points = {link.id: link.points for link in spec.links} | {0: spec.fixed}
    (x, y), (c, _) = points[0]["B"], points[3]["C"]
    slotted = spec_of("RPR", f"points_b = {{ C = [{c}, 0] }}", moving(table, "A", k), f"point = {pair(x, y)}")
    found = told(slotted, tmp_path)
    same_turning(found, "b", table, 3, k)
    for key, column in point_keys("C").items():
        assert found[column] == pytest.approx(table[column][k], abs=1e-9), key
    rod = math.hypot(*points[4]["D"])
    level = table["y_D[m]"][k]
    slider = spec_of("RRP", f"length_a = {rod}", moving(table, "C", k), f"point = [0, {level}]")
    found = told(slider, tmp_path)
    if abs(found["x_inner[m]"] - table["x_D[m]"][k]) > 1e-6:
        found = told(slider.replace("length_a", "variant = -1\nlength_a"), tmp_path)
    same_turning(found, "a", table, 4, k)
    assert found["x_inner[m]"] == pytest.approx(table["x_D[m]"][k], abs=1e-12)
    assert found["v_second[m/s]"] == pytest.approx(table["vx_D[m/s]"][k], abs=1e-9)
    assert found["a_second[m/s^2]"] == pytest.approx(table["ax_D[m/s^2]"][k], abs=1e-8)


# The truth: the closed loop of every kind solved to 50 digits, at three instants, whose differences are the rates.


def random_task(rng: np.random.Generator, kind: str) -> DyadTask:
    def vector(size: float = 1.0) -> tuple[float, float]:
        x, y = rng.normal(size=2) * size
        return float(x), float(y)

    def port() -> Port:
        angle, omega, eps = rng.normal(size=3) * (2.0, 1.0, 3.0)
        return Port(vector(), vector(), vector(3.0), float(angle), float(omega), float(eps))

    first, second = port(), port()
    reach = math.dist(first.point, second.point)
    a, b = (float(each) for each in rng.uniform(0.3, 1.5, size=2) * reach)
    h_a, h_b = (float(each) for each in rng.normal(size=2) * 0.2)
    marks = (LinkPoint("E", "a", *vector(0.4)), LinkPoint("F", "b", *vector(0.4)))
    turn, variant = float(rng.uniform(0.3, 2.8)), int(rng.choice([-1, 1]))
    return DyadTask(kind, first, second, a, b, h_a, h_b, turn, variant, marks)


def exactly(task: DyadTask, found: DyadState) -> dict[str, tuple[Any, Any, Any]]:
    """Unit vectors of the links, coordinates and points (value, first, second derivative) to some thirty digits."""
    h = mp.mpf(10) ** -16
    before, here, after = (placed(task, found, k * h) for k in (-1, 0, 1))
    return {
        name: (here[name], (after[name] - before[name]) / (2 * h), (after[name] - 2 * here[name] + before[name]) / h**2)
        for name in here
    }


def placed(task: DyadTask, found: DyadState, t: Any) -> dict[str, Any]:
    def at(port: Port) -> tuple[Any, Any]:
        r, v, a = (mp.mpc(*each) for each in (port.point, port.velocity, port.acceleration))
        turned = mp.mpf(port.angle) + port.omega * t + port.eps * t**2 / 2
        return r + v * t + a * t**2 / 2, mp.expj(turned)

    (p1, e1), (p2, e2) = at(task.first), at(task.second)
    kind, h_a, h_b, slides = task.kind, mp.mpc(0, task.offset_a), mp.mpc(0, task.offset_b), found.slides
    angle_a, angle_b = (link.angle for link in found.links)
    if kind == "RRR":
        q = closed(lambda x, y: p1 + task.length_a * mp.expj(x) - p2 - task.length_b * mp.expj(y), angle_a, angle_b)
        u, w, s = mp.expj(q[0]), mp.expj(q[1]), ()
        base, other, inner = p1, p2, p1 + task.length_a * u
    elif kind == "RRP":
        q = closed(lambda x, y: p1 + task.length_a * mp.expj(x) - p2 - (y + h_b) * e2, angle_a, slides[0].s)
        u, w, s = mp.expj(q[0]), e2, (q[1],)
        base, inner = p1, p1 + task.length_a * u
        other = inner
    elif kind == "RPR":
        q = closed(lambda x, y: p1 - p2 - (y + h_a) * mp.expj(x), angle_b, slides[0].s)
        u, w, s = mp.expj(q[0]), mp.expj(q[0]), (q[1],)
        base, other, inner = p1, p2, None
    elif kind == "PRP":
        q = closed(lambda x, y: p1 + (x + h_a) * e1 - p2 - (y + h_b) * e2, slides[0].s, slides[1].s)
        u, w, s, inner = e1, e2, tuple(q), p1 + (q[0] + h_a) * e1
        base = other = inner
    else:
        d = mp.expj(mp.mpf(task.turn))
        q = closed(lambda x, y: p1 - p2 - (y + h_b) * e2 - (x + h_a) * d * e2, slides[0].s, slides[1].s)
        u, w, s = d * e2, e2, tuple(q)
        base, other, inner = p1, p2 + q[1] * e2, None
    points = {} if inner is None else {"inner": inner}
    for mark, origin, axis in zip(task.points, (base, other), (u, w), strict=True):
        points[mark.name] = origin + mp.mpc(mark.x, mark.y) * axis
    return {"a": u, "b": w} | {each.joint: value for each, value in zip(slides, s, strict=True)} | points


def closed(gap: Any, x: float, y: float) -> tuple[Any, Any]:
    """The two unknowns for which a complex gap vanishes, by Newton's method with differences."""
    x, y, step = mp.mpf(x), mp.mpf(y), mp.mpf(10) ** -45
    for _ in range(6):
        z = gap(x, y)
        by_x, by_y = (gap(x + step, y) - z) / step, (gap(x, y + step) - z) / step
        determinant = mp.im(mp.conj(by_x) * by_y)
        x, y = x - mp.im(mp.conj(z) * by_y) / determinant, y - mp.im(mp.conj(by_x) * z) / determinant
    assert abs(gap(x, y)) < mp.mpf(10) ** -90
    return x, y


def told_of(found: DyadState) -> dict[str, tuple[complex, complex, complex]]:
    links = {
        each.link: (
            u := complex(math.cos(each.angle), math.sin(each.angle)),
            1j * each.omega * u,
            (1j * each.eps - each.omega**2) * u,
        )
        for each in found.links
    }
    slides = {each.joint: (complex(each.s), complex(each.v), complex(each.a)) for each in found.slides}
    points = {
        each.point: (complex(each.x, each.y), complex(each.vx, each.vy), complex(each.ax, each.ay))
        for each in found.points
    }
    return links | slides | points


def far(task: DyadTask, found: DyadState) -> list[float]:
    """True errors of positions, velocities and accelerations against the largest, of turning at the dyad's reach."""
    exact, have = exactly(task, found), told_of(found)
    ports = (task.first, task.second)
    lengths = [task.length_a, task.length_b, *(math.hypot(mark.x, mark.y) for mark in task.points)]
    reach = max(*(each or 0.0 for each in lengths), *(math.hypot(*port.point) for port in ports))
    sizes = (
        reach,
        max(math.hypot(*port.velocity) + abs(port.omega) * reach for port in ports),
        max(math.hypot(*port.acceleration) + (abs(port.eps) + port.omega**2) * reach for port in ports),
    )
    scale = {name: reach if name in ("a", "b") else 1.0 for name in exact}
    return [
        float(
            max(scale[name] * abs(have[name][k] - exact[name][k]) for name in exact)
            / max(sizes[k], *(scale[name] * abs(exact[name][k]) for name in exact))
        )
        for k in range(3)
    ]


def scenes(kind: str, count: int) -> Iterator[tuple[DyadState, list[float]]]:
    rng = np.random.default_rng(len(kind) + 7 * [*KINDS].index(kind))

    def scene() -> tuple[DyadState, list[float]]:
        task = random_task(rng, kind)
        found = solve_dyad_task(task)
        return found, far(task, found)

    yield from accepted(scene, count)


@pytest.mark.parametrize("kind", KINDS)
def test_the_motion_is_that_of_the_closed_loop(kind: str) -> None:
    with mp.workdps(100):
        for found, errors in scenes(kind, 8):
            k = 1 / found.regularity
            assert errors[0] < 1e-14 * k
            assert errors[1] < 1e-14 * k**2
            assert errors[2] < 1e-13 * k**3


@pytest.mark.slow
@pytest.mark.skipif(not WIDER, reason="no wider float here: the estimate has no reference")
def test_estimates_bound_the_errors() -> None:
    with mp.workdps(100):
        rows = [(found.error, errors) for kind in KINDS for found, errors in scenes(kind, 60)]
    for k, name in enumerate(("position", "velocity", "acceleration")):
        assert_bounds([(getattr(error, name), errors[k]) for error, errors in rows], name)


def near_dead_point(task: DyadTask, gap: float) -> DyadTask:
    """The same dyad, its metric as near to a dead point as the gap tells."""
    apart = complex(*task.first.point) - complex(*task.second.point)
    if task.kind == "RPR":
        return replace(task, offset_a=abs(apart) * (1 - gap))
    if task.kind == "RRP":
        across = (apart * complex(math.cos(task.second.angle), -math.sin(task.second.angle))).imag
        return replace(task, length_a=abs(task.offset_b - across) * (1 + gap))
    return replace(task, length_b=abs(abs(apart) - (task.length_a or 0.0)) * (1 + gap))


@pytest.mark.skipif(not WIDER, reason="no wider float here: the estimate has no reference")
@pytest.mark.parametrize("kind", ["RRR", "RRP", "RPR"])
def test_estimates_bound_the_errors_near_dead_points(kind: str) -> None:
    with mp.workdps(120):
        for gap in (1e-2, 1e-5, 1e-8):
            task = near_dead_point(random_task(np.random.default_rng(4), kind), gap)
            found = solve_dyad_task(task)
            errors = found.error.position, found.error.velocity, found.error.acceleration
            for told_error, true_error in zip(errors, far(task, found), strict=True):
                assert told_error >= true_error
                assert told_error < 30 * max(true_error, 2.0**-53)


@pytest.mark.parametrize("kind", KINDS)
def test_the_picture_has_the_vectors_of_all_points(kind: str) -> None:
    from tmmcalc.linkage.pictures.dyad import KINDS as PANELS
    from tmmcalc.linkage.pictures.dyad import dyad_drawing
    from tmmcalc.report.drawing.shapes import Area

    def drawn() -> tuple[DyadTask, DyadState]:
        task = random_task(np.random.default_rng(seeds.pop()), kind)
        return task, solve_dyad_task(task)

    seeds = [*range(20)]
    ((task, found),) = accepted(drawn, 1)
    outer = [[complex(*each) for each in (p.point, p.velocity, p.acceleration)] for p in (task.first, task.second)]
    told = outer + [
        [complex(each.x, each.y), complex(each.vx, each.vy), complex(each.ax, each.ay)] for each in found.points
    ]
    drawing = dyad_drawing(task, found)
    for order, board in enumerate(drawing.fields, 1):
        heads = [shape for shape in drawing.shapes if isinstance(shape, Area)]
        tips = [board.data(complex(each.points[0])) for each in heads if each.fill == PANELS[order - 1][1].colour]
        assert len(tips) == len(told)
        scales = [(tip - point[0]) / point[order] for tip, point in zip(tips, told, strict=True)]
        assert scales == pytest.approx([scales[0].real] * len(scales), rel=1e-9)


# Refusals.


def test_every_kind_has_its_metric() -> None:
    assert [*METRIC] == [*KINDS]


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('["900 mm", "400 mm"]', '["1.6 m", "400 mm"]', "1513.275 mm apart, more than l_a + l_b = 1200 mm"),
        ('["900 mm", "400 mm"]', '["1.3 m", "200 mm"]', "dead point: both links stand in line"),
    ],
)
def test_no_position_and_dead_points_have_their_own_exit(old: str, new: str, words: str, tmp_path: Path) -> None:
    assert words in told(READY.replace(old, new), tmp_path, code=3)


def test_what_cannot_be_computed_is_refused() -> None:
    still = Port((0.0, 0.0))
    with pytest.raises(AssemblyError, match="nearer to each other than the offset 200 mm"):
        solve_dyad_task(DyadTask("RPR", Port((0.1, 0.0)), still, offset_a=0.2))
    with pytest.raises(SingularityError, match="two guides are parallel"):
        solve_dyad_task(DyadTask("PRP", Port((0.0, 0.1)), still))
    with pytest.raises(SingularityError, match="two lines of the slider are parallel"):
        solve_dyad_task(DyadTask("RPP", Port((0.0, 0.1)), still, turn=0.0))
    with pytest.raises(AccuracyError, match="sizes too different"):
        solve_dyad_task(DyadTask("RRR", Port((1.0, 0.0)), still, 1e200, 1e200))
    with pytest.raises(AccuracyError, match="the range of double precision"):
        solve_dyad_task(DyadTask("RRR", Port((1.0, 0.0), (1e200, 0.0)), still, 1.0, 1.0))


def test_a_weak_transmission_is_told() -> None:
    low = DyadTask("RRR", Port((0.0, 0.0)), Port((1.9999, 0.0)), 1.0, 1.0)
    nearly, weak = solve_dyad_task(low).notes
    assert nearly.startswith("warning: dyad RRR: nearly singular: errors and velocities are amplified 50")
    assert weak.startswith("warning: dyad RRR: transmission angle 1.146 deg, below 20 deg")


def test_several_positions_name_the_one_that_fails() -> None:
    x, still = np.array([1.0, 1.5, 2.5]) + 0j, np.zeros(3, complex)
    ports = tmmcalc.Point(np.zeros(3, complex), still, still), tmmcalc.Point(x, still, still)
    with pytest.raises(AssemblyError, match="at position 2: the outer pins are 2500 mm apart"):
        tmmcalc.solve_dyad(tmmcalc.RRR(1.0, 1.0), *ports)


LINES = 'length_a = "700 mm"\nlength_b = "500 mm"'
PORT = 'point = ["900 mm", "400 mm"]'
FAULTS = [
    (
        spec_of("PRR", LINES, PORT, PORT),
        "dyad.kind",
        "'PRR' is the mirror form of RRP",
        'write kind = "RRP" and exchange the links: the prismatic outer joint is that of b',
    ),
    (
        spec_of("RRX", LINES, PORT, PORT),
        "dyad.kind",
        "'RRX' is no kind of dyad",
        'did you mean "RRR"? there are: RRR, RRP, RPR, PRP, RPP',
    ),
    (
        spec_of("RRP", LINES, PORT, PORT),
        "dyad.length_b",
        "length_b is a key of RRR; RRP has length_a, offset_b, variant",
        "remove it, or change the kind",
    ),
    (
        spec_of("RRR", 'length_a = "700 mm"', PORT, PORT),
        "dyad",
        "missing key: length_b: RRR has this length",
        'add length_b = "700 mm"',
    ),
    (
        spec_of("RRR", LINES + "\nvariant = 2", PORT, PORT),
        "dyad.variant",
        "2 is not allowed here; the value is 1 or -1",
        "write 1 or -1",
    ),
    (
        spec_of("RRR", LINES, PORT, PORT + "\nomega = 2"),
        "dyad.second.omega",
        "omega of a pin: the outer joint of b in RRR is revolute, its state is that of a point",
        "remove it, or change the kind",
    ),
    (
        spec_of("RPP", "", PORT, PORT + "\nomega = 1500"),
        "dyad.second.omega",
        "1500 without a unit is in rad/s, which is 14324 rpm",
        'write "1500 rpm" or "1500 rad/s"',
    ),
    (
        spec_of("RRR", LINES, PORT + '\nvelocity = "0.3 m/s"', PORT),
        "dyad.first.velocity",
        "'0.3 m/s' is not a velocity along x and y",
        'write velocity = ["0.3 m/s", "-0.4 m/s"]',
    ),
    (
        spec_of("RRR", LINES + "\npoints_a = { inner = [0, 1] }", PORT, PORT),
        "dyad.points_a.inner",
        "'inner' is the name of a joint in the results",
        "choose another name",
    ),
    (
        spec_of("RRR", LINES + "\npoints_a = { E = [0, 1] }\npoints_b = { E = [0, 1] }", PORT, PORT),
        "dyad.points_b.E",
        "'E' is already a point of a",
        "choose another name",
    ),
    (
        spec_of("RRR", LINES, "velocity = [1, 2]", PORT),
        "dyad.first.point",
        "missing key: an outer joint has its place",
        'add point = ["100 mm", "200 mm"]',
    ),
]


@pytest.mark.parametrize(("text", "path", "message", "remedy"), FAULTS)
def test_every_fault_has_one_message(text: str, path: str, message: str, remedy: str, faults_of: Faults) -> None:
    found = faults_of(text)
    assert [(each.path, each.message, each.remedy) for each in found] == [(path, message, remedy)]
    assert found[0].line


@pytest.mark.parametrize("key", ["kind", "length_a", "offset_a", "turn", "variant", "first", "second", "points_a"])
def test_no_value_breaks_the_checks(key: str) -> None:
    for value in HOSTILE:
        check_lines(f"[dyad]\n{key} = {value}\n")


def test_a_spec_without_a_dyad_has_none_to_solve(shaper: str) -> None:
    with pytest.raises(UsageError, match=r"no \[dyad\]"):
        to_dyad(parse_spec(shaper))
