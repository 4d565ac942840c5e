"""What happens when a spec is run: functions called, modules imported, files written; each in a fresh process.

    python -m stages.observed '["SPEC", "KEY=VALUE"]' ...     prints one line of JSON a spec

The process forks before every spec, with numpy and pydantic but no room of the program imported, so that a spec costs
its own imports and nothing of another one's.
"""

from __future__ import annotations

import json
import os
import sys
import tempfile
import traceback
from collections import Counter
from pathlib import Path
from types import FrameType
from typing import Any

HEAVY = ("scipy", "matplotlib", "joblib", "dask", "distributed", "ezdxf", "rich", "typer")


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


def main(scenes: list[list[str]]) -> None:
    """Observe every spec in a process of its own."""
    import numpy  # noqa: F401
    import pydantic  # noqa: F401
    import tomli_w  # noqa: F401

    import tmmcalc  # noqa: F401

    for scene in scenes:
        sys.stdout.flush()
        child = os.fork()
        if child == 0:
            code = 1
            try:
                print(json.dumps(observe(*scene)), flush=True)
                code = 0
            except BaseException:
                traceback.print_exc()
            finally:
                os._exit(code)
        _, status = os.waitpid(child, 0)
        if status:
            raise SystemExit(f"{scene[0]}: no observation")


if __name__ == "__main__":
    main([json.loads(scene) for scene in sys.argv[1:]])
