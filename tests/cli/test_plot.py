"""``tmmcalc plot``: stages, their own flags, what is refused."""

from __future__ import annotations

from pathlib import Path

import pytest
from sparing import sparing

from .conftest import Cli

pytest.importorskip("matplotlib")


@sparing(
    ("args", "said"),
    [
        (("reduction", "--polygons", "3"), "--polygons cannot be used with the picture of reduction"),
        (("forces", "--positions", "3"), "--positions cannot be used with the picture of forces"),
        (("forces", "--positions", "3"), "its own flags: --polygons"),
        (("reduction", "--positions", "1", "--polygons", "3"), "--positions and --polygons cannot be used"),
        (("force",), "pictures: synthesis, kinematics, forces, reduction"),
        (("forces", "--polygons", "1:3"), "names 3 positions"),
        (("forces", "--polygons", "77"), "no position is called '77'"),
        (("kinematics", "--polygons", "77"), "no position is called '77'"),
    ],
    every=4,
)
def test_what_does_not_belong_is_refused(cli: Cli, args: tuple[str, ...], said: str) -> None:
    code, out, err = cli("plot", "my.toml", *args)
    assert (code, out) == (2, "")
    assert said in err
    assert not list(Path().glob("*.svg"))


def test_a_scene_without_loads_has_no_forces_to_draw(cli: Cli) -> None:
    text = Path("my.toml").read_text()
    bare = "\n".join(line for line in text.splitlines() if not line.startswith(("mass", "inertia", "center")))
    Path("bare.toml").write_text(bare)
    code, out, err = cli("plot", "bare.toml", "forces")
    assert (code, out) == (2, "")
    assert "nothing acts on the links" in err


@sparing("stage", ["kinematics", "forces", "reduction"], every=3)
def test_stages_that_the_shaper_has_are_drawn(cli: Cli, stage: str) -> None:
    assert cli("plot", "my.toml", stage, "-o", f"{stage}.svg", "-q") == (0, "", "")
    assert Path(f"{stage}.svg").read_bytes().startswith(b"<?xml")
    assert not Path("my.out").exists()


def test_the_help_tells_every_picture() -> None:
    from tmmcalc.cli.plot import PICTURES, command

    told = command.__doc__ or ""
    assert {"cam_law", "cam_elastic", "indexing"} <= {*PICTURES}
    assert [stage for stage in PICTURES if f"\n{stage}  " not in told] == []
