"""What the task gives of a linkage: every number of its spec, as it can be measured on the linkage, and no more."""

from __future__ import annotations

import cmath
import math
import re
import tomllib
from functools import cache
from pathlib import Path

import pytest
from ready import LINKAGES
from sparing import sparing

from note.given import ambiguous, data_of, untold
from note.scenes import CONFIGS, blocks, solved
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.notes.group import plain_name
from tmmcalc.linkage.pins import find_pins
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.pipeline.chapters import chapters_of, task_of
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.runner import run
from tmmcalc.project import Spec, load_spec
from tmmcalc.project.loader import Variants, read_text
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.manuscript import Datum, Figure, Line
from tmmcalc.rooms import CHAPTERS

MOTION = ("structure", "kinematics")
MEASURED = re.compile(r"distance between points (\w+) and (\w+)")
TURNED = re.compile(
    r"angle of point (\w+) on link (\d+) about (\w+), from (?:line (\w)(\w)|the guide of link (\d+).*)$"
)
SPRUNG = Path(__file__).parents[1] / "design" / "sprung.toml"


def data(done: RunResult) -> list[Datum]:
    return data_of(task_of(done.spec, done.results))


@cache
def given(name: str, *changed: str, only: tuple[str, ...] = MOTION) -> dict[str, Datum]:
    """The data of a ready spec with these keys changed, by what they are."""
    return {each.what: each for each in data(solved(name, only, changed))}


def with_load(tmp_path: Path, law: str, base: str = "scotch-yoke") -> dict[str, Datum]:
    """The data of a ready spec with one load more."""
    spec = tmp_path / "loaded.toml"
    spec.write_text((CONFIGS / f"{base}.toml").read_text(encoding="utf-8") + "\n[[loads]]\n" + law, encoding="utf-8")
    return {each.what: each for each in data(run(load_spec(spec), target="forces"))}


AT_D = 'name = "Q3"\nlink = 3\npoint = "D"\n'
TURNING = 'name = "M1"\nlink = 1\n'


def test_a_resistance_has_its_coefficient_and_its_law(tmp_path: Path) -> None:
    for law, unit, shown in (("viscous", "N*s/m", "$-c_{Q,3}*v$"), ("quadratic", "N*s^2/m^2", "$-c_{Q,3}*v*abs(v)$")):
        found = with_load(tmp_path, f'{AT_D}{law} = "150 {unit}"\n')
        coefficient = found["coefficient of load “Q3”"]
        assert (coefficient.keys, coefficient.values, coefficient.unit) == (("c_{Q,3}",), (150.0,), unit)
        assert found["given load “Q3”; $v$ – velocity of its point along its direction"].text == shown
    found = with_load(tmp_path, f'{TURNING}viscous = "0.5 N*m*s/rad"\n')
    assert found["coefficient of load “M1”"].unit == "N*m*s/rad"
    assert found["given load “M1”; $omega$ – angular velocity of its link"].text == "$-c_{M,1}*omega$"


def test_a_resistance_between_links_is_against_their_relative_velocity(tmp_path: Path) -> None:
    found = with_load(tmp_path, f'{AT_D}viscous = "150 N*s/m"\nagainst = 1\n')
    assert "given load “Q3”; $v$ – velocity of its point along its direction, relative to link 1" in found
    found = with_load(tmp_path, f'{TURNING}quadratic = "0.5 N*m*s^2/rad^2"\nagainst = 2\n')
    assert "given load “M1”; $omega$ – angular velocity of its link relative to link 2" in found


NAMES = (None, None, None, "Q_2", "gas", "Q_gas", "M", "spring")  # on link 2, off its pins


def test_loads_and_springs_have_points_and_letters_of_their_own(tmp_path: Path) -> None:
    """Names that differ by a prime or a line alone, springs that are called as loads; letters are those of formulas."""
    spec = tmp_path / "loaded.toml"
    loads = [
        f'[[loads]]\n{f"name = {name!r}" if name else ""}\nlink = 2\npoint = ["{20 + k} mm", "{31 + k} mm"]\n'
        f'viscous = "{k + 1} N*s/m"\nfactor = 1.5\n'
        for k, name in enumerate(NAMES)
    ]
    sprung = SPRUNG.read_text(encoding="utf-8").replace('name = "pull"', 'name = "Q_2"')
    spec.write_text(f"{sprung}\n{''.join(loads)}", encoding="utf-8")
    done = run(load_spec(spec), target="forces")
    found = data(done)
    assert ambiguous(found) == {}
    keys = {key for each in found if each.what.startswith("given load") for key in each.keys}
    assert len(keys) == len(NAMES)
    points = [each.text for each in found if each.what.startswith("where load")]
    assert len({*points}) == len(points)
    chapters = chapters_of({"forces": CHAPTERS["forces"]}, done.spec, done.results)
    lines = [line for line in blocks([*chapters]) if isinstance(line, Line)]
    assert {*map(canonical, keys)} <= {key for line in lines for key in line.places[0].lexicon}


def test_a_polynomial_has_its_coefficients(tmp_path: Path) -> None:
    law = f"{TURNING}polynomial = {{ moment = [0, -180, 68.7549354157] }}\n"
    said = "given load “M1”; $theta$ – angle of the crank from {}, rad"
    window = 'between = ["130 deg", "280 deg"]\n'
    for more, since in (("", "the first position"), (window, "its beginning")):
        assert with_load(tmp_path, law + more)[said.format(since)].text == "$- 180*theta + 68.75493542*theta**2$ N·m"
    lifted = 'name = "Q4"\nlink = 4\npoint = "P"\npolynomial = { force = [5, 2] }\n'
    found = with_load(tmp_path, lifted, "hydraulic-lift")
    assert "given load “Q4”; $theta$ – travel of the drive from the first position, m" in found


def test_a_table_of_the_angle_has_its_points_its_curve_and_its_period(tmp_path: Path) -> None:
    law = (
        'table = { x = ["0 deg", "130 deg", "720 deg"], force = ["40 N", "1 kN", "40 N"], '
        'interpolation = "pchip", period = "720 deg" }\n'
    )
    found = with_load(tmp_path, AT_D + law)
    points = found["points of load “Q3”: angle of the crank from the first position"]
    assert (points.keys, points.unit) == (("phi",), "deg")
    assert points.values == pytest.approx((0, 130, 720))
    assert found["values of load “Q3” there"].values == (40.0, 1000.0, 40.0)
    assert "monotone" in found["load “Q3” between its points"].text
    back = found["angle of the crank after which the values of load “Q3” come back"]
    assert back.values == pytest.approx((720,))


@pytest.mark.parametrize(
    ("of", "what", "values", "unit"),
    [
        ("position", "points of load “Q3”: positions", (0, 1, 2, 3), ""),
        ("displacement", "coordinate of link 3 along its guide, from its lesser extreme", (0, 0.02, 0.1, 0.16), "m"),
        ("stroke", "coordinate of link 3 along its guide, from its lesser extreme, in parts", (0, 1 / 3, 2 / 3, 1), ""),
    ],
)
def test_a_table_says_what_its_points_are(
    tmp_path: Path, of: str, what: str, values: tuple[float, ...], unit: str
) -> None:
    """Those that a spec leaves to the program are told as well: positions from 0 on, equal parts of the stroke."""
    x = 'x = [0, "20 mm", "100 mm", "160 mm"], ' if of == "displacement" else ""
    found = with_load(tmp_path, f'{AT_D}table = {{ of = "{of}", {x}force = [1, 2, 3, 4] }}\n')
    (points,) = (each for said, each in found.items() if what in said)
    assert points.values == pytest.approx(values)
    assert points.unit == unit
    assert found["load “Q3” between its points"].text == "straight lines"


def test_long_lists_stand_part_by_part() -> None:
    """The 145 points of the engine, each once, the values under their angles; in every cell at most twelve."""
    rows = (CONFIGS / "four-stroke-angles.csv").read_text(encoding="utf-8").split()[1:]
    wanted = [tuple(map(float, row.split(","))) for row in rows]
    found = list(given("four-stroke-angles", only=("forces",)).values())
    angles = [each for each in found if each.what.startswith("points of load “gas”")]
    values = [each for each in found if each.what.startswith("values of load “gas”")]
    assert max(len(each.values) for each in angles) <= 12
    pairs = [
        pair for one, other in zip(angles, values, strict=True) for pair in zip(one.values, other.values, strict=True)
    ]
    assert pairs == [pytest.approx(pair) for pair in wanted]


def test_an_indicator_diagram_is_told_stroke_by_stroke() -> None:
    found = given("four-stroke-engine", only=("forces",))
    load = tomllib.loads((CONFIGS / "four-stroke-engine.toml").read_text(encoding="utf-8"))["loads"][0]["indicator"]
    assert found["diameter of the piston, load “gas”"].values == (0.095,)
    assert found["absolute pressure on the other side of the piston, load “gas”"].values == pytest.approx((0.1,))
    for number, stroke in enumerate(load["strokes"], 1):
        own = [each for said, each in found.items() if said.startswith(f"load “gas”, stroke {number}: ")]
        x = [value for each in own if each.unit == "" for value in each.values]
        p = [value for each in own if each.unit == "MPa" for value in each.values]
        assert x == pytest.approx(stroke["x"])
        assert p == pytest.approx([float(each.split()[0]) for each in stroke["p"]])
    assert found["what load “gas” does"].text == "drives the mechanism"


def test_an_indicator_diagram_may_have_an_area_and_a_delay() -> None:
    for delay in ("20", "20.12345"):
        found = given("four-stroke-engine", f'loads[0].indicator.delay="{delay} deg"', only=("forces",))
        assert f"after ${delay}$° from the first position" in found["first stroke of load “gas”"].text


def test_windows_are_told(tmp_path: Path) -> None:
    found = given("piston-pump", only=("forces",))
    assert found["where load “delivery” acts"].text == "on the working stroke"
    assert found["where load “suction” acts"].text == "on the idle stroke"
    assert found["coordinate of point B: its working stroke"].text == "that on which this coordinate grows"
    found = with_load(tmp_path, f"{AT_D}force = 5\npositions = [2, 12]\n")
    assert found["where load “Q3” acts"].text == "from position 2 to position 12"
    found = with_load(tmp_path, f'{AT_D}force = 5\nbetween = ["400 deg", "500 deg"]\nperiod = "720 deg"\n')
    assert found["angle of the crank after which load “Q3” comes back"].values == pytest.approx((720,))
    lifted = 'name = "Q4"\nlink = 4\npoint = "P"\nforce = 5\nbetween = ["100 mm", "300 mm"]\n'
    found = with_load(tmp_path, lifted, "hydraulic-lift")
    window = found["where load “Q4” begins and ends, by the travel of the drive from the first position"]
    assert (window.values, window.unit) == ((0.1, 0.3), "m")


def test_springs_have_their_ends_and_numbers() -> None:
    found = {each.what: each for each in data(run(load_spec(SPRUNG), target="forces"))}
    assert found["coordinates of point pull1"].values == (0.4, 0.5)
    assert found["ends of spring “pull”"].text == "link 0, point pull1; link 2, point B"
    assert found["stiffness of spring “pull”"] == Datum("stiffness of spring “pull”", ("k_{s,pull}",), (800.0,), "N/m")
    assert found["length of spring “pull” without load"].values == (0.15,)
    assert found["damping coefficient of spring “pull”"].values == (12.0,)
    assert found["stiffness of spring “twist”"].unit == "N*m/rad"
    free = found["angle of link 3 less that of link 0, at which spring “twist” has no load"]
    assert free.values == pytest.approx((40,))


def test_the_drive_through_a_gear_is_told_but_what_is_told_of_its_open_pair() -> None:
    found = given("piston-pump", only=("forces",))
    assert found["operating pitch radius of the wheel on the crank"].values == (0.24,)
    assert found["operating pressure angle"].values == pytest.approx((20,))
    beta = "direction from the pivot of the crank to the centre of the pinion, from axis $x$"
    assert found[beta].values == pytest.approx((-90,))
    of_pair = given("geared-press", only=("forces",))
    assert of_pair[beta].values == pytest.approx((180,))
    assert "operating pressure angle" not in of_pair
    assert of_pair["mesh that drives the crank"].text == "that of the open pair 18/60"


def test_a_driven_slider_has_its_speed_its_travel_and_its_beginning() -> None:
    found = given("hydraulic-lift")
    values = {key: each.values for each in found.values() for key in each.keys}
    assert values["v_{10}"] == (0.02,)
    assert values["Deltas_n"] == (0.65,)
    assert values["s_0"] == (0.0,)
    assert values["n"] == (13.0,)
    assert found["sense in which the drive moves"].text == "its coordinate grows"
    assert found["coordinate of link 1 along its guide"].text == "from point A0 to point A"


def test_an_unsteady_motion_has_its_ends_and_limits() -> None:
    found = given("tipper", only=("unsteady", "kinematics"))
    assert found["angle of link 1, at the end of the unsteady motion"].values == pytest.approx((45,))
    assert found["allowed speed of the input"].values == (0.08,)
    assert found["allowed acceleration of the input"].values == (0.04,)
    assert found["line of link 1 that has its angle, from line OB"].values == pytest.approx(
        (-math.degrees(math.atan2(0.25, 2.8)),)
    )
    timed = given("crane-luffing", only=("unsteady", "kinematics"))
    assert timed["time of the whole motion"].values == (12.0,)


def test_a_guide_on_a_moving_link_is_told_by_its_pins() -> None:
    assert given("shaper")["guide of link 2 on link 3"].text == "along line BC"
    slotted = given("slotter")
    assert slotted["guide of link 2 on link 3"].text == "through point B"
    turned = given("slotter", 'mechanism.joints[2].guide.angle="10 deg"')
    (angle,) = (each for said, each in turned.items() if said.startswith("angle of point D on link 3 about B"))
    assert angle.values == pytest.approx((20,))
    aside = given("slotter", "mechanism.joints[2].guide.through=[0.0, 0.015]")
    offset = aside["guide of link 2 on link 3: its distance from point B, positive to the left"]
    assert (offset.keys, offset.values) == (("h_3",), pytest.approx((0.015,)))


def test_guides_that_meet_on_a_link_have_their_angle() -> None:
    found = given("trammel")
    angle = found["guide of link 2 on link 3: angle from the guide of link 3"]
    assert (angle.keys, angle.values) == (("delta_3",), pytest.approx((90,)))
    assert found["guide of link 6 on link 3"].text == "along the guide of link 2 on link 3"
    assert found["coordinate of point B “By”: its direction from axis $x$"].values == pytest.approx((90,))


def test_a_wanted_path_has_its_points() -> None:
    found = given("best-straight-line")
    ordinates = found["wanted path “P” of point P: ordinates"]
    assert ordinates.values == pytest.approx([0.02, 0.025, 0.03, 0.035, 0.04, 0.045])
    assert found["distance between points A and P"].values == pytest.approx((math.hypot(0.0564, 0.0021),))


@sparing("name", LINKAGES, every=9, first=2)
def test_distances_and_angles_are_those_of_the_linkage_in_a_position(name: str) -> None:
    """Measured in the plane, between the places that the points have there."""
    done = solved(name, MOTION)
    if done.spec.synthesis is not None:
        return
    found = data(done)
    result = done.results["kinematics"]
    mechanism = to_linkage(done.spec.linkage)
    configuration = chain_of(mechanism, result).evaluate(result.x[[1]])
    places = {
        (plain_name(pin.name), link): complex(configuration.motions[link].point(at).r.ravel()[0])
        for pin in find_pins(mechanism)
        for link, at in pin.at.items()
    }
    spots = {point: at for (point, _), at in places.items()}
    guides = {
        joint.links[0]: configuration.motions[joint.links[1]].u.ravel()[0] * joint.directions[1]
        for joint in mechanism.joints
        if joint.kind == "prismatic"
    }
    measured = 0
    for each in found:
        if (ends := MEASURED.match(each.what)) and {*ends.groups()} <= {*spots}:
            assert each.values[0] == pytest.approx(abs(spots[ends[2]] - spots[ends[1]]), rel=1e-9)
            measured += 1
        if turned := TURNED.match(each.what):
            point, link, pivot, first, second, guide = turned.groups()
            line = guides[int(guide)] if guide else spots[second] - spots[first]
            way = (places[point, int(link)] - spots[pivot]) / line
            assert math.remainder(each.values[0] - math.degrees(cmath.phase(way)), 360) == pytest.approx(0, abs=1e-6)
            measured += 1
    assert measured


@pytest.mark.parametrize("name", ["synth-crank-rocker", "synth-slotted-link"])
def test_of_a_linkage_that_is_sought_the_task_does_not_tell_what_is_found(name: str) -> None:
    done = solved(name, ("synthesis", *MOTION))
    blocks = task_of(done.spec, done.results)
    assert not [block for block in blocks if isinstance(block, Figure)]
    keys = {key for each in data(done) for key in each.keys}
    assert keys <= {"n"}
    assert data(done)


@sparing("name", LINKAGES, every=9, first=2)
def test_a_letter_stands_for_one_thing(name: str) -> None:
    """Lists in parts have one letter, and what is counted along the motion."""
    assert ambiguous(data(solved(name, ("forces",)))) == {}


UNSEEN = {  # which assembly is meant shows the scheme; axes of blocks of which nothing is asked are nobody's
    "scotch-yoke": (r"mechanism\.links\[1\]\.points\.A\[\d\]", r"mechanism\.joints\[2\]\.slider\.angle"),
    "hydraulic-lift": (r"mechanism\.assembly\..+",),
    "slotter": (
        r"mechanism\.assembly\..+",
        r"mechanism\.gravity",
        r"mechanism\.links\[1\]\.points\.A\[0\]",
        r"mechanism\.links\[4\]\.points\.E\[0\]",
    ),
    "tipper": (r"mechanism\.gravity", r"mechanism\.assembly\..+", r"mechanism\.links\[[12]\]\.points\.[AB]\[\d\]"),
    "four-stroke-engine": (),
}
FIXED = (  # numbers of links, which make another linkage; ends of the strokes of an indicator diagram
    r"mechanism\.links\[\d\]\.id|mechanism\.joints\[\d\]\.links\[\d\]|mechanism\.outputs\[0\]\.link|unsteady\.output"
    r"|loads\[0\]\.indicator\.strokes\[\d\]\.x\[(0|2|11|12)\]"
)


def joined(spec: Spec) -> list[tuple[int, int]]:
    """The links of every joint."""
    return [joint.links for joint in to_linkage(spec.linkage).joints]


@sparing("name", UNSEEN, every=4)
def test_every_number_of_a_spec_changes_its_task(name: str) -> None:
    """One number at a time, the results left as they were, or found anew where only they tell it."""
    file = CONFIGS / f"{name}.toml"
    words = read_text(file)
    variants = Variants(words, str(file), file.parent)
    base = run(variants.spec())
    first = data(base)

    def told(spec: Spec) -> list[Datum]:
        if joined(spec) == joined(base.spec) and (found := data_of(task_of(spec, base.results))) != first:
            return found
        return data(run(spec))

    found = untold(words, variants, first, told)
    assert [path for path in found.refused if not re.fullmatch(FIXED, path)] == []
    unseen = {path: [known for known in UNSEEN[name] if re.fullmatch(known, path)] for path in found.same}
    assert [path for path, known in unseen.items() if not known] == []
    assert {known for each in unseen.values() for known in each} == {*UNSEEN[name]}
