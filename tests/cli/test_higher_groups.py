"""``tmmcalc structure --assemblies`` and ``tmmcalc kinematics --method splitting`` through the command line."""

from __future__ import annotations

import json

from .conftest import CONFIGS, Cli

CLASS_FOUR = str(CONFIGS / "class-four.toml")
SHAPER = str(CONFIGS / "shaper.toml")
QUIET = ("--no-store", "-q")


def test_assemblies_as_a_table(cli: Cli) -> None:
    code, out, err = cli("structure", CLASS_FOUR, "--assemblies", *QUIET)
    assert (code, err) == (0, "")
    assert "assemblies               IV(2,3,4,5) 2\n" in out
    rows = [line.split() for line in out.splitlines() if line.startswith("IV(2,3,4,5)")]
    assert [row[1] for row in rows] == ["1", "2"]
    assert [row[2] == "*" for row in rows] == [True, False]


def test_assemblies_of_dyads(cli: Cli) -> None:
    code, out, _ = cli("structure", SHAPER, "--assemblies", *QUIET)
    assert code == 0
    assert "RPR(2,3)" in out


def test_splitting_beside_the_exact_values(cli: Cli) -> None:
    code, out, err = cli("kinematics", CLASS_FOUR, "--method", "splitting", "--compare", "-f", "json", *QUIET)
    assert (code, err) == (0, "")
    differences = [value for key, value in _numbers(json.loads(out)) if key.startswith("difference_") and "_max" in key]
    assert len(differences) == 2
    assert max(differences) < 1e-10


def test_splitting_of_dyads_is_refused(cli: Cli) -> None:
    code, _, err = cli("kinematics", SHAPER, "--method", "splitting", *QUIET)
    assert code == 2
    assert "all groups are dyads: there is nothing to split" in err


def _numbers(value: object) -> list[tuple[str, float]]:
    """All named numbers, however deep."""
    found = []
    if isinstance(value, dict):
        for key, part in value.items():
            found += [(key, float(part))] if isinstance(part, int | float) else _numbers(part)
    return found
