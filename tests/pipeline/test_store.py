"""The files of a stage: bit-exact, deterministic, untouched if unchanged, believed only if whole."""

from __future__ import annotations

import io
import math
import os
import tomllib
from enum import IntEnum, StrEnum
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from properties import examples

from tmmcalc.core.atomic import replace_file
from tmmcalc.core.errors import UsageError
from tmmcalc.core.plain import plain_record, plain_table
from tmmcalc.core.stored import Record, Table
from tmmcalc.pipeline import content, manifest
from tmmcalc.pipeline.manifest import Manifest, Provenance
from tmmcalc.pipeline.store import CSV_ROWS, Damaged, Found, Missing, Store

from .toy import contents

ORIGIN = Provenance("path", "0.1.0", "ab" * 32, {"geometry": "cd" * 32}, {"method": "closed"})
SPECIALS = np.array([-0.0, 5e-324, 1 / 3, math.nextafter(1, 2), 1.7976931348623157e308, np.nan, np.inf])


def record() -> Record:
    rng = np.random.default_rng(1)
    return plain_record(
        Record(
            {"stroke": 0.1 + 0.2, "zero": -0.0, "names": ("A", "B'"), "group": {"class": 2, "closed": True}},
            {
                "xy": rng.normal(size=(25, 60)),
                "special": SPECIALS,
                "z": rng.normal(size=3) + 1j,
                "file": np.arange(3),
            },
            {"position": np.float64(1e-16)},
            {"iterations": np.int64(7)},
        )
    )


def table(rows: int = 25) -> Table:
    return Table(["phi[deg]", "x_C[m]"], [np.linspace(0, 360, rows), np.linspace(0, 1, rows) / 3])


def same(one: Record, other: Record) -> bool:
    arrays = one.arrays.keys() == other.arrays.keys() and all(
        a.dtype == (b := other.arrays[name]).dtype and a.shape == b.shape and a.tobytes() == b.tobytes()
        for name, a in one.arrays.items()
    )
    texts = [repr((r.scalars, r.error, r.counters)) for r in (one, other)]
    return arrays and texts[0] == texts[1]


def saved(folder: Path, csv: bool | None = None, rows: int = 25) -> Store:
    store = Store(folder)
    store.save(ORIGIN, record(), table(rows), csv)
    return store


def test_record_comes_back_bit_for_bit(tmp_path: Path):
    found = saved(tmp_path).find(ORIGIN)
    assert isinstance(found, Found)
    assert found.manifest.provenance == ORIGIN
    assert same(found.record(), record())


PLAIN = st.recursive(
    st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(st.characters(exclude_categories=["Cs"])),
    lambda part: st.lists(part, max_size=3) | st.dictionaries(st.text("aé.'\" ", max_size=3), part, max_size=3),
    max_leaves=12,
)


@examples(150)
@given(st.dictionaries(st.text("ab-_é.\n", max_size=3), PLAIN, max_size=4))
def test_any_scalars_come_back_exactly(scalars: dict):
    text = manifest.written(Manifest(ORIGIN, plain_record(Record(scalars)), {}, None))
    back = manifest.read(text).record.scalars
    assert back == scalars
    assert sorted_repr(back) == sorted_repr(scalars)


def sorted_repr(value) -> str:
    """Repr with sorted keys: it tells 1 from 1.0 from True and 0.0 from -0.0."""
    if isinstance(value, dict):
        return repr(sorted((key, sorted_repr(part)) for key, part in value.items()))
    return repr([sorted_repr(part) for part in value]) if isinstance(value, list) else repr(value)


def test_numpy_scalars_tuples_and_enums_become_plain():
    class Grade(StrEnum):
        NOTE = "note"

    class Kind(IntEnum):
        RRR = 1

    mixed = {
        "f": np.float64(0.1), "g": np.float32(0.5), "i": np.int32(3), "b": np.bool_(True), "t": (1, (2.0,)),
        "a": np.array([[1.0, 2.0]]), "s": np.str_("x"), "grade": Grade.NOTE, "kind": Kind.RRR,
    }  # fmt: skip
    plain = {
        "f": 0.1, "g": 0.5, "i": 3, "b": True, "t": [1, [2.0]], "a": [[1.0, 2.0]], "s": "x", "grade": "note",
        "kind": 1,
    }  # fmt: skip
    assert repr(plain_table(mixed, "scalars")) == repr(plain)


@pytest.mark.parametrize("value", [None, 1j, object(), np.complex128(1j), np.array([1j]), {1: 2}, [{"a": None}]])
def test_what_toml_cannot_hold_is_refused_with_its_name(value):
    with pytest.raises(TypeError, match=r"scalars\.x"):
        plain_table({"x": value}, "scalars")


def test_arrays_of_objects_are_refused():
    with pytest.raises(TypeError, match="'x' holds Python objects"):
        plain_record(Record(arrays={"x": np.array([object()])}))


def test_npz_is_an_ordinary_npz():
    arrays = {"a": np.arange(6.0).reshape(2, 3), "scalar": np.array(1.5), "empty": np.zeros((0, 3))}
    with np.load(io.BytesIO(content.npz_bytes(arrays))) as archive:
        assert {name: (array.tolist(), array.shape) for name, array in archive.items()} == {
            name: (array.tolist(), array.shape) for name, array in arrays.items()
        }


def test_csv_round_trips_and_quotes_headers():
    table = Table(["phi[deg]", 'odd,"name"'], [SPECIALS[:5], np.arange(5)])
    lines = content.csv_bytes(table).decode().split("\n")
    assert lines[0] == 'phi[deg],"odd,""name"""'
    assert lines[-1] == ""
    assert [float(line.split(",")[0]) for line in lines[1:-1]] == SPECIALS[:5].tolist()
    assert lines[1] == "-0.0,0"


def test_header_must_match_the_columns():
    with pytest.raises(ValueError, match="1 headers"):
        content.csv_bytes(Table(["a"], []))


def test_manifest_reads_as_documented(tmp_path: Path):
    saved(tmp_path)
    text = (tmp_path / "path.toml").read_text()
    tables = tomllib.loads(text)
    assert list(tables) == [
        "provenance", "settings", "result", "error", "counters", "files", "table", "digest"
    ]  # fmt: skip
    assert tables["provenance"]["upstream"] == {"geometry": "cd" * 32}
    assert tables["result"]["stroke"] == 0.1 + 0.2
    assert tables["files"]["npz"]["size"] == (tmp_path / "path.npz").stat().st_size
    assert text.splitlines()[-1] == f'sha256 = "{tables["digest"]["sha256"]}"'


def test_equal_bytes_in_two_folders(tmp_path: Path):
    saved(tmp_path / "a")
    saved(tmp_path / "b" / "deeper")
    assert contents(tmp_path / "a") == contents(tmp_path / "b" / "deeper")


def test_unchanged_files_are_not_touched(tmp_path: Path):
    store = saved(tmp_path)
    before = {path: path.stat() for path in store.files("path")}
    saved(tmp_path)
    after = {path: path.stat() for path in store.files("path")}
    assert [(s.st_mtime_ns, s.st_ino) for s in before.values()] == [(s.st_mtime_ns, s.st_ino) for s in after.values()]


def test_memory_layout_does_not_matter(tmp_path: Path):
    c = np.arange(12.0).reshape(3, 4)
    variants = [c, np.asfortranarray(c), np.repeat(c, 2, axis=1)[:, ::2]]
    assert len({content.npz_bytes(plain_record(Record(arrays={"a": v})).arrays) for v in variants}) == 1


@pytest.mark.parametrize(
    ("csv", "rows", "there"),
    [(None, CSV_ROWS, True), (None, CSV_ROWS + 1, False), (True, CSV_ROWS + 1, True), (False, 3, False)],
)
def test_csv_is_written_as_asked(tmp_path: Path, csv: bool | None, rows: int, there: bool):
    saved(tmp_path, csv, rows)
    assert (tmp_path / "path.csv").exists() == there


def test_csv_that_is_not_to_be_is_removed(tmp_path: Path):
    saved(tmp_path)
    store = saved(tmp_path, csv=False)
    assert [path.name for path in store.files("path")] == ["path.toml", "path.npz"]
    assert isinstance(store.find(ORIGIN), Found)


def test_stage_without_arrays_and_table_has_the_manifest_alone(tmp_path: Path):
    store = saved(tmp_path)
    store.save(ORIGIN, Record({"x": 1}), None)
    assert [path.name for path in store.files("path")] == ["path.toml"]
    found = store.find(ORIGIN)
    assert isinstance(found, Found)
    assert not store.csv_differs(found, None)
    assert found.record() == Record({"x": 1})


def change(**fields) -> Provenance:
    return Provenance(**{**ORIGIN.__dict__, "hash": "ee" * 32, **fields})


@pytest.mark.parametrize(
    ("wanted", "reason"),
    [
        (change(), "inputs changed"),
        (change(program="0.2.0"), "made by version 0.1.0, this is 0.2.0"),
        (change(settings={"method": "newton"}), "settings changed"),
        (change(upstream={"geometry": "ff" * 32}), "geometry changed"),
    ],
)
def test_stale_result_is_missing_with_the_reason(tmp_path: Path, wanted: Provenance, reason: str):
    assert saved(tmp_path).find(wanted) == Missing(reason)


def test_empty_and_absent_folders_hold_nothing_and_are_not_created(tmp_path: Path):
    assert Store(tmp_path).find(ORIGIN) == Missing("no stored result")
    assert Store(tmp_path / "none").find(ORIGIN) == Missing("no stored result")
    assert not (tmp_path / "none").exists()


def flip(path: Path, at: int) -> None:
    data = bytearray(path.read_bytes())
    data[at] ^= 1
    path.write_bytes(data)


def edit(path: Path, old: str, new: str) -> None:
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))


DAMAGE = {
    "npz truncated": ("npz", lambda path: os.truncate(path, path.stat().st_size // 2)),
    "npz emptied": ("npz", lambda path: os.truncate(path, 0)),
    "npz flipped": ("npz", lambda path: flip(path, path.stat().st_size // 2)),
    "npz grown": ("npz", lambda path: path.write_bytes(path.read_bytes() + b"\0")),
    "npz gone": ("npz", lambda path: path.unlink()),
    "csv edited": ("csv", lambda path: edit(path, "\n15.0,", "\n15.1,")),
    "csv truncated": ("csv", lambda path: os.truncate(path, 40)),
    "toml scalar edited": ("toml", lambda path: edit(path, "0.30000000000000004", "0.3")),
    "toml hash edited": ("toml", lambda path: edit(path, "ab" * 32, "ee" * 32)),
    "toml comment added": ("toml", lambda path: path.write_text("# mine\n" + path.read_text())),
    "toml line added at the end": ("toml", lambda path: path.write_text(path.read_text() + "x = 1\n")),
    "toml line ends changed": (
        "toml",
        lambda path: path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n")),
    ),
    "toml digest removed": ("toml", lambda path: edit(path, "[digest]", "")),
    "toml truncated": ("toml", lambda path: os.truncate(path, path.stat().st_size // 2)),
    "toml emptied": ("toml", lambda path: os.truncate(path, 0)),
    "toml is not text": ("toml", lambda path: path.write_bytes(bytes(range(256)))),
}


@pytest.mark.parametrize("name", DAMAGE)
def test_damage_is_found_and_names_the_file(tmp_path: Path, name: str):
    store = saved(tmp_path)
    kind, spoil = DAMAGE[name]
    spoil(tmp_path / f"path.{kind}")
    found = store.find(ORIGIN)
    assert isinstance(found, Damaged), found
    assert found.message.startswith(f"{tmp_path / f'path.{kind}'}: ")
    assert any(word in found.message for word in ("expected", "digest"))


def test_every_single_byte_of_the_manifest_is_vouched_for(tmp_path: Path):
    store = saved(tmp_path)
    path = tmp_path / "path.toml"
    whole = path.read_bytes()
    for at in range(0, len(whole), 7):
        flip(path, at)
        assert isinstance(store.find(ORIGIN), Damaged), at
        path.write_bytes(whole)
    assert isinstance(store.find(ORIGIN), Found)


def test_files_of_another_stage_under_this_name_are_not_taken(tmp_path: Path):
    store = saved(tmp_path)
    (tmp_path / "path.toml").rename(tmp_path / "energy.toml")
    other = Provenance(**{**ORIGIN.__dict__, "stage": "energy", "hash": "ee" * 32})
    assert isinstance(store.find(other), Missing)


def test_csv_that_is_gone_is_written_again_not_damage(tmp_path: Path):
    store = saved(tmp_path)
    (tmp_path / "path.csv").unlink()
    found = store.find(ORIGIN)
    assert isinstance(found, Found)
    assert store.csv_differs(found, None)
    assert store.csv_differs(found, False)  # the manifest still lists it


def test_leftovers_of_killed_runs_are_removed_and_nothing_else(tmp_path: Path):
    store = saved(tmp_path)
    (tmp_path / ".path.npz.123.tmp").write_bytes(b"half")
    (tmp_path / ".mine.tmp").touch()
    (tmp_path / "path.npz.123.tmp").touch()
    store.find(ORIGIN)
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        ".lock", ".mine.tmp", "path.csv", "path.npz", "path.npz.123.tmp", "path.toml"
    ]  # fmt: skip


def test_file_in_place_of_the_folder(tmp_path: Path):
    (tmp_path / "file").touch()
    for folder in (tmp_path / "file", tmp_path / "file" / "out" / "deeper"):
        with pytest.raises(UsageError, match="file: is a file, not a folder") as caught:
            Store(folder)
        assert caught.value.exit_code == 2


def test_folder_name_too_long(tmp_path: Path):
    with pytest.raises(UsageError, match="cannot be used"):
        Store(tmp_path / ("x" * 300))


def test_folder_in_place_of_a_file(tmp_path: Path):
    (tmp_path / "path.npz").mkdir()
    with pytest.raises(UsageError, match=r"path\.npz: cannot be written: it is a folder"):
        saved(tmp_path)
    assert not (tmp_path / "path.toml").exists()
    (tmp_path / "path.npz").rmdir()
    (tmp_path / "path.toml").mkdir()
    with pytest.raises(UsageError, match=r"path\.toml: cannot be read: it is a folder"):
        Store(tmp_path).find(ORIGIN)


@pytest.mark.parametrize("call", ["open", "replace"])
def test_full_disk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, call: str):
    def full(*args, **kwargs):
        raise OSError(28, "No space left on device")

    store = saved(tmp_path)
    before = contents(tmp_path)
    monkeypatch.setattr(os if call != "open" else Path, call, full)
    other = plain_record(Record({"x": 2}, {"xy": np.zeros(3)}))
    with pytest.raises(UsageError, match=f"{tmp_path}.*No space left on device"):
        store.save(ORIGIN, other, None)
    monkeypatch.undo()
    assert contents(tmp_path) == before


def test_full_disk_under_a_file_that_nothing_vouches_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    def full(handle: int):
        raise OSError(28, "No space left on device")

    file = tmp_path / "own.toml"
    replace_file(file, b"old")
    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(UsageError, match=f"{file}.*No space left on device"):
        replace_file(file, b"new")
    assert contents(tmp_path) == {"own.toml": b"old"}


def test_read_only_folder_can_be_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    store = saved(tmp_path)
    opened = Path.open

    def only_read(path: Path, mode: str = "r", *args, **kwargs):
        if mode != "rb" and mode != "r":
            raise PermissionError(13, "Permission denied")
        return opened(path, mode, *args, **kwargs)

    monkeypatch.setattr(Path, "open", only_read)
    found = store.find(ORIGIN)
    assert isinstance(found, Found)
    assert same(found.record(), record())
    with pytest.raises(UsageError, match="cannot be written: Permission denied"):
        store.save(ORIGIN, record(), None)
