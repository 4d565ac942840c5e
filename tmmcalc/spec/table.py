"""The common base of all TOML tables of the spec.

The table modules leave out ``from __future__ import annotations``: pydantic would have to evaluate every
annotation from its text, a third of the time that it takes to build these classes.
"""

from pydantic import BaseModel, ConfigDict


class Table(BaseModel):
    """A table of the spec: unknown keys are faults, values keep their TOML type, nothing changes later."""

    # Building is deferred so that a start builds one validator, that of the root, not one a class.
    model_config = ConfigDict(extra="forbid", frozen=True, strict=True, defer_build=True)


TAGS = {"[key]"}  # what pydantic puts into the places of faults beside TOML keys


def tag(word: str) -> str:
    """A tag of one form of a value that has several, for a discriminator; the places of faults go without it.

    It stands in angle brackets, as no key of a spec does.
    """
    TAGS.add(f"<{word}>")
    return f"<{word}>"
