"""Two thousand mutants of specs and command lines end as they should; what once did not is kept in ``cases``.

Another seed or number: ``FUZZ_SEED=2 FUZZ_COUNT=500 pytest -m slow tests/fuzz``. Every failure is written to
``cases`` as a file of its own, by which it is run again until it is mended, and ever after.
"""

from __future__ import annotations

import os
import re
import tomllib
from collections import defaultdict
from pathlib import Path

import pytest
import tomli_w

from fuzz.judge import Case, judge
from fuzz.mutants import mutant

CASES = Path(__file__).with_name("cases")
LONG = {"lengths-of-no-length"}
SEED = int(os.environ.get("FUZZ_SEED", "1"))
COUNT = int(os.environ.get("FUZZ_COUNT", "2000"))


def kept(file: Path) -> Case:
    data = tomllib.loads(file.read_text("utf-8"))
    return Case(tuple(data["args"]), data["text"], data["about"])


def keep(case: Case, cause: str) -> Path:
    """Write a case to a file that is named by its cause; the first of a cause is kept."""
    CASES.mkdir(exist_ok=True)
    file = CASES / f"{re.sub('[^a-z0-9]+', '-', cause.lower()).strip('-')[:70]}.toml"
    if not file.exists():
        data = {"about": case.about, "args": list(case.args), "text": case.text}
        file.write_text(tomli_w.dumps(data, multiline_strings=True), "utf-8")
    return file


@pytest.mark.parametrize(
    "file",
    [
        pytest.param(file, marks=pytest.mark.slow if file.stem in LONG else (), id=file.stem)
        for file in sorted(CASES.glob("*.toml"))
    ],
)
def test_what_once_failed(file: Path, tmp_path: Path, known_schema: None) -> None:
    assert judge(kept(file), tmp_path / "case").faults == []


@pytest.mark.slow
def test_mutants(tmp_path: Path, known_schema: None) -> None:
    found: dict[str, list[str]] = defaultdict(list)
    for number in range(COUNT):
        case = mutant(SEED, number)
        for cause, details in judge(case, tmp_path / "case").faults:
            file = keep(case, cause)
            found[cause].append(f"{number} ({case.about}), {file.name}: {details[-300:]}")
    assert not found, "\n".join(f"{len(listed)} times {cause}: {listed[0]}" for cause, listed in found.items())
