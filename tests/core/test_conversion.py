"""Results as plain values and back; what is not a number is refused there, before any table sees it."""

from __future__ import annotations

import math
import pickle

import numpy as np
import pytest

import tmmcalc
from tmmcalc import NoSolutionError, UsageError
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.notes import Note, Phrase
from tmmcalc.core.records import record
from tmmcalc.project import parse_spec
from tmmcalc.project.templates import folder

DIAGRAM = """
[torque]
speed = 20
formula = "{size}*sin(theta)"
inertia = {inertia}
[flywheel]
delta = 1e-2
"""


@record
class Part:
    place: float
    force: complex


@record
class Found:
    labels: tuple[str, ...]
    drive: np.ndarray  # (n,)
    parts: tuple[Part, ...]
    counters: dict[str, int]


def found(drive: float = 2.0, place: float = 3.0, force: complex = 4 + 5j) -> Found:
    return Found(("0", "1"), np.array([1.0, drive]), (Part(0.5, 0j), Part(place, force)), {"rows": 2})


def test_there_and_back() -> None:
    back = from_record(Found, to_record(found()))
    assert (back.labels, back.parts, back.counters) == (found().labels, found().parts, {"rows": 2})
    assert back.drive.tolist() == [1.0, 2.0]


@record
class Told:
    said: tuple[Note | str, ...]
    reason: Phrase | str


def test_notes_and_phrases_come_back_with_what_they_hold() -> None:
    long = Note("warning", "12 mm is long", "link 2", 0.012, 0.01, "m", "l")
    outside = Phrase("{x} lies outside: {lines}", x="0.5", lines=["tip", "root"])
    told = Told((long, "note: plain"), outside)
    for copy in (from_record(Told, to_record(told)), pickle.loads(pickle.dumps(told))):
        assert copy.reason == "0.5 lies outside: tip, root"
        assert isinstance(copy.reason, Phrase)
        assert copy.reason.stored() == outside.stored()
        assert isinstance(copy.said[0], Note)
        assert copy.said[0].stored() == long.stored()
    assert from_record(Told, to_record(Told((), "plain"))) == Told((), "plain")


@record
class Asked:
    shifts: tuple[float | None, float | None]
    inner: Part | None


def test_what_is_not_known_in_a_pair_comes_back_as_that() -> None:
    record_of = to_record(Asked((None, 0.5), None))
    assert from_record(Asked, record_of) == Asked((None, 0.5), None)


@pytest.mark.parametrize(
    ("result", "words"),
    [
        (found(drive=math.inf), "drive is inf at position 1"),
        (found(place=math.nan), r"parts.1.place is nan"),
        (found(force=complex(0, -math.inf)), r"parts.1.force.1 is -inf"),
    ],
)
def test_what_is_not_a_number_is_refused_with_its_place(result: Found, words: str) -> None:
    with pytest.raises(NoSolutionError, match=words) as refused:
        to_record(result)
    assert refused.value.where == "found"


def test_a_moment_whose_square_is_no_number() -> None:
    with pytest.raises(UsageError, match=r"a moment of 1e\+300 N\*m at 89.8"):
        tmmcalc.run(parse_spec(DIAGRAM.format(size="1e300", inertia=1)))


def test_a_moment_below_the_bound_is_in_proportion() -> None:
    small, large = (
        tmmcalc.run(parse_spec(DIAGRAM.format(size=size, inertia=0))).results["flywheel"] for size in ("1", "1e99")
    )
    assert large.inertia == pytest.approx(1e99 * small.inertia, rel=1e-12)


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_forces_beyond_all_numbers_are_no_result() -> None:
    smooth = [f"mechanism.joints[name={joint}].friction=0" for joint in ("A", "B", "B0")]
    huge = ["mechanism.links[id=2].mass=1e200", "mechanism.input.speed=1e60"]
    press = tmmcalc.load_spec(folder() / "press.toml", [*huge, *smooth])
    with pytest.raises(NoSolutionError, match=r"forces: .* go beyond what can be computed"):
        tmmcalc.run(press, target="forces")
