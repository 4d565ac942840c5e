"""``plan --why``: of every stage what decided, what would bring it in, whose results it reads, what it leaves out."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tmmcalc.pipeline.why import Why, in_toml, packages
from tmmcalc.report.document import Document, Fact, View

HEAVY = ("scipy", "joblib")


def why_document(reasons: Sequence[Why], spec: object, title: str) -> Document:
    """The stages that run, each under its name, then the others in a table."""
    running = [why for why in reasons if why.step.runs]
    loaded = packages(tuple(reasons))
    absent = [name for name in HEAVY if not any(each.startswith(name) for each in loaded)]
    facts = (
        Fact("stages that run", f"{len(running)} of {len(reasons)}", {"running": len(running), "all": len(reasons)}),
        Fact("heavy packages", ", ".join(loaded) or "none", {"packages": list(loaded)}),
        Fact("not imported", ", ".join(absent), {"not_imported": absent}),
    )
    parts = [Document(why.step.stage, tuple(_facts(why, spec))) for why in running]
    return Document(title, facts, parts=(*parts, _left_out([why for why in reasons if not why.step.runs], spec)))


def _facts(why: Why, spec: object) -> Iterator[Fact]:
    step = why.step
    yield Fact("runs", step.reason, {"runs": True, "reason": step.reason})
    yield Fact("decided by", _keys(why.decided, spec), {"decided_by": list(why.decided)})
    yield _tables(why)
    yield Fact("reads", ", ".join(why.reads) or "no other stage", {"reads": list(why.reads)})
    yield Fact("read by", ", ".join(why.readers) or "no other stage", {"read_by": list(why.readers)})
    if why.packages:
        yield Fact("imports", ", ".join(why.packages), {"packages": list(why.packages)})
    if why.omits:
        yield Fact("leaves out", "\n".join(why.omits), {"leaves_out": list(why.omits)})


def _tables(why: Why) -> Fact:
    """The tables that a stage reads, where that can be told before the spec is settled."""
    if why.tables is None:
        return Fact("spec tables", "told when the mechanism is found", {"tables": None})
    return Fact("spec tables", ", ".join(f"[{table}]" for table in why.tables) or "none", {"tables": list(why.tables)})


def _left_out(reasons: Sequence[Why], spec: object) -> Document:
    columns = [
        [why.step.stage for why in reasons],
        [why.step.reason for why in reasons],
        [_brings(why, spec) for why in reasons],
    ]
    return Document("left out", table=View(["stage", "why", "comes in with"], columns))


def _brings(why: Why, spec: object) -> str:
    """What would bring a stage in, as far as its own decision looked."""
    if why.brings:
        return _keys(why.brings, spec, " or ")
    if why.change is not None:
        return f"another value of {in_toml(why.change, spec)}"
    return f"stage {why.after}" if why.after is not None else ""


def _keys(keys: Sequence[str], spec: object, between: str = ", ") -> str:
    """The keys as they stand in TOML, those of one table together."""
    tables: dict[str, list[str]] = {}
    for name, _, table in (in_toml(key, spec).rpartition(" in ") for key in keys):
        tables.setdefault(table, []).append(name)
    told = (
        f"{joined} in {table}" if (joined := between.join(filter(None, names))) else table
        for table, names in tables.items()
    )
    return between.join(told) or "nothing of the spec"
