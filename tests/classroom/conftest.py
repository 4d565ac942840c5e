"""A small class whose title, names and answers would break what does not take care."""

from __future__ import annotations

from pathlib import Path

import pytest

from classroom.school import School, school_in


@pytest.fixture(scope="session")
def school(tmp_path_factory: pytest.TempPathFactory) -> School:
    """Three variants of the shaper with their keys."""
    return school_in(Path(tmp_path_factory.mktemp("school")))
