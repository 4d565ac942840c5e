"""What happens when a spec is run: functions called, modules imported, files written; each in a fresh process.

``python -m stages.observed`` answers questions, one line of JSON each. It forks before every answer, with
what every run imports and nothing more, so that a spec costs its own imports and nothing of another one's.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import traceback
from collections import Counter
from functools import cache
from importlib import import_module
from pathlib import Path
from types import FrameType
from typing import Any

TESTS = Path(__file__).parents[1]
EVERY = ("numpy", "pydantic", "tomli_w", "tmmcalc.project", "tmmcalc.pipeline.runner")  # of a run
HEAVY = (
    "scipy",
    "reportlab",
    "joblib",
    "dask",
    "distributed",
    "ezdxf",
    "rich",
    "typer",
    "xlsxwriter",
    "pyarrow",
    "pandas",
)


def observe(file: str, *overrides: str) -> dict[str, Any]:
    """Run all stages of a spec; counts of the program's functions by ``path:name``, modules, files."""
    from tmmcalc.pipeline.runner import run
    from tmmcalc.project import load_spec

    home = str(Path(sys.modules["tmmcalc"].__file__ or "").parent) + os.sep
    called: Counter[Any] = Counter()

    def note(frame: FrameType, event: str, _: object) -> None:
        called[frame.f_code] += 1  # every call is told, and no line of it as nothing is returned

    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out"
        spec = load_spec(file, overrides)
        sys.settrace(note)
        try:
            result = run(spec, out=out)
        finally:
            sys.settrace(None)
        files = sorted(path.name for path in out.iterdir())
    counts: Counter[str] = Counter()
    for code, count in called.items():
        if code.co_filename.startswith(home):
            counts[f"{code.co_filename.removeprefix(home)}:{code.co_name}"] += count
    modules = sorted(name for name in sys.modules if name.startswith(("tmmcalc.", *HEAVY)))
    arrays = {name: sorted(outcome.record.arrays) for name, outcome in result.outcomes.items()}
    rows = {name: outcome.table.rows for name, outcome in result.outcomes.items() if outcome.table is not None}
    return {"counts": counts, "modules": modules, "files": files, "arrays": arrays, "rows": rows}


def imported(file: str, target: str | None, *overrides: str) -> list[str]:
    """Modules of the program, of scipy and of reportlab after a run to a stage that stores nothing."""
    from tmmcalc.pipeline.runner import run
    from tmmcalc.project import load_spec

    run(load_spec(file, overrides), target=target)
    return sorted(name for name in sys.modules if name.startswith(("tmmcalc.", "scipy", "reportlab")))


def answer(what: str, *given: Any) -> Any:
    """What ``observe`` or ``imported`` gives in a process of its own."""
    asked = _answering()
    assert asked.stdin is not None
    assert asked.stdout is not None
    asked.stdin.write(json.dumps([what, *given]) + "\n")
    asked.stdin.flush()
    found, fault = json.loads(asked.stdout.readline())
    assert not fault, fault
    return found


@cache
def _answering() -> subprocess.Popen[str]:
    """The process that answers; it ends with its input, that is with this process."""
    paths = os.pathsep.join([str(TESTS), str(TESTS.parent)])
    return subprocess.Popen(
        [sys.executable, "-m", "stages.observed"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": paths},
    )


def main() -> None:
    """Answer every question of the input in a process of its own."""
    for name in EVERY:
        import_module(name)
    while line := sys.stdin.readline():
        what, *given = json.loads(line)
        child = os.fork()
        if child == 0:
            try:
                said = [{"observe": observe, "imported": imported}[what](*given), ""]
            except BaseException:
                said = [None, traceback.format_exc()]
            print(json.dumps(said), flush=True)
            os._exit(0)
        os.waitpid(child, 0)


if __name__ == "__main__":
    main()
