"""One command in a folder of its own, run in this process within bounds, and what is wrong with how it ends."""

from __future__ import annotations

import io
import math
import os
import re
import resource
import shutil
import signal
import sys
import traceback
import warnings
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from dataclasses import dataclass, field
from pathlib import Path
from types import FrameType
from typing import Any

from tmmcalc.cli import main

ROOT = Path(__file__).parents[2]
CONFIGS = ROOT / "configs"
SPEC = "case.toml"  # what the spec of a case is called in its folder
CODES = {0, 2, 3, 4, 5}  # documented, but for 1: a fault of the program
MEMORY = 2 << 30  # bytes that a command may take beyond what this process has
SECONDS = 25.0  # that a command may take without having said that it takes long
MEMORY_SAID = "more memory than there is"
SAID = re.compile(r"still at it after")
OF_RESULTS = re.compile(r"^error: constraints, (?!.*this scene has no )", re.MULTILINE)
OF_FOUND = re.compile(r"\[\d+\]\.\w+: there is no (link|point|joint) ")  # of a linkage that a synthesis finds
POWERS = re.compile(r"\d[\d.]*[eE]\+?\d+(?![.\w])")
UNREAL = re.compile(r"(?<![\w./\"'-])[-+]?(nan|inf|infinity)(?![\w./\"'(])", re.IGNORECASE)


@dataclass(frozen=True)
class Case:
    """A command line, in which ``SPEC`` stands for the spec, and the text of that."""

    args: tuple[str, ...]
    text: str
    about: str = ""  # how it was made


@dataclass
class Verdict:
    """How a command ended; ``faults`` are pairs of a cause, by which faults are sorted, and its details."""

    code: int | None = None
    out: str = ""
    err: str = ""
    faults: list[tuple[str, str]] = field(default_factory=list)


class TooLongError(BaseException):
    """The command was ended: no ``except`` of the program takes it for an error of its own."""


def judge(case: Case, folder: Path) -> Verdict:
    """Run a case in ``folder``, which is emptied first."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for table in CONFIGS.glob("*.csv"):
        shutil.copy(table, folder)
    (folder / SPEC).write_text(case.text, encoding="utf-8")
    before = set(folder.rglob("*"))
    verdict = _run(case.args, folder)
    fresh = sorted(file for file in set(folder.rglob("*")) - before if file.is_file())
    if verdict.code is not None and verdict.code not in CODES:
        verdict.faults.append((f"exit code {verdict.code}", verdict.err[-500:]))
    # whether a table has a column is known when it is computed, and so is what a constraint on a result can name,
    # and which links and points a linkage has that is still sought
    known_late = OF_RESULTS.search(verdict.err)
    sought = {file.stem for file in fresh} <= {".lock", "run", "synthesis"} and OF_FOUND.search(verdict.err)
    known_late = known_late or ("[synthesis" in case.text and sought)
    known_late = known_late and not any("feasibility" in file.name for file in fresh)
    if verdict.code == 2 and fresh and not known_late and "--columns" not in case.args:
        verdict.faults.append(("files on exit 2", ", ".join(file.name for file in fresh)))
    texts = {file.name: file.read_text("utf-8", "replace") for file in fresh if file.suffix in {".csv", ".toml"}}
    for name, text in {**texts, "stdout": verdict.out, "stderr": verdict.err}.items():
        shown = _quoted(text, case) if name in {"stdout", "stderr"} else text
        if found := UNREAL.search(shown):
            line = shown[: found.end()].rsplit("\n", 1)[-1]
            verdict.faults.append((f"{found[0]} in {name}", line[-300:]))
    return verdict


def _quoted(text: str, case: Case) -> str:
    """Messages quote what was given, which may be ``nan`` itself, or a number beyond all that there are."""
    given = (case.text, *case.args)
    beyond = any(math.isinf(float(each)) for words in given for each in POWERS.findall(words))
    return "" if beyond or any(map(UNREAL.search, given)) else text


def _run(args: tuple[str, ...], folder: Path) -> Verdict:
    verdict, out, err = Verdict(), io.StringIO(), io.StringIO()
    before, argv = Path.cwd(), sys.argv
    os.chdir(folder)
    sys.argv = ["tmmcalc", *args]
    try:
        with warnings.catch_warnings(record=True) as warned, redirect_stdout(out), redirect_stderr(err):
            warnings.simplefilter("ignore")
            for kind in (RuntimeWarning, UserWarning):
                warnings.simplefilter("always", kind)
            with bounded():
                main()
    except SystemExit as ended:
        verdict.code = ended.code if isinstance(ended.code, int) else int(ended.code is not None)
    except TooLongError as late:
        if not SAID.search(err.getvalue()):
            verdict.faults.append((f"time: {_place(late)}", f"{SECONDS:g} s without a word"))
    except BaseException as error:
        if isinstance(error, KeyboardInterrupt):
            raise
        verdict.faults.append((f"{type(error).__name__} {_place(error)}", traceback.format_exc()[-3000:]))
    finally:
        os.chdir(before)
        sys.argv = argv
    verdict.out, verdict.err = out.getvalue(), err.getvalue()
    if MEMORY_SAID in verdict.err:
        verdict.faults.append((f"memory: {' '.join(args[:2])}", verdict.err[-500:]))
    for one in warned:
        place = f"{Path(one.filename).name}:{one.lineno}"
        verdict.faults.append((f"warning {place}", f"{one.category.__name__}: {one.message} in {one.filename}"))
    return verdict


def _place(error: BaseException) -> str:
    """Where the program was: the innermost of its own lines."""
    frames = [one for one in traceback.extract_tb(error.__traceback__) if "/tmmcalc/" in one.filename]
    if not frames:
        return "outside"
    last = frames[-1]
    return f"{last.filename.rpartition('/tmmcalc/')[2]}:{last.lineno} {last.name}"


@contextmanager
def bounded(seconds: float = SECONDS, memory: int = MEMORY) -> Iterator[None]:
    """Context that is left with an exception after ``seconds``, and in which no more than ``memory`` is given out."""

    def late(number: int, frame: FrameType | None) -> Any:
        raise TooLongError

    pages = int(Path("/proc/self/statm").read_text().split()[0])
    limits = resource.getrlimit(resource.RLIMIT_AS)
    handler = signal.signal(signal.SIGALRM, late)
    resource.setrlimit(resource.RLIMIT_AS, (pages * resource.getpagesize() + memory, limits[1]))
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, handler)
        resource.setrlimit(resource.RLIMIT_AS, limits)
