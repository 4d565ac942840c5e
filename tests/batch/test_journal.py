"""The journal of a sweep: every whole line counts, nothing else does."""

from __future__ import annotations

from array import array
from pathlib import Path

import pytest

from tmmcalc.batch.journal import Journal
from tmmcalc.batch.task import Row
from tmmcalc.core.errors import UsageError

ROWS = [
    Row(3, "ok", "", ("a.x[m]", "a.y"), array("d", (0.1, 1e-300))),
    Row(1, "failed 3", 'kinematics: нет сборки, "quoted"', ("a.x[m]",), array("d", (2 / 3,))),
    Row(2, "failed 2", "no such key", (), array("d")),
]


def kept(path: Path, key: str = "k") -> list[Row]:
    with Journal(path, key) as journal:
        return journal.rows()


@pytest.fixture
def path(tmp_path: Path) -> Path:
    with Journal(tmp_path / "t.part", "k") as journal:
        journal.append(ROWS[:2])
        journal.append(ROWS[2:])
    return tmp_path / "t.part"


def test_points_come_back_to_the_last_bit(path: Path) -> None:
    assert kept(path) == ROWS
    assert kept(path) == ROWS  # reading changes nothing


@pytest.mark.parametrize("cut", range(1, 60))
def test_a_torn_end_loses_only_the_last_point(path: Path, cut: int) -> None:
    data = path.read_bytes()
    lines = data.splitlines(keepends=True)
    path.write_bytes(data[:-cut])
    whole = len(b"".join(lines[:-1]))
    expected = ROWS[:2] if len(data) - cut >= whole else ROWS[:1]
    assert kept(path) == expected
    with Journal(path, "k") as journal:
        journal.append(ROWS[2:])
    assert kept(path) == [*expected, ROWS[2]]


def test_a_changed_line_is_passed_over(path: Path) -> None:
    lines = path.read_bytes().splitlines(keepends=True)
    at = next(k for k, line in enumerate(lines) if b"0.666" in line)
    lines[at] = lines[at].replace(b"0.666", b"0.667")
    path.write_bytes(b"".join(lines))
    assert kept(path) == [ROWS[0], ROWS[2]]


def test_names_that_are_lost_take_their_points_with_them(path: Path) -> None:
    lines = path.read_bytes().splitlines(keepends=True)
    path.write_bytes(b"".join(line for line in lines if b"a.y" not in line))
    assert kept(path) == ROWS[1:]
    with Journal(path, "k") as journal:
        journal.append(ROWS[:1])
    assert sorted(row.point for row in kept(path)) == [1, 2, 3]


def test_the_journal_of_another_task_is_emptied(path: Path) -> None:
    assert kept(path, "other") == []
    assert not path.exists()  # it held no point


def test_one_without_points_and_one_that_is_done_are_removed(path: Path) -> None:
    with Journal(path, "k") as journal:
        journal.done = True
    assert not path.exists()
    with Journal(path, "k"):
        assert path.exists()
    assert not path.exists()


def test_two_sweeps_do_not_write_one_journal(path: Path) -> None:
    with Journal(path, "k"), pytest.raises(UsageError, match="another sweep"):
        Journal(path, "k")
    assert kept(path) == ROWS


def test_a_folder_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="cannot be written"):
        Journal(tmp_path / "no" / "t.part", "k")
