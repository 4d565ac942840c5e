"""Keys of JSON over the ready specs: within a document one quantity has one unit, and no quantity lacks its unit."""

from __future__ import annotations

import json
import re
import shutil
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from outputs_commands import COMMANDS, LENGTHY

import tmmcalc
from cli.conftest import CONFIGS, Cli
from tmmcalc.core.plan import plan

QUICK = ("rotor", "crane-luffing", "cam-oscillating")
NAMES = [path.stem for path in sorted(CONFIGS.glob("*.toml")) if path.stem not in LENGTHY]
SAME = ({"deg", "rad"}, {"m", "mm", "um"}, {"Pa", "MPa"}, {"N/m", "N/mm"}, {"rad/s", "rpm", "deg/s"}, {"s", "ms"})
IN_RADIANS = {
    "pair",
    "profile",
    "vibrator",
    "pendulum",
    "liner",
}  # stages whose documents tell angles in rad, others in deg
KEY = re.compile(r"(.*)\[([^\]]*)\]")
# input coordinate over the first phase by the textbook, and the coordinate of output 1
NAMESAKES = {"unsteady": {"S_1"}}
PLAIN = re.compile(  # what is a number and has no unit
    "|".join(
        (
            r"(.*\.)?(error|residual)(\..*)?|agreement\..*|.*_error|.*balance|.*\.(uniform|cosine)",
            r"constraint_.*|.*designs\.columns.*|.*function.*|check_.*|.*margin.*|.*\.ratio|weights\..*|rank.*|cost",
            r"K.*|options\.K1|C[avj]_.*|jerk_m.*_(rise|return)|s2_.*|k|k_.*|s_M_.*|power_max.*|.*_at_k.*|psi\d.*|.*\bjump",
            r"[xyuice]|x_?\d.*|x_min.*|x_sum|.*\.x(_.*)?|dy|h_a|rho|rho_t\*|.*\.Y_F.*|Y_F|z_min.*|.*\.z_min|.*\.s_na\d",
            r"inv_.*|.*_dms|eps.*|.*\.eps_.*|theta_?\d|lambda.*|.*\.theta_\d|points\..*|corners\..*|lines\..*|shift|C\d",
            r"eta.*|i|i_.*|.*_ratio.*|ratio.*|U.*|e_m.*|T1_ratio|mu.*|rolling_.*|efficiency|best_e.*|by_.*\.\d|beta\d",
            r"(judged|rounds)\..*|M_.*/.*|.*_rated|.*_factor|.*load|(.*[._])?delta.*|.*turns|.*\.explicit_steps|rim_safety|s_a_min|B_dphi_over_J",
            r"[\w/]+/[\w/]+|f\d|n|n_[xy]|defects|multiple|multipliers|zeta|modes|path_.*|tau\*|.*_change|crest",
            r"amplification_.*|D_.*|friction_part|mu|area_.*|pieces_.*|margins\..*|splits_.*|.*_straight_line",
            r"run-.*|cut_off.*|psi_\d|coefficients\.value|width_deviation|by_.*efficiency.*|.*omega_textbook_error",
            r"wheels\..*\.x|time_scales\..*|assembly",
            r"[rab]|beta|t0|t_a|mean_life|lives\..*|R_at\..*",  # reliability: times in the unit of the lives
            r"drive_line\.(u|eta)_part|last_digit\..*|springs\.n|regularity|safety|thresholds\.k_.*|use|worst\.(use|K.*)",
            r"(.*\.)?findings\.(value|limit)",  # factors; with a unit they have it
            r"saturation",
            r"[MCB]",  # matrices of a vibrating device, whose entries have units of their own
        )
    )
)


def entries(value: Any, path: str = "", inside: str = "") -> Iterator[tuple[str, str, bool]]:
    """Names of keys with their path, their unit, and whether a number that is not whole stands there.

    A table is a part of its document; what has a ``unit`` beside it has that one, what stands within has its parent's.
    """
    if isinstance(value, list):
        for k, each in enumerate(value):
            if isinstance(each, dict):
                yield from entries(each, f"{path}{k}.", inside)
    elif isinstance(value, dict):
        beside = value["unit"] if isinstance(value.get("unit"), str) else inside
        for key, held in value.items():
            found = KEY.fullmatch(key)
            name, unit = (found[1], found[2]) if found else (key, beside)
            if not isinstance(held, dict):
                yield f"{path}{name}", unit, numeric(held)
            yield from entries(held, path if key == "columns" else f"{path}{name}.", unit)


def numeric(value: Any) -> bool:
    if isinstance(value, list):
        return any(numeric(each) for each in value)
    return isinstance(value, float) and not value.is_integer()


def plain(key: str) -> str:
    """A key without the titles of the parts that it stands in, and without numbers of records."""
    return re.sub(r"(^|\.)\d+\.", r"\1", re.sub(r"^[^.]*[ :'][^.]*\.", "", key))


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[] if name in QUICK else [pytest.mark.slow]) for name in NAMES]
)
def test_one_quantity_has_one_unit_and_none_lacks_it(name: str, folder: Path, cli: Cli) -> None:
    for file in CONFIGS.glob("*.*"):
        shutil.copy(file, folder)
    for stage in plan(tmmcalc.load_spec(folder / f"{name}.toml")).running:
        if stage in COMMANDS:
            document = json.loads(cli(*COMMANDS[stage].split(), f"{name}.toml", "-f", "json", "-q").out)
            units: dict[str, set[str]] = defaultdict(set)
            bare = set()
            for key, unit, number in entries(document):
                if unit and unit not in "-1":
                    units[key].add(unit)
                elif number and not unit and not PLAIN.fullmatch(plain(key)):
                    bare.add(plain(key))
            assert bare == set(), stage
            assert {key for key, found in units.items() if len(found) > 1} - NAMESAKES.get(stage, set()) == set(), stage
            there = set().union(*units.values())
            assert "rad" not in there or stage in IN_RADIANS, stage
            assert [kinds & there for kinds in SAME if len(kinds & there) > 1] == [], stage


LIMIT = '[[constraints]]\nname = "low"\nstage = "unsteady"\nvalue = "S_1_end"\n'


@pytest.mark.parametrize("written", ['at_most = "1.2 rad"', 'at_most = "69 deg"', "at_least = 0"])
def test_limits_in_either_unit_and_0_are_compared(folder: Path, cli: Cli, written: str) -> None:
    luffing(folder, written)
    found = json.loads(cli("feasibility", "luffing.toml", "-f", "json", "-q").out)
    assert (found["columns"]["value"], found["columns"]["unit"]) == (["62.85885"], ["deg"])
    assert found["feasible"]


def test_a_limit_that_may_be_meant_in_the_unit_of_before_is_refused(folder: Path, cli: Cli) -> None:
    luffing(folder, "at_most = 1.2")
    code, _, err = cli("feasibility", "luffing.toml", "-q")
    assert code == 2
    assert "at_most = 1.2 has no unit, and S_1_end is told in deg now, where it was rad" in " ".join(err.split())
    assert 'at_most = "1.2 rad"' in err


def test_a_column_that_is_asked_for_in_the_unit_of_before(folder: Path, cli: Cli) -> None:
    shutil.copy(CONFIGS / "cam-oscillating.toml", folder)
    code, _, err = cli("cam", "law", "cam-oscillating.toml", "--columns", "dpsi[rad]", "-q")
    assert code == 2
    assert "dpsi[deg]" in err


def luffing(folder: Path, limit: str) -> None:
    text = (CONFIGS / "crane-luffing.toml").read_text(encoding="utf-8")
    (folder / "luffing.toml").write_text(f"{text}\n{LIMIT}{limit}\n", encoding="utf-8")
