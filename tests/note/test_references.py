"""Every figure and table of every chapter is named by a text before it."""

from __future__ import annotations

import pytest

from note.naming import unnamed
from note.scenes import SPECS, chapters

QUICK = ("shaper", "press", "class-four", "v-engine", "manipulator", "extra-contact", "pendulum-rotor")


@pytest.mark.parametrize("name", [pytest.param(n, marks=() if n in QUICK else pytest.mark.slow) for n in SPECS])
def test_every_figure_and_table_is_named_before_it(name: str) -> None:
    assert not [found for chapter in chapters(name) for found in unnamed(chapter.blocks)]
