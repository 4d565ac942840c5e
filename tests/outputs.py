"""Records all that the program says, and compares two recordings: what did a change of the code change?

    python tests/outputs.py record FOLDER [--sample] [--program TREE] [--jobs N]
    python tests/outputs.py compare OLD NEW [--lines N]

``record`` runs the command line of the checkout TREE (by default this one) on the ready specs of this checkout, with
the commands of ``outputs_commands.py``, and leaves FOLDER/outputs.sqlite: by command its exit code, standard output,
standard error, the names of all files and the contents of those that are new or changed. Each command is a fork of a
process that has the libraries loaded but nothing of tmmcalc, with a fixed environment, LIMIT seconds of computing and
MEMORY bytes; each scene has a temporary folder of its own, in which all names are relative. ``--sample`` takes a
representative tenth. ``compare`` tells what differs: the first lines, or where only numbers do, how many and by how
much at most. Differences in hashes alone are counted apart. The exit code is 0 if all is the same, otherwise 1.

What cannot be the same twice is not compared:

- run.log is left out: it has the time of day and run times;
- ``11 stages computed in 1.2 s`` and ``computed in 12 ms`` on standard error have the time masked, as has every run
  time of ``accuracy``. There the method that is cheapest for a tolerance follows from run times, so what is said of it
  is masked too;
- the temporary folder and the folder of the program are masked, should they occur.
"""

from __future__ import annotations

import argparse
import csv
import gc
import importlib
import importlib.util
import io
import json
import os
import re
import resource
import shlex
import shutil
import signal
import sqlite3
import sys
import tempfile
import time
import traceback
import zlib
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from contextlib import suppress
from multiprocessing import get_context
from pathlib import Path
from typing import NoReturn

from outputs_commands import Scene, of_stages, scenes
from outputs_compare import Output, compare, text_of

ROOT = Path(__file__).resolve().parents[1]
LIMIT = 120  # seconds of computing that a command may take
MEMORY, NO_MEMORY = 4 << 30, 99  # bytes that it may take, and the exit code if these do not do
FIXED = {
    "COLUMNS": "80",
    "LC_ALL": "C.UTF-8",
    "MPLBACKEND": "Agg",
    "NO_COLOR": "1",
    "OPENBLAS_NUM_THREADS": "1",
    "PYDANTIC_DISABLE_PLUGINS": "1",
    "PYTHONHASHSEED": "0",
    "SOURCE_DATE_EPOCH": "0",
    "TERM": "dumb",
    "TZ": "UTC",
}
WARM = [
    *("numpy", "numpy.polynomial", "typer", "tomllib", "tomli_w", "csv", "json", "joblib", "xml.sax", "urllib.request"),
    *("pydantic.main", "pydantic.type_adapter", "pydantic.functional_validators", "pydantic.plugin._loader"),
    *(f"scipy.{part}" for part in ("integrate", "interpolate", "linalg", "optimize", "sparse.linalg", "special")),
    *("rich.console", "rich.progress", "rich.table", "ezdxf", "ezdxf.path"),
]

MASKS = [
    (re.compile(r"(: [a-z ]+ in )\d+( ms \()"), r"\1*\2"),
    (re.compile(r"(\d stages? (?:computed|loaded) in )[\d.]+ m?s"), r"\1*"),
]
TIMES = [  # in the tables of accuracy
    (re.compile(r"^cheapest .*(\n +.*)*", re.M), "cheapest *"),
    (re.compile(r" in [\d.e+-]+ ms\b"), " in * ms"),
    (re.compile(r"(\d\.\d+e[+-]\d+|failed) +[\d.e+-]+\b"), r"\1 *"),
    (re.compile(r" {2,}|-{2,}"), " "),
]
ENDS = {-signal.SIGXCPU: "no time", -signal.SIGALRM: "no time", NO_MEMORY: "no memory"}


def record(folder: Path, tree: Path, sample: bool, jobs: int) -> int:
    """Run all commands, or a sample, and leave their outputs in the folder."""
    _in_fixed_environment(tree)
    for name in WARM:
        importlib.import_module(name)
    found = importlib.util.find_spec("tmmcalc")
    assert found is not None, f"{tree} has no tmmcalc"
    assert Path(str(found.origin)).parents[1] == tree, f"tmmcalc is that of {found.origin}"
    gc.freeze()  # a collection in a fork would copy all pages that it only looks at
    assert not any(name.split(".")[0] == "tmmcalc" for name in sys.modules)
    folder.mkdir(parents=True, exist_ok=True)
    whole, part = folder / "outputs.sqlite", folder / "outputs.part"
    part.unlink(missing_ok=True)
    began, ends, slow = time.monotonic(), Counter[str](), []
    with sqlite3.connect(part) as store, ProcessPoolExecutor(jobs, get_context("fork")) as pool:
        store.execute("create table outputs (command text, name text, data blob, primary key (command, name))")
        waiting = [pool.submit(play, scene, ROOT / "configs", tree) for scene in scenes(ROOT / "configs", sample)]
        for done, future in enumerate(waiting, 1):
            for command, seconds, output in future.result():
                store.executemany("insert into outputs values (?, ?, ?)", ((command, *item) for item in output.items()))
                end = zlib.decompress(output["exit"]).decode()
                ends[end] += 1
                slow += [f"{end}: {command}, {seconds:.0f} s"] if seconds > LIMIT / 4 or end not in "02345" else []
            print(f"\r{done} of {len(waiting)} scenes, {ends.total()} commands", end="", file=sys.stderr, flush=True)
    part.replace(whole)
    told = ", ".join(f"{count} end with {end}" for end, count in sorted(ends.items()))
    print(f"\n{whole}: {ends.total()} commands ({told}), {whole.stat().st_size / 1e6:.1f} MB")
    print(*slow, f"{time.monotonic() - began:.0f} s", sep="\n")
    return 0


def _in_fixed_environment(tree: Path) -> None:
    """Begin again if the environment is not the fixed one: the seed of hashes and sys.path are read at start."""
    kept = {name: os.environ[name] for name in ("HOME", "PATH") if name in os.environ}
    fixed = {**kept, **FIXED, "PYTHONPATH": str(tree)}
    if any(os.environ.get(name) != value for name, value in fixed.items()):
        os.execve(sys.executable, [sys.executable, *sys.argv], fixed)
    sys.path.remove(str(Path(__file__).parent))


def play(scene: Scene, configs: Path, tree: Path) -> list[tuple[str, float, Output]]:
    """Run the commands of a scene in a folder of its own: each with its seconds and outputs, compressed."""
    with tempfile.TemporaryDirectory() as name:
        home = Path(name) / "here"
        home.mkdir()
        for spec in scene.specs:
            shutil.copy(configs / f"{spec}.toml", home)
        for table in configs.glob("*.csv"):
            shutil.copy(table, home)
        for file, text in scene.files:
            (home / file).write_text(text, encoding="utf-8")
        known = _contents(home)
        commands, told, times = list(scene.commands), [], Counter[str]()
        for command in commands:
            began = time.monotonic()
            output = run(command, home)
            seconds = time.monotonic() - began
            if scene.stages and command == scene.commands[-1]:
                commands += _followers(scene, output)
            now = _contents(home)
            output |= {file: data for file, data in now.items() if known.get(file) != data}
            output = {part: _masked(data, command, home, tree) for part, data in output.items()}
            output["files"] = "\n".join(sorted(now)).encode()
            known = now
            times[command] += 1
            key = f"{scene.name}: tmmcalc {command}" + f" (time {times[command]})" * (times[command] > 1)
            told.append((key, seconds, {part: zlib.compress(data) for part, data in output.items()}))
    return told


def _followers(scene: Scene, plan: Output) -> list[str]:
    """The commands that follow from the stages of a ready spec, which ``plan`` names."""
    if plan["exit"] != b"0":
        return []
    columns = json.loads(plan["stdout"])["columns"]
    running = [stage for stage, runs in zip(columns["stage"], columns["runs"], strict=True) if runs == "yes"]
    return of_stages(scene.name, running)


def _contents(folder: Path) -> Output:
    files = (file for file in folder.rglob("*") if file.is_file() and file.name != "run.log")
    return {file.relative_to(folder).as_posix(): file.read_bytes() for file in files}


def run(command: str, home: Path) -> Output:
    """Run one command in a fork and return how it ended and what it printed."""
    out, err = home.parent / "stdout", home.parent / "stderr"
    child = os.fork()
    if child == 0:
        _main(shlex.split(command), home, out, err)
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    with suppress(ProcessLookupError):
        os.killpg(child, signal.SIGKILL)  # what it may have started
    end = ENDS.get(status, str(status))
    return {"exit": end.encode(), "stdout": out.read_bytes(), "stderr": err.read_bytes()}


def _main(args: list[str], home: Path, out: Path, err: Path) -> NoReturn:
    """The program's entry point in the child: a group of its own, ended by a signal at the limit."""
    code: object = 1
    try:
        os.setsid()
        resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT + 1))
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        signal.alarm(5 * LIMIT)  # one that only waits
        os.chdir(home)
        os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
        for number, file in ((1, out), (2, err)):
            os.dup2(os.open(file, os.O_WRONLY | os.O_CREAT | os.O_TRUNC), number)
        sys.argv = ["tmmcalc", *args]
        from tmmcalc.cli import main

        main()
        code = 0
    except SystemExit as end:
        code = end.code or 0
    except MemoryError:
        code = NO_MEMORY
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code if isinstance(code, int) else 1)


def _masked(data: bytes, command: str, home: Path, tree: Path) -> bytes:
    """Return an output without what cannot be the same twice."""
    text = text_of(data)
    if text is None:
        return data
    text = text.replace(str(home.parent), "<folder>").replace(str(tree), "<tree>")
    if text.startswith("stage,quantity,reference,"):  # the csv of accuracy
        rows = list(csv.DictReader(io.StringIO(text)))
        return "\n".join(str({**row, "seconds": "*", "cheapest": "*"}) for row in rows).encode()
    for pattern, replacement in MASKS + (TIMES if command.startswith("accuracy") else []):
        text = pattern.sub(replacement, text)
    return text.encode()


def main() -> int:
    """The two commands."""
    parser = argparse.ArgumentParser(description="Record all that the program says, and compare two recordings.")
    modes = parser.add_subparsers(dest="mode", required=True)
    recorder = modes.add_parser("record")
    recorder.add_argument("folder", type=Path)
    recorder.add_argument("--sample", action="store_true", help="a representative tenth")
    recorder.add_argument("--program", type=Path, default=ROOT, metavar="TREE", help="the checkout whose program runs")
    recorder.add_argument("--jobs", type=int, default=2)
    comparer = modes.add_parser("compare")
    comparer.add_argument("old", type=Path)
    comparer.add_argument("new", type=Path)
    comparer.add_argument("--lines", type=int, default=6, help="of one difference that are shown")
    asked = parser.parse_args()
    if asked.mode == "compare":
        return compare(asked.old, asked.new, asked.lines)
    return record(asked.folder, asked.program.resolve(), asked.sample, asked.jobs)


if __name__ == "__main__":
    sys.exit(main())
