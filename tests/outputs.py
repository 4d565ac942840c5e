"""Records all that the program says, and compares two recordings: what did a change of the code change?

    python tests/outputs.py record FOLDER [--sample] [--program TREE] [--jobs N]
    python tests/outputs.py compare OLD NEW [--lines N]

``record`` runs the command line of the checkout TREE (by default this one) on the ready specs of this checkout, with
the commands of ``outputs_commands.py``, and leaves FOLDER/outputs.sqlite: by command its exit code, standard output,
standard error, the names of all files and the contents of those that are new or changed. Each command is a fork of a
process that has the libraries loaded but nothing of tmmcalc, with a fixed environment and LIMIT seconds of computing;
each scene has a temporary folder of its own, in which all names are relative. ``--sample`` is a representative tenth.
``compare`` tells what differs: the first lines, or where only numbers do, how many and by how much at most. Differences
in hashes alone are counted apart. The exit code is 0 if all is the same, otherwise 1.

What cannot be the same twice is not compared:

- run.log is left out: it has the time of day and run times;
- ``computed in 12 ms`` on standard error has its number masked, as has every run time of ``accuracy``. There the method
  that is cheapest for a tolerance follows from run times, so what is said of it is masked too;
- the temporary folder and the folder of the program are masked, should they occur.
"""

from __future__ import annotations

import argparse
import csv
import difflib
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

ROOT = Path(__file__).resolve().parents[1]
LIMIT = 120  # seconds of computing that a command may take
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
    *("matplotlib.figure", "matplotlib.patches", "matplotlib.ticker"),
    *("matplotlib.backends.backend_svg", "matplotlib.backends.backend_agg"),
]

Output = dict[str, bytes]  # exit, stdout, stderr, files (their names), and the contents of files by their name
MASKS = [(re.compile(r"(: [a-z ]+ in )\d+( ms \()"), r"\1*\2")]
TIMES = [  # in the tables of accuracy
    (re.compile(r"^cheapest .*(\n +.*)*", re.M), "cheapest *"),
    (re.compile(r" in [\d.e+-]+ ms\b"), " in * ms"),
    (re.compile(r"(\d\.\d+e[+-]\d+|failed) +[\d.e+-]+\b"), r"\1 *"),
    (re.compile(r" {2,}|-{2,}"), " "),
]
KINDS = ("the same", "other provenance", "other numbers", "other text")  # from the least to the greatest difference
HASH = re.compile(r"\b[0-9a-f]{64}\b")
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
BLANK = re.compile(r" +|-{2,}")


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
    return of_stages(Path(scene.specs[0]).name + ".toml", running)


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
    end = "no end" if status in (-signal.SIGXCPU, -signal.SIGALRM) else str(status)
    return {"exit": end.encode(), "stdout": out.read_bytes(), "stderr": err.read_bytes()}


def _main(args: list[str], home: Path, out: Path, err: Path) -> NoReturn:
    """The program's entry point in the child: a group of its own, ended by a signal at the limit."""
    code: object = 1
    try:
        os.setsid()
        resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT + 1))
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
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code if isinstance(code, int) else 1)


def _masked(data: bytes, command: str, home: Path, tree: Path) -> bytes:
    """Return an output without what cannot be the same twice."""
    text = _text(data)
    if text is None:
        return data
    text = text.replace(str(home.parent), "<folder>").replace(str(tree), "<tree>")
    if text.startswith("stage,quantity,reference,"):  # the csv of accuracy
        rows = list(csv.DictReader(io.StringIO(text)))
        return "\n".join(str({**row, "seconds": "*", "cheapest": "*"}) for row in rows).encode()
    for pattern, replacement in MASKS + (TIMES if command.startswith("accuracy") else []):
        text = pattern.sub(replacement, text)
    return text.encode()


def _text(data: bytes) -> str | None:
    try:
        return data.decode()
    except UnicodeDecodeError:
        return None


def compare(old: Path, new: Path, lines: int) -> int:
    """Print what differs between two recordings; return 0 if nothing does, otherwise 1."""
    one, two = _outputs(old), _outputs(new)
    kinds = Counter[str]()
    for folder, own, other in ((old, one, two), (new, two, one)):
        for command in own.keys() - other.keys():
            print(f"only in {folder}: {command}")
            kinds["only in one"] += 1
    for command in (command for command in one if command in two):
        worst, told = "the same", []
        for name in dict.fromkeys([*one[command], *two[command]]):
            kind, words = difference(name, one[command].get(name), two[command].get(name), lines)
            worst = max(worst, kind, key=KINDS.index)
            told += [f"    {name}: {words[0]}", *(f"        {line}" for line in words[1:])] if words else []
        kinds[worst] += 1
        if told:
            print(command, *told, sep="\n")
    print(", ".join(f"{kind}: {kinds[kind]}" for kind in (*KINDS, "only in one")))
    return 0 if kinds.keys() <= {"the same"} else 1


def _outputs(folder: Path) -> dict[str, Output]:
    """All outputs by command, in the order in which they were recorded; decompressed where they are used."""
    found: dict[str, Output] = {}
    with sqlite3.connect(folder / "outputs.sqlite") as store:
        for command, name, data in store.execute("select command, name, data from outputs order by rowid"):
            found.setdefault(command, {})[name] = data
    return found


def difference(name: str, old: bytes | None, new: bytes | None, lines: int) -> tuple[str, list[str]]:
    """Return the kind of the difference between two compressed outputs and some lines that tell it."""
    if old == new:
        return "the same", []
    if old is None or new is None:
        return "other text", ["is new" if old is None else "is no longer written"]
    old, new = zlib.decompress(old), zlib.decompress(new)
    if name.endswith(".npz"):
        return _arrays(old, new, lines)
    one, two = _text(old), _text(new)
    if one is None or two is None:
        return "other text", [f"{len(old)} and {len(new)} bytes differ"]
    one, two = HASH.sub("<hash>", one), HASH.sub("<hash>", two)
    if one == two:
        return "other provenance", []
    skeletons = [BLANK.sub(" ", NUMBER.sub("0", text)) for text in (one, two)]
    if skeletons[0] == skeletons[1]:
        pairs = [pair for pair in zip(NUMBER.findall(one), NUMBER.findall(two), strict=True) if pair[0] != pair[1]]
        if not pairs:
            return "other text", ["blanks differ"]
        off = [abs(float(a) - float(b)) / (max(abs(float(a)), abs(float(b))) or 1.0) for a, b in pairs]
        worst = off.index(max(off))
        first, second = pairs[worst]
        return "other numbers", [f"{len(pairs)} numbers differ, by {off[worst]:.1e} at most: {first} -> {second}"]
    changes = difflib.unified_diff(one.splitlines(), two.splitlines(), "", "", n=0, lineterm="")
    changed = [line[:160] for line in changes if not line.startswith(("---", "+++", "@@"))]
    return "other text", [f"{len(changed)} lines differ", *changed[:lines]]


def _arrays(old: bytes, new: bytes, lines: int) -> tuple[str, list[str]]:
    """Compare two npz files: of every array the largest difference relative to its largest magnitude."""
    import numpy as np

    one, two = np.load(io.BytesIO(old)), np.load(io.BytesIO(new))
    kind, told = "other provenance", [f"{name}: only in one" for name in sorted(set(one.files) ^ set(two.files))]
    for name in (name for name in one.files if name in two.files):
        a, b = one[name], two[name]
        if a.shape != b.shape or a.dtype != b.dtype:
            told.append(f"{name}: {a.dtype} {a.shape} -> {b.dtype} {b.shape}")
        elif a.tobytes() != b.tobytes():
            count = np.count_nonzero(a != b)
            if a.dtype.kind in "US":
                told.append(f"{name}: {count} of {a.size} texts differ")
                continue
            kind = "other numbers"
            off = np.nanmax(np.abs(a.astype(complex) - b)) / (np.nanmax(np.abs(a)) or 1.0)
            told.append(f"{name}: {count} of {a.size} numbers differ, by {off:.1e} of the largest at most")
    if any("numbers differ" not in line for line in told):
        kind = "other text"
    return kind, [f"{len(told)} arrays differ", *told[:lines]] if told else []


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
