"""``tmmcalc class keys``: files of the keys, what is printed, what is made again, and one message a fault."""

from __future__ import annotations

import csv
import json
import shutil
from pathlib import Path

import pytest

from tmmcalc.classroom.keybook import read_keybook, significant

from .conftest import CONFIGS, Cli, Once

KEYS = Path("class/keys/keys.toml")


@pytest.fixture
def made(cli: Cli, once: Once) -> Cli:
    """A class of two in the folder ``class``."""

    def make() -> None:
        assert cli("class", "make", "assignment.toml", "-n", "2", "--seed", "7", "-o", "class", "-q")[0] == 0

    shutil.copy(CONFIGS / "assignment-shaper.toml", "assignment.toml")
    once(Path("class"), make)
    return cli


@pytest.fixture
def keyed(made: Cli, once: Once) -> Cli:
    """The same with its keys."""

    def make() -> None:
        assert made("class", "keys", "class", "-j", "1", "-q")[0] == 0

    once(Path("class/keys"), make)
    return made


@pytest.mark.slow
def test_files_and_what_is_printed(made: Cli) -> None:
    code, out, err = made("class", "keys", "class", "-j", "1")
    assert (code, err) == (0, "wrote class/keys/keys.toml\nwrote class/keys/keys.csv\n")
    book = read_keybook(Path("class/keys"))
    assert [key.number for key in book.keys] == [1, 2]
    with Path("class/keys/keys.csv").open(encoding="utf-8-sig", newline="") as lines:
        rows = [*csv.DictReader(lines)]
    assert len(rows) == 2 * len(book.items)
    for row, value in zip(rows, [value for key in book.keys for value in key.values], strict=True):
        assert float(row["value"]) == pytest.approx(value, rel=1e-3)
    assert "linkage.coriolis_left_out" in out
    assert rows[0]["value"] in out
    assert {path.name for path in Path("class/keys").iterdir()} == {"keys.toml", "keys.csv"}


@pytest.mark.slow
def test_all_variants_for_programs_and_one_that_is_asked_for(made: Cli) -> None:
    code, out, _ = made("class", "keys", "class", "-j", "1", "--format", "json")
    whole = json.loads(out)
    assert code == 0
    assert whole["variants"] == 2
    code, out, _ = made("class", "keys", "class", "--variant", "2", "--format", "json")
    assert code == 0
    assert json.loads(out)["variants"] == 1


def test_printed_keys_lose_no_column(cli: Cli, folder: Path) -> None:
    """At 80 characters, with a long name: value, unit and tolerance are there, and what each name is."""
    text = (CONFIGS / "assignment-shaper.toml").read_text(encoding="utf-8")
    name = "angular velocity of the slotted link in position 4"
    Path("assignment.toml").write_text(
        text.replace('name = "omega_3"', f'name = "{name}"\neither_sense = true').replace(
            'after = ["omega_3"]', f'after = ["{name}"]'
        ),
        encoding="utf-8",
    )
    assert cli("class", "make", "assignment.toml", "-n", "1", "-q", "--skip-mistakes")[0] == 0
    _, out, _ = cli("class", "keys", "class", "-j", "1")
    book = read_keybook(Path("class/keys"))
    value = significant(book.keys[0].values[2], 4)
    right = next(line for line in out.splitlines() if value in line)
    assert "rad/s" in right
    assert significant(0.01 * abs(book.keys[0].values[2]), 2) in right
    assert significant(-book.keys[0].values[2], 4) in right
    assert "kinematics.omega_3@4" in out
    assert "more columns: keys.toml and --format json have all" in out


@pytest.mark.slow
def test_an_assignment_that_has_lost_its_class(made: Cli) -> None:
    file = Path("assignment.toml")
    file.write_text(file.read_text(encoding="utf-8").partition("\n[class]")[0], encoding="utf-8")
    for words in (("keys", "class"), ("mark", "class", "answers")):
        code, _, err = made("class", *words)
        assert code == 2
        assert "the spec has no [class]" in err
        assert "add [class] with [[class.asked]]" in err


@pytest.mark.slow
def test_keys_are_not_made_twice(keyed: Cli, monkeypatch: pytest.MonkeyPatch) -> None:
    first, stamp = KEYS.read_bytes(), KEYS.stat().st_mtime_ns
    with monkeypatch.context() as patched:
        patched.setattr("tmmcalc.classroom.keymaking.key_of", None)
        assert keyed("class", "keys", "class", "-j", "1", "-q")[0] == 0
    assert (KEYS.read_bytes(), KEYS.stat().st_mtime_ns) == (first, stamp)
    assert keyed("class", "keys", "class", "-j", "1", "-q", "--fresh")[0] == 0
    assert KEYS.read_bytes() == first


@pytest.mark.slow
def test_more_variants_leave_the_keys_of_the_others(keyed: Cli) -> None:
    before = read_keybook(Path("class/keys"))
    keyed("class", "make", "assignment.toml", "-n", "3", "-o", "class", "-q")
    assert keyed("class", "keys", "class", "-j", "1", "-q")[0] == 0
    after = read_keybook(Path("class/keys"))
    assert [key.values for key in after.keys[:2]] == [key.values for key in before.keys]
    assert len(after.keys) == 3


@pytest.mark.slow
def test_damaged_keys_are_one_message(keyed: Cli) -> None:
    KEYS.write_bytes(KEYS.read_bytes().replace(b"values", b"valves", 1))
    code, out, err = keyed("class", "keys", "class", "-j", "1")
    assert (code, out) == (2, "")
    assert "class/keys/keys.toml is damaged or was edited" in err
    assert "--fresh" in err
    assert keyed("class", "keys", "class", "-j", "1", "-q", "--fresh")[0] == 0
    read_keybook(Path("class/keys"))


@pytest.mark.slow
def test_another_assignment_is_refused_other_tolerances_are_taken(made: Cli) -> None:
    text = Path("assignment.toml").read_text()
    Path("assignment.toml").write_text(text.replace('tolerance = "0.5 %"', 'tolerance = "3 %"', 1))
    assert made("class", "keys", "class", "-j", "1", "-q")[0] == 0
    assert {item.name: item.tolerance for item in read_keybook(Path("class/keys")).items}["K"] == 0.03
    Path("assignment.toml").write_text(text.replace('gravity = "9.81 m/s^2"', 'gravity = "9.80 m/s^2"'))
    code, out, err = made("class", "keys", "class", "-j", "1")
    assert (code, out) == (2, "")
    assert "the assignment is not that of the 2 variants in class" in err


@pytest.mark.slow
@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("nowhere",), "there is no class in nowhere"),
        (("class", "--variant", "3"), "there is no variant 3"),
        (("class", "-o", "assignment.toml"), "assignment.toml is a file"),
    ],
)
def test_a_fault_is_one_message(made: Cli, words: tuple[str, ...], said: str) -> None:
    code, out, err = made("class", "keys", *words)
    assert (code, out) == (2, "")
    assert said in err
    assert not KEYS.exists()
