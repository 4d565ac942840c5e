"""Output folders that others have a hand in: links, pipes, held locks, forged records, files of past stages."""

from __future__ import annotations

import fcntl
import hashlib
import io
import os
import re
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from time import perf_counter

import numpy as np
import pytest

from tmmcalc.core.errors import UsageError
from tmmcalc.pipeline.lock import locked
from tmmcalc.pipeline.outcome import Watch

from . import toy
from .toy import CALLS, Spec, go, shown

pytestmark = pytest.mark.skipif(os.name != "posix", reason="links, pipes and locks of POSIX")


@pytest.fixture
def out(tmp_path: Path) -> Path:
    go(out=tmp_path / "out")
    return tmp_path / "out"


@pytest.mark.parametrize("name", ["run.log", "path.csv", "path.npz", "path.toml", ".path.toml.{pid}.tmp"])
def test_a_link_in_the_folder_is_not_written_through(out: Path, tmp_path: Path, name: str) -> None:
    mine = tmp_path / "mine.txt"
    mine.write_text("mine\n")
    link = out / name.format(pid=os.getpid())
    link.unlink(missing_ok=True)
    link.symlink_to(mine)
    go(replace(Spec(), radius=0.3), out)
    assert mine.read_text() == "mine\n"


def test_a_lock_that_is_a_link_is_refused(out: Path, tmp_path: Path) -> None:
    (out / ".lock").unlink()
    (out / ".lock").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(UsageError, match=r"it is a link, which is not followed, not a file"):
        go(replace(Spec(), radius=0.3), out)
    assert not (tmp_path / "elsewhere").exists()


@pytest.mark.parametrize("name", [".lock", "path.toml", "path.npz", "path.csv"])
def test_a_pipe_in_the_folder_is_told_at_once(out: Path, name: str) -> None:
    (out / name).unlink()
    os.mkfifo(out / name)
    with pytest.raises(UsageError, match="it is a pipe, not a file"):
        go(replace(Spec(), radius=0.3), out)


def test_a_log_that_is_a_pipe_stops_no_run(out: Path) -> None:
    (out / "run.log").unlink()
    os.mkfifo(out / "run.log")
    assert go(replace(Spec(), radius=0.3), out).results["energy"]


def test_a_held_lock_is_told_and_given_up(out: Path) -> None:
    events: list[tuple[str, str]] = []
    with (out / ".lock").open("ab") as other:
        fcntl.flock(other, fcntl.LOCK_EX)
        began = perf_counter()
        with pytest.raises(UsageError, match=r"another process works in this folder, and has not ended within 0\.2 s"):
            go(Spec(), out, wait=0.2, watch=Watch(event=lambda event: events.append((event.kind, event.message))))
    assert 0.15 < perf_counter() - began < 5
    assert events == [("waiting", "another process works in the output folder; waiting up to 0.2 s")]


def test_a_lock_is_waited_for(out: Path) -> None:
    code = f"import fcntl, time; f = open({str(out / '.lock')!r}, 'ab'); fcntl.flock(f, 2); print(1, flush=True)\n"
    with subprocess.Popen([sys.executable, "-c", f"{code}time.sleep(0.7)"], stdout=subprocess.PIPE) as other:
        assert other.stdout is not None
        assert other.stdout.readline()
        result = go(Spec(), out, wait=30.0)
    assert shown(result) == [("", "waiting"), ("geometry", "loaded"), ("path", "loaded"), ("energy", "loaded")]


def test_a_lock_that_is_free_is_not_waited_for(tmp_path: Path) -> None:
    with locked(tmp_path, wait=0.0):
        pass


def test_files_of_a_stage_that_has_left_the_spec_go(out: Path) -> None:
    before = {path.name for path in out.iterdir()}
    result = go(replace(Spec(), speed=None), out)
    assert before - {path.name for path in out.iterdir()} == {"energy.toml", "energy.npz"}
    (event,) = (event for event in result.events if event.kind == "removed")
    assert (event.stage, event.message) == ("energy", "the spec has it no more; removed energy.toml, energy.npz")
    assert "energy removed" in (out / "run.log").read_text()
    assert not [event for event in go(replace(Spec(), speed=None), out).events if event.kind == "removed"]


def test_only_files_of_the_program_itself_go(out: Path) -> None:
    """A file that was changed, one that only looks like a record, one of another name and notes all stay."""
    (out / "energy.npz").write_bytes(b"mine")
    (out / "notes.toml").write_text("[provenance]\nstage = 'notes'\n")
    (out / "copy.toml").write_bytes((out / "path.toml").read_bytes())
    (out / "motion.csv").write_text("1,2\n")
    result = go(replace(Spec(), speed=None), out)
    assert {path.name for path in out.iterdir()} >= {"energy.npz", "notes.toml", "copy.toml", "motion.csv"}
    assert not (out / "energy.toml").exists()
    (event,) = (event for event in result.events if event.kind == "removed")
    assert event.message.endswith("removed energy.toml; energy.npz was changed by hand and stays")


@pytest.mark.parametrize("more", [{"target": "path"}, {"skip": ("energy",)}])
def test_files_of_a_stage_that_this_run_only_leaves_out_stay(out: Path, more: dict[str, object]) -> None:
    go(Spec(), out, **more)
    assert (out / "energy.toml").exists()


def reseal(file: Path, change: Callable[[bytes], bytes]) -> None:
    """Change a record and give it the digest that fits."""
    body, mark, _ = file.read_bytes().rpartition(b'\n[digest]\nsha256 = "')
    body = change(body)
    file.write_bytes(body + mark + hashlib.sha256(body).hexdigest().encode() + b'"\n')


def with_arrays(out: Path, data: bytes) -> None:
    (out / "path.npz").write_bytes(data)
    digest = hashlib.sha256(data).hexdigest().encode()
    reseal(
        out / "path.toml",
        lambda body: re.sub(
            rb'(\[files\.npz\]\nsize = )\d+(\nsha256 = ")\w+', rb"\g<1>%d\g<2>%s" % (len(data), digest), body
        ),
    )


def packed(**arrays: np.ndarray) -> bytes:
    buffer = io.BytesIO()
    np.savez(buffer, **arrays)
    return buffer.getvalue()


FORGED: dict[str, Callable[[Path], None]] = {
    "other shape": lambda out: with_arrays(out, packed(phi=np.zeros(3), xy=np.zeros(5))),
    "missing array": lambda out: with_arrays(out, packed(phi=np.zeros(3))),
    "no archive": lambda out: with_arrays(out, b"PK\x03\x04 none"),
    "missing field": lambda out: reseal(out / "path.toml", lambda body: body.replace(b"method", b"methods")),
    "no TOML": lambda out: reseal(out / "path.toml", lambda body: body + b"\n= =\n"),
    "other type": lambda out: reseal(out / "path.toml", lambda body: body.replace(b"[provenance]", b"[[provenance]]")),
    "other file": lambda out: reseal(out / "path.toml", lambda body: body.replace(b"files.npz", b'files."../x"')),
    "other size": lambda out: reseal(out / "path.toml", lambda body: re.sub(rb"size = (\d+)", rb'size = "\1"', body)),
}


@pytest.mark.parametrize("name", FORGED)
def test_a_forged_record_is_told_and_computed_again(out: Path, name: str) -> None:
    """The digest fits, so the file is believed until something breaks on it."""
    expected = go(Spec()).results["energy"].total
    FORGED[name](out)
    result = go(Spec(), out, from_stage="energy")
    assert ("path", "damaged") in shown(result)
    assert result.results["energy"].total == expected
    assert "path" in CALLS
    assert [kind for _, kind in shown(go(Spec(), out))] == ["loaded"] * 3


def test_a_forged_record_that_nobody_computes_with_is_told_where_it_is_read(out: Path) -> None:
    FORGED["no archive"](out)
    result = go(Spec(), out)
    with pytest.raises(UsageError, match=r"what is stored of path does not fit together .*") as caught:
        _ = result.results["path"]
    assert caught.value.remedy == "compute it again by --fresh"


def test_a_fault_of_the_program_stays_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(*args: object, **more: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr(toy.OfEnergy, "solve", staticmethod(broken))
    with pytest.raises(ZeroDivisionError):
        go(Spec(), tmp_path)
    with pytest.raises(ZeroDivisionError):
        go(Spec(), tmp_path)
