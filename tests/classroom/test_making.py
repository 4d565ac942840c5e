"""Classes made in their folders: what every variant keeps, who has which, what stays when more are drawn."""

from __future__ import annotations

import csv
import itertools
import math
import re
import shutil
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

from tmmcalc.batch.table import row_of
from tmmcalc.classroom import choosing, judging
from tmmcalc.classroom.choosing import Chooser, Sought
from tmmcalc.classroom.clashing import clashes_of
from tmmcalc.classroom.document import class_document
from tmmcalc.classroom.draws import Candidate, candidate
from tmmcalc.classroom.items import items_of
from tmmcalc.classroom.judging import Judge
from tmmcalc.classroom.keying import clashes, key_of, mistakes_of
from tmmcalc.classroom.making import Made, make_class
from tmmcalc.classroom.state import read_class
from tmmcalc.core.errors import NoSolutionError, SpecError, UsageError
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec

CONFIGS = Path(__file__).parents[2] / "configs"
SHAPER = CONFIGS / "assignment-shaper.toml"
PRESS = CONFIGS / "assignment-course-project.toml"


def contents(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def written(tmp_path: Path, *changes: tuple[str, str], more: str = "", of: Path = SHAPER) -> Path:
    """The shaper's assignment in a folder of its own, with some of its text changed."""
    text = of.read_text(encoding="utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    file = tmp_path / "assignment.toml"
    file.write_text(f"{text}\n{more}", encoding="utf-8")
    return file


@pytest.fixture(scope="module")
def twelve(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Made]:
    folder = tmp_path_factory.mktemp("twelve") / "class"
    return folder, make_class(SHAPER, folder, 12, 7, jobs=1)


def test_every_variant_is_an_ordinary_spec_that_keeps_all_demands(twelve: tuple[Path, Made]) -> None:
    """Solved from its file, by the stages alone: constraints by their margin, turns, no warnings of its own."""
    folder, _ = twelve
    own = _warnings(run(load_spec(SHAPER)))
    files = sorted((folder / "variants").iterdir())
    assert [file.name for file in files] == [f"{number:02d}.toml" for number in range(1, 13)]
    for file in files:
        spec = load_spec(file)
        assert spec.class_ is not None
        assert spec.class_.drawn == []
        assert len(spec.class_.asked) == 8
        found = run(spec)
        assert not found.failures
        kinematics = found.results["kinematics"]
        assert kinematics.turns
        transmission = math.degrees(kinematics.qualities[1].transmission)
        assert transmission >= 80 * 1.02 * (1 - 1e-9)
        assert found.results["feasibility"].feasible
        assert {*_warnings(found)} <= {*own}


def _warnings(found: Any) -> list[str]:
    return judging._warnings(found)


def test_the_spec_of_a_variant_is_the_text_of_the_assignment_with_its_numbers(twelve: tuple[Path, Made]) -> None:
    folder, made = twelve
    before = SHAPER.read_text(encoding="utf-8").partition("\n[class]")[0].rstrip().splitlines()
    own = made.own.variants[0]
    head, _, text = (folder / "variants" / "01.toml").read_text(encoding="utf-8").partition("\n")
    assert head == "# Variant 1"
    after = re.split(r"\n\[+class", text)[0].rstrip().splitlines()
    differing = [(one, other) for one, other in zip(before, after, strict=True) if one != other]
    assert 1 <= len(differing) <= len(own.assignments)
    for one, other in differing:
        assert one.partition("#")[2].strip() == other.partition("#")[2].strip()
    assert "class.drawn" not in text


def test_variants_are_apart_and_their_results_within_the_spread(twelve: tuple[Path, Made]) -> None:
    """By the table of the class, and by the results of the assignment, with plain arithmetic."""
    folder, made = twelve
    with (folder / "class.csv").open(encoding="utf-8", newline="") as file:
        rows = [*csv.reader(file)]
    assert rows[0] == [
        "number",
        "student",
        "mechanism.links[id=1].points.A[0][mm]",
        "mechanism.fixed.O[1][mm]",
        "mechanism.links[id=3].points.C[0][mm]",
        "mechanism.input.speed[rpm]",
        "mechanism.links[id=5].mass[kg]",
        "loads[name=Q5].force[N]",
    ]
    values = [[float(each) for each in row[2:]] for row in rows[1:]]
    spans = [80, 440, 100, 25, 60, 4000]
    apart = [
        sum(abs(a - b) / span for a, b, span in zip(one, other, spans, strict=True)) / len(spans)
        for one, other in itertools.combinations(values, 2)
    ]
    assert min(apart) >= 0.05
    assert made.least == pytest.approx(min(apart), rel=1e-12)
    found = run(load_spec(SHAPER)).results["kinematics"]
    stroke = found.summaries[0].stroke
    for each in made.fresh:
        assert stroke / math.sqrt(10) <= each.values[0] <= stroke * math.sqrt(10)


def test_the_table_makes_the_variants_too(twelve: tuple[Path, Made]) -> None:
    """`--set @class.csv:07` gives the numbers of the spec of the seventh."""
    folder, made = twelve
    overrides = row_of(folder / "class.csv", "07")
    assert len(overrides) == len(made.own.variants[6].assignments)
    one = load_spec(SHAPER, overrides).model_copy(update={"class_": None})
    assert one.linkage == load_spec(folder / "variants" / "07.toml").linkage


@pytest.mark.slow
def test_processes_change_nothing(twelve: tuple[Path, Made], tmp_path: Path) -> None:
    folder, _ = twelve
    other = make_class(SHAPER, tmp_path / "class", 12, 7, jobs=2)
    now, before = contents(tmp_path / "class"), contents(folder)
    for place in (now, before):
        place["class.toml"] = place["class.toml"].partition(b"digest")[2]  # the way to the assignment differs
    assert now == before
    assert other.refused == twelve[1].refused


@pytest.mark.slow
def test_what_many_are_judged_by_is_what_each_is_judged_by() -> None:
    """The linkage and forces of sixty at once refuse those that all stages of each refuse, by the same demand."""
    judge = Judge(SHAPER, 1)
    every = [one for number in range(60) if not (one := candidate(judge.drawn, 5, number)).missing]
    together = judge.at_once(every)
    assert len(together) == len(every)
    alone = {row.point: judge.verdict(row).refusal for row in judge.whole(every)}
    assert {number: each and each.demand for number, each in together.items()} == {
        number: each and each.demand for number, each in alone.items()
    }
    assert 5 <= sum(each is None for each in alone.values()) <= 55


def test_presses_whose_ram_turns_twice_are_judged_together_though_most_turn_four_times() -> None:
    """Those beyond the limit position of the knuckle have four dead centres, no stroke ratio, and are solved alone."""
    judge = Judge(PRESS, 1)
    every = [one for number in range(48) if not (one := candidate(judge.drawn, 7, number)).missing]
    together = judge.at_once(every)
    judged = {number: each for number, each in together.items() if each is None or "turn" not in each.demand}
    assert len(judged) >= 5
    some = [one for one in every if one.number in judged][:4]
    values = [key for key in judge.asked if key.stage in ("kinematics", "forces")]
    for row in judge.whole(some):
        refusal, cheap = judge.verdict(row).refusal, judged[row.point]
        assert cheap is None or (refusal is not None and refusal.demand == cheap.demand)
        assert {each.key for each in values} <= {*row.names}


@pytest.mark.slow
def test_more_are_drawn_later_and_those_given_out_stay(twelve: tuple[Path, Made], tmp_path: Path) -> None:
    folder = tmp_path / "class"
    make_class(SHAPER, folder, 8, 7, jobs=1)
    before = contents(folder)
    times = {path.name: path.stat().st_mtime_ns for path in (folder / "variants").iterdir()}
    made = make_class(SHAPER, folder, 12, jobs=1)
    after = contents(folder)
    assert len(made.fresh) == 4
    for name, data in before.items():
        if name.startswith("variants"):
            assert after[name] == data
            assert (folder / name).stat().st_mtime_ns == times[Path(name).name]
    assert {name: data for name, data in after.items() if "class.toml" not in name} == {
        name: data for name, data in contents(twelve[0]).items() if "class.toml" not in name
    }
    assert read_class(folder).variants == twelve[1].own.variants


@pytest.mark.slow
def test_nothing_is_drawn_where_there_are_enough(tmp_path: Path) -> None:
    folder = tmp_path / "class"
    make_class(SHAPER, folder, 3, 7, jobs=1)
    before = contents(folder)
    made = make_class(SHAPER, folder, 2, jobs=1)
    assert (made.fresh, made.files, contents(folder)) == ((), (), before)


@pytest.mark.slow
def test_a_lost_file_is_written_again(twelve: tuple[Path, Made], tmp_path: Path) -> None:
    folder = tmp_path / "class"
    make_class(SHAPER, folder, 3, 7, jobs=1)
    before = contents(folder)
    (folder / "variants" / "02.toml").unlink()
    make_class(SHAPER, folder, 3, jobs=1)
    assert contents(folder) == before


class StopError(Exception):
    """What stops a run in the midst."""


@pytest.mark.slow
def test_a_run_that_was_stopped_goes_on(
    twelve: tuple[Path, Made], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder, solved = tmp_path / "class", list[int]()
    whole = Judge.whole

    def counted(self: Judge, candidates: Any) -> Any:
        solved.extend(each.number for each in candidates)
        return whole(self, candidates)

    def stop(done: int, words: str) -> None:
        if done == 7:
            raise StopError

    monkeypatch.setattr(Judge, "whole", counted)
    with pytest.raises(StopError):
        make_class(SHAPER, folder, 12, 7, jobs=1, told=stop)
    assert [path.name for path in folder.iterdir()] == [".class.toml.part"]
    first = {*solved}
    solved.clear()
    made = make_class(SHAPER, folder, 12, 7, jobs=1)
    assert not first & {*solved}
    assert made.refused == twelve[1].refused
    assert [each.values for each in made.fresh] == [each.values for each in twelve[1].fresh]
    assert {name: data for name, data in contents(folder).items() if "class.toml" not in name} == {
        name: data for name, data in contents(twelve[0]).items() if "class.toml" not in name
    }


@pytest.mark.slow
def test_a_changed_assignment_is_refused_unless_fresh(tmp_path: Path) -> None:
    file, folder = written(tmp_path), tmp_path / "class"
    make_class(file, folder, 3, 7, jobs=1)
    before = contents(folder)
    written(
        tmp_path,
        ('title = "Shaper: an assignment"', 'title = "Another title"'),
        ("[class]\n", "[class]\nplans = 0.05\n"),
    )
    make_class(file, folder, 3, jobs=1)
    assert contents(folder) == before
    written(tmp_path, ("mass = 55", "mass = 56"))
    with pytest.raises(UsageError, match="not that of the 3 variants"):
        make_class(file, folder, 4, jobs=1)
    with pytest.raises(UsageError, match="was drawn with seed 7"):
        make_class(written(tmp_path), folder, 4, 8, jobs=1)
    assert contents(folder) == before
    made = make_class(written(tmp_path, ("mass = 55", "mass = 56")), folder, 2, 8, fresh=True, jobs=1)
    assert made.own.seed == 8
    assert sorted(path.name for path in (folder / "variants").iterdir()) == ["01.toml", "02.toml"]


@pytest.mark.slow
def test_who_comes_later_gets_a_new_variant_and_who_leaves_keeps_it(tmp_path: Path) -> None:
    roster = tmp_path / "roster.txt"
    roster.write_text("Шевченко Тарас\n\nIvanenko\n  Шевченко   Тарас \n", encoding="utf-8")
    file, folder = written(tmp_path, ("[class]\n", '[class]\nroster = "roster.txt"\n')), tmp_path / "class"
    make_class(file, folder, jobs=1)
    own = read_class(folder).variants
    assert [(each.number, each.student) for each in own] == [
        (1, "Шевченко Тарас"),
        (2, "Ivanenko"),
        (3, "Шевченко Тарас"),
    ]
    names = ["01-Шевченко_Тарас.toml", "02-Ivanenko.toml", "03-Шевченко_Тарас.toml"]
    assert sorted(path.name for path in (folder / "variants").iterdir()) == names
    before = contents(folder)
    roster.write_text("../../x\nШевченко Тарас\nШевченко Тарас\n=1+1\n", encoding="utf-8")
    made = make_class(file, folder, jobs=1)
    assert made.own.variants[:3] == own
    assert [each.student for each in made.own.variants[3:]] == ["../../x", "=1+1"]
    after = sorted(path.name for path in (folder / "variants").iterdir())
    assert after == [*names, "04-x.toml", "05-1_1.toml"]
    assert all(contents(folder)[f"variants/{name}"] == before[f"variants/{name}"] for name in names)
    assert make_class(file, folder, 7, jobs=1).own.variants[5:] == read_class(folder).variants[5:]
    assert [each.student for each in read_class(folder).variants[5:]] == ["", ""]


@pytest.mark.slow
def test_a_roster_names_the_variants_that_have_no_name_first(tmp_path: Path) -> None:
    file, folder = written(tmp_path), tmp_path / "class"
    before = make_class(file, folder, 2, 7, jobs=1).own.variants
    (tmp_path / "roster.txt").write_text("Ada\n=HYPERLINK(0)\nOlha\n", encoding="utf-8")
    made = make_class(written(tmp_path, ("[class]\n", '[class]\nroster = "roster.txt"\n')), folder, jobs=1)
    assert [each.student for each in made.own.variants] == ["Ada", "=HYPERLINK(0)", "Olha"]
    assert [each.assignments for each in made.own.variants[:2]] == [each.assignments for each in before]
    files = sorted((folder / "variants").iterdir())
    assert [path.name for path in files] == ["01-Ada.toml", "02-HYPERLINK_0.toml", "03-Olha.toml"]
    assert files[0].read_text(encoding="utf-8").startswith("# Variant 1, Ada\n")
    with (folder / "class.csv").open(encoding="utf-8", newline="") as lines:
        assert [row[1] for row in csv.reader(lines)] == ["student", "Ada", "'=HYPERLINK(0)", "Olha"]


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (r"(points\.A\[0\]=\\?\")\d+", r"\g<1>7", "variant 1 has other numbers than those drawn"),
        (r"candidate = \d+", "candidate = 9999", "drawn as candidate 9999"),
        (r"tried = \d+", "tried = 0", "of 0 that were tried"),
        (
            r"digest = (.*)",
            r'digest = \g<1>\nunavoided = [["H", "linkage.no_such"]]',
            "no mistake is called 'linkage.no_such'",
        ),
    ],
)
def test_a_state_that_was_edited_is_refused_and_nothing_is_written(
    twelve: tuple[Path, Made], tmp_path: Path, old: str, new: str, message: str
) -> None:
    folder = tmp_path / "class"
    shutil.copytree(twelve[0], folder)
    state = folder / "class.toml"
    text = state.read_text(encoding="utf-8")
    edited, count = re.subn(old, new, text, count=1)
    assert count == 1
    state.write_text(edited, encoding="utf-8")
    before = contents(folder)
    with pytest.raises(SpecError, match=re.escape(message)):
        make_class(SHAPER, folder, 13, jobs=1)
    assert contents(folder) == before


@pytest.mark.slow
def test_what_is_given_and_numbers_in_comments_are_told(tmp_path: Path) -> None:
    more = '[[class.asked]]\nresult = "kinematics.size(omega_1)"\nunit = "rpm"\nname = "n"\n'
    comment = ("[project]", "# The crank is 200 mm long; 1200 mm, 620.5 mm and 620 mmm are other numbers.\n[project]")
    made = make_class(written(tmp_path, comment, more=more), tmp_path / "class", 3, 7, jobs=1)
    assert made.given == (("n", "mechanism.input.speed"),)
    assert made.stale == ("200 mm",)
    notes = " ".join(class_document(made, "").notes)
    assert "n is what is given by mechanism.input.speed in all variants" in notes
    assert "a comment of the assignment says 200 mm" in notes


def test_repeats_are_no_candidates(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of six values the spread refuses all but that of the assignment, however often each is drawn again."""
    text, _, rest = SHAPER.read_text(encoding="utf-8").partition("[[class.drawn]]")
    asked = rest[rest.index("[[class.asked]]") :]
    speed = '[[class.drawn]]\nof = "mechanism.input.speed"\namong = [{}]\n'.format(
        ", ".join(f'"{n} rpm"' for n in (40, 45, 50, 55, 60, 65))
    )
    file = tmp_path / "assignment.toml"
    file.write_text(
        f"{text.replace(chr(10) + '[class]', chr(10) + '[class]' + chr(10) + 'spread = 1.01')}{speed}{asked}",
        encoding="utf-8",
    )
    with pytest.raises(NoSolutionError) as raised:
        make_class(file, tmp_path / "class", 3, 7, jobs=1)
    message = raised.value.message
    assert "1 of 3 variants keep all demands; of 6 candidates 5 are refused" in message
    assert "drawn before" not in message
    assert "within the spread" in message


def test_a_spread_that_no_variant_keeps_ends_before_any_is_good(tmp_path: Path) -> None:
    """The candidates whose clashes are looked for first are not sought for ever."""
    text = (CONFIGS / "assignment-train.toml").read_text(encoding="utf-8")
    file = tmp_path / "assignment.toml"
    file.write_text(text.replace("digits = 5\n", "digits = 5\nspread = 1.0001\n"), encoding="utf-8")
    with pytest.raises(NoSolutionError, match="within the spread"):
        make_class(file, tmp_path / "class", 2, 7, jobs=1, clashes=clashes_of)
    assert not (tmp_path / "class").exists()


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("\n \n", "no student is named"),
        ("A\n" + "B" * 81, "longer than 80 characters"),
        ("A\nB\x1b[31m\n", "hidden characters"),
        ("\n".join(map(str, range(1001))), "1001 students are more than 1000"),
    ],
)
def test_a_roster_that_is_none(tmp_path: Path, text: str, message: str) -> None:
    (tmp_path / "roster.txt").write_text(text, encoding="utf-8")
    file = written(tmp_path, ("[class]\n", '[class]\nroster = "roster.txt"\n'))
    with pytest.raises(SpecError, match=message):
        make_class(file, tmp_path / "class", jobs=1)
    assert not (tmp_path / "class").exists()


def test_faults_of_roster_and_assignment_are_told_at_once(tmp_path: Path) -> None:
    (tmp_path / "roster.txt").write_text("A\n" + "B" * 81 + "\nC\x1b[31m\n", encoding="utf-8")
    changes = (
        ("[class]\n", '[class]\nroster = "roster.txt"\n'),
        (
            'at_least = "5 kN"\nat_most = "9 kN"\nstep = "500 N"',
            'at_least = "5 kN"\nat_most = "9 kN"\nstep = "0.001 N"',
        ),
        ("kinematics.K_D", "kinematics.K_E"),
    )
    with pytest.raises(SpecError) as raised:
        make_class(written(tmp_path, *changes), tmp_path / "class", jobs=1)
    assert [each.path for each in raised.value.faults] == [
        "class.roster",
        "class.roster",
        "class.drawn[5]",
        "class.asked[1].result",
    ]
    assert [f"roster.txt:{line}: the name" in str(raised.value) for line in (1, 2, 3)] == [False, True, True]
    assert all(each.line is not None for each in raised.value.faults)
    assert not (tmp_path / "class").exists()


LOOSE = ('at_least = "80 deg"', 'at_least = "20 deg"')
IMPOSSIBLE = {
    "a constraint": ([('at_least = "80 deg"', 'at_least = "89.5 deg"')], "constraint transmits", "loosen it"),
    "the spread": ([LOOSE, ("[class]\n", "[class]\nspread = 1.0001\n")], "within the spread", "make spread larger"),
    "the distance": ([LOOSE, ("[class]\n", "[class]\napart = 0.6\n")], "a distance of 60 %", "make apart smaller"),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", IMPOSSIBLE)
def test_too_few_are_told_by_the_demand_that_removes_most(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    monkeypatch.setattr(choosing, "MOST", 600)
    monkeypatch.setattr(choosing, "DEAR", 30)
    changes, demand, remedy = IMPOSSIBLE[name]
    with pytest.raises(NoSolutionError) as raised:
        make_class(written(tmp_path, *changes), tmp_path / "class", 40, 7, jobs=1)
    assert demand in raised.value.message.partition("are refused")[2].partition(",")[0]
    assert remedy in raised.value.remedy
    assert not (tmp_path / "class").exists()


@pytest.mark.slow
def test_a_linkage_that_never_turns_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A connecting rod drawn shorter than the way that the end of the slotted link is off the line of the ram."""
    monkeypatch.setattr(choosing, "MOST", 300)
    asked = '[[class.asked]]\nresult = "kinematics.stroke_D"'
    drawn = '[[class.drawn]]\nof = "mechanism.links[id=4].points.D[0]"\namong = ["10 mm", "12 mm"]\n'
    file = written(tmp_path, (asked, f"{drawn}\n{asked}"))
    with pytest.raises(NoSolutionError, match="by links that assemble and turn"):
        make_class(file, tmp_path / "class", 5, 7, jobs=1)


@pytest.mark.slow
def test_a_small_assignment_is_drawn_out(tmp_path: Path) -> None:
    """Of three values there are no four variants: it ends when all are tried."""
    text = SHAPER.read_text(encoding="utf-8")
    first, rest = text.partition("[[class.drawn]]")[0], text[text.index("[[class.asked]]") :]
    one = '[[class.drawn]]\nof = "mechanism.links[id=5].mass"\namong = [180, 190, 200]\n\n'
    file = tmp_path / "assignment.toml"
    file.write_text(first + one + rest, encoding="utf-8")
    made = make_class(file, tmp_path / "class", 3, 7, jobs=1)
    assert sorted(each.assignments for each in made.own.variants) == [
        (f"mechanism.links[id=5].mass={mass}",) for mass in (180, 190, 200)
    ]
    with pytest.raises(NoSolutionError, match="0 of 1 variants"):
        make_class(file, tmp_path / "class", 4, jobs=1)


@pytest.mark.slow
def test_a_mistake_that_gives_the_right_answer_removes_a_variant_or_is_told() -> None:
    """One clashes for one crank of nine, one always: the first is avoided, the second is told."""

    asked: list[Sought | None] = []

    def pairs(candidates: Sequence[Candidate], sought: Sought | None) -> dict[int, list[tuple[str, str]]]:
        asked.append(sought)
        return {
            each.number: [("K", "always"), *([("H", "now and then")] if each.values[0] == 220 else [])]
            for each in candidates
        }

    judge = Judge(SHAPER, 1)
    choice = Chooser(judge, 7, clashes=pairs).choose(20)
    assert choice.unavoided == (("K", "always"),)
    cranks = {int(each.assignments[0].partition('="')[2].removesuffix(' mm"')) for each in choice.chosen}
    assert 220 not in cranks
    assert choice.refused["H: no mistake that gives the right answer"] > 0
    probed = asked.index(next(sought for sought in asked if sought is not None))
    assert asked[:probed] == [None] * choosing.PROBED  # one good candidate at a time, of which all are asked
    assert {sought.unavoided for sought in asked[probed:] if sought} == {choice.unavoided}
    assert {tuple(sought.counts) for sought in asked[probed:] if sought} <= {(), ("now and then",)}


@pytest.mark.slow
def test_known_mistakes_are_found_side_by_side(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The same at one process and two; by keys made afresh no variant has a clash that is not told."""
    monkeypatch.setattr(choosing, "PROBED", 4)
    one, two = (make_class(SHAPER, tmp_path / f"{n}", 4, 7, jobs=n, clashes=clashes_of) for n in (1, 2))
    assert (one.own, one.refused) == (two.own, two.refused)
    assert one.own.unavoided
    spec = load_spec(SHAPER)
    mistakes = mistakes_of(spec)
    for each in one.own.variants:
        key = key_of(each.number, "", load_spec(SHAPER, each.assignments), items_of(spec), mistakes)
        found = {(one.items[item].name, mistakes[at].name) for at, item in clashes(key, one.items)}
        assert found <= {*one.own.unavoided}
    assert read_class(tmp_path / "1") == one.own
    judge, own = Judge(SHAPER, 1), one.own.variants[0]
    first = candidate(judge.drawn, 7, own.candidate)
    every = clashes_of(judge)([first], None)[own.candidate]
    assert {*every} <= {*one.own.unavoided}
    some = clashes_of(judge)([first], Sought((), Counter(mistake for _, mistake in every)))[own.candidate]
    assert some
    assert {*some} == {pair for pair in every if pair[1] == some[0][1]}  # all items of the first mistake
    assert clashes_of(judge)([first], Sought(tuple(every), {}))[own.candidate] == []
    later = make_class(SHAPER, tmp_path / "1", 5, jobs=1, clashes=clashes_of)
    assert later.own.unavoided == one.own.unavoided


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("[class]\n", "it is no class"),
        ('[class]\nassignment = "a"\ndigest = "b"\nseed = 1\ntried = "x"\n', "it is no class"),
        (
            '[class]\nassignment = "a"\ndigest = "b"\nseed = 1\ntried = 1\n'
            '[[variants]]\nnumber = 2\nstudent = ""\ncandidate = 0\nset = []\n',
            "not numbered from 1",
        ),
        ("[class\n", "it is no class"),
    ],
)
def test_a_damaged_state_is_told(tmp_path: Path, text: str, message: str) -> None:
    (tmp_path / "class.toml").write_text(text, encoding="utf-8")
    with pytest.raises(UsageError, match=message):
        make_class(SHAPER, tmp_path, 3, 7, jobs=1)
    assert (tmp_path / "class.toml").read_text(encoding="utf-8") == text


@pytest.mark.slow
def test_the_press_has_forty_variants_with_all_stages(tmp_path: Path) -> None:
    """Each with motor, gear set, flywheel and a cam without undercut, and unlike all others."""
    made = make_class(PRESS, tmp_path / "class", 40, 7)
    assert len(made.own.variants) == 40
    for file in sorted((tmp_path / "class" / "variants").iterdir())[::8]:
        found = run(load_spec(file))
        assert not found.failures
        assert {"train", "flywheel", "cam_profile"} <= {*found.results}
        assert judging._warnings(found) == []
