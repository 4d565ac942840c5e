"""Every numeric key of the ready specs at its extremes: 0, the other sign, 1e-12 and 1e12 of its value, nan, inf.

``python tests/fuzz/extremes.py`` runs them all, about twenty minutes, and prints what is wrong, sorted by cause.
"""

from __future__ import annotations

import argparse
import math
import sys
import tempfile
import time
import tomllib
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import tomli_w

from fuzz.judge import CONFIGS, SPEC, Case, judge
from fuzz.places import leaves, numeric, pattern, replaced, times, valued

FACTORS = (-1.0, 1e-12, 1e12)
NUMBERS = (0.0, math.nan, math.inf)


def cases(every: int = 1) -> Iterator[Case]:
    """A key of one kind is taken from ``every`` specs at most, at its first place there."""
    taken: dict[str, int] = defaultdict(int)
    for file in sorted(CONFIGS.rglob("*.toml")):
        document = tomllib.loads(file.read_text("utf-8"))
        seen = set()
        for path, value in leaves(document):
            kind = pattern(path)
            if not numeric(value) or kind in seen or taken[kind] >= every:
                continue
            seen.add(kind)
            taken[kind] += 1
            others = [times(value, f) for f in FACTORS] + [valued(value, n) for n in NUMBERS]
            if isinstance(value, int):
                others.append(int(value * 1000))
            for other in dict.fromkeys(map(repr, others)):
                new = next(one for one in others if repr(one) == other)
                text = tomli_w.dumps(replaced(document, path, new))
                yield Case(("run", SPEC, "-o", "out"), text, f"{file.stem} {kind} = {new!r}")


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--only", default="")
    given = parser.parse_args()
    found: dict[str, list[str]] = defaultdict(list)
    slow = []
    with tempfile.TemporaryDirectory() as folder:
        for count, case in enumerate(cases(given.every)):
            if given.only not in case.about:
                continue
            began = time.monotonic()
            verdict = judge(case, Path(folder) / "case")
            took = time.monotonic() - began
            if took > 5:
                slow.append((took, case.about))
            for cause, details in verdict.faults:
                if not found[cause]:
                    print(f"[{count}] {cause}\n    {case.about}\n    {details[-1200:]}", flush=True)
                found[cause].append(case.about)
        print(f"{count + 1} cases")
    for cause, abouts in sorted(found.items(), key=lambda one: -len(one[1])):
        print(f"{len(abouts):4} {cause}")
        for about in abouts[:6]:
            print(f"       {about}")
    for took, about in sorted(slow, reverse=True)[:40]:
        print(f"slow {took:.1f} s {about}")


if __name__ == "__main__":
    main()
