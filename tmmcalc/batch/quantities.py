"""What a stage tells of a variant, by name: facts of its summary, and what is asked of columns of its table.

kinematics.stroke_D[m]      a fact; without its unit or its stage it is found too
forces.max(R_A)[N]          of a column: max, min, range, mean, size (largest magnitude), first, last
forces.max(R_*)             wildcards in either
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Sequence
from fnmatch import fnmatchcase
from typing import Any

from tmmcalc.core.errors import UsageError
from tmmcalc.core.facts import facts
from tmmcalc.feasibility.judge import OF, Constraint
from tmmcalc.feasibility.stages.judged import of_columns

Told = Iterator[tuple[str, float]]

OF_COLUMN = re.compile(rf"(?:(\w+|\*)\.)?({'|'.join(OF)})\((.+)\)(?:\[.*\])?")


def told(stage: str, result: Any, patterns: Sequence[str]) -> Told:
    """Quantities of one stage with their values, all facts without patterns; what is not finite is left out."""
    given = _facts(stage, result) if _asks_facts(stage, patterns) else iter(())
    for name, value in (*given, *_columns(stage, result, patterns)):
        if math.isfinite(value) and (not patterns or rank(name, patterns) is not None):
            yield name, value


def rank(name: str, patterns: Sequence[str]) -> int | None:
    """Which of the patterns names a quantity, the first; None if none does.

    >>> rank("kinematics.stroke_D[m]", ["motion.*", "stroke_*"])
    1
    """
    bare = name.rpartition("[")[0] if name.endswith("]") else name
    forms = {form for whole in (name, bare) for form in (whole, whole.partition(".")[2])}
    # a bracket is that of a unit, not of a set of letters
    quoted = (pattern.replace("[", "[[]") for pattern in patterns)
    return next((at for at, each in enumerate(quoted) if any(fnmatchcase(form, each) for form in forms)), None)


def stages_of(patterns: Sequence[str], known: Iterable[str]) -> tuple[str, ...]:
    """The stages that the patterns ask about, none if one of them may be of any stage."""
    named = [pattern.partition(".")[0] for pattern in patterns]
    stages = list(known)
    return tuple(stage for stage in stages if stage in named) if all(name in stages for name in named) else ()


def unmatched(names: Iterable[str], patterns: Sequence[str]) -> str | None:
    """The first pattern that names none of these quantities."""
    met = list(dict.fromkeys(names))
    return next((pattern for pattern in patterns if all(rank(name, [pattern]) is None for name in met)), None)


def others(pattern: str) -> tuple[str, ...]:
    """Patterns of all that could stand in place of one: the same of every column, or all facts."""
    match = OF_COLUMN.fullmatch(pattern)
    return (f"{match[1] or '*'}.{match[2]}(*)",) if match else ()


def unknown(pattern: str, names: Sequence[str]) -> UsageError:
    """The error of a pattern that names nothing, with the nearest of what there is."""
    from difflib import get_close_matches

    close = get_close_matches(pattern, names, 3, 0.5)
    remedy = f"did you mean {', '.join(close)}?" if close else f"quantities: {', '.join(names) or 'none'}"
    return UsageError(f"no quantity is called {pattern!r}", where="--columns", remedy=remedy)


def _facts(stage: str, result: Any) -> Told:
    for name, (value, unit) in facts(stage, result):
        yield _headed(f"{stage}.{name}", unit), value


def _columns(stage: str, result: Any, patterns: Sequence[str]) -> Told:
    for pattern in patterns:
        match = OF_COLUMN.fullmatch(pattern)
        if match and (match[1] or "*") in (stage, "*"):
            of: Any = match[2]
            for name, (value, unit) in of_columns(Constraint("", stage, column=match[3], of=of), result):
                yield _headed(f"{stage}.{of}({name})", unit), value


def _asks_facts(stage: str, patterns: Sequence[str]) -> bool:
    """Whether a fact of this stage may be meant: making its summary takes as long as many a stage."""
    if not patterns:
        return True
    from tmmcalc.rooms import STAGES

    named = [p.partition(".")[0] for p in patterns if not OF_COLUMN.fullmatch(p)]
    return any(fnmatchcase(stage, name) or name not in STAGES for name in named)


def _headed(name: str, unit: str) -> str:
    return f"{name}[{unit}]" if unit else name
