"""The faults of [strength] and [criteria] in a whole spec: place, words, remedy; what the tables become."""

from __future__ import annotations

import pytest
from faults import HOSTILE, check_fault, check_lines

from tmmcalc.gears.criteria.efficiency import MeshEfficiency
from tmmcalc.gears.selection.task import SelectionTask
from tmmcalc.gears.tables.tasks.sizing import to_selection, to_sizing
from tmmcalc.project import parse_spec

TRAIN = '[train]\nlayout = "AI"\nratio = "31.29"\n'
STEEL = 'material = { steel = "40Kh", treatment = "improved", hardness = "300 HB" }\n'
STRENGTH = f'[strength]\ntorque = "75 N*m"\n{STEEL}'
WHOLE = f"{TRAIN}{STRENGTH}[criteria]\n"

FAULTS = [
    (f"[torque]\nspeed = 1\nformula = '1'\n{STRENGTH}", "strength", "without [train]", "add [train]"),
    (f"{TRAIN}[criteria]\n", "criteria", "without [strength]: trains are compared by their sizes", "torque and"),
    (TRAIN + STRENGTH.replace('torque = "75 N*m"\n', ""), "strength", "missing key: the torque on wheel 1", "torque ="),
    (f"{TRAIN}[strength]\ntorque = 75\n", "strength", "missing key: the material of the wheels", "strength.material"),
    (
        TRAIN + STRENGTH + "moment = 3\n",
        "strength.moment",
        "torque together with moment: the torque on wheel 1 is the moment over the ratio",
        "remove moment",
    ),
    (f'{WHOLE}objectives = ["mass", "inertai"]\n', "criteria.objectives", "'inertai' is no criterion", '"inertia"'),
    (f"{WHOLE}objectives = []\n", "criteria.objectives", "empty list", "one value"),
    (f'{WHOLE}choose = "sice"\n', "criteria.choose", "does not say which train", 'did you mean "size"?'),
    (f"{WHOLE}choose = -1\n", "criteria.choose", "-1 does not say which train", "rows of criteria.csv"),
    (f"{WHOLE}choose = 0\n", "criteria.choose", "0 does not say which train", "from 1"),
    (f"{WHOLE}choose = true\n", "criteria.choose", "does not say which train", "criteria.csv"),
    (f"{WHOLE}weights = {{ mas = 1 }}\n", "criteria.weights.mas", "unknown key", '"mass"'),
    (f"{WHOLE}weights = {{ mass = -1 }}\n", "criteria.weights.mass", "a weight is at least 0", "such as 2"),
    (f"{WHOLE}weights = {{ mass = 0 }}\n", "criteria.weights", "all weights are 0", "mass = 1"),
    (f"{WHOLE}weights = {{}}\n", "criteria.weights", "weights without a criterion", "mass = 1"),
    (f"{WHOLE}external_efficiency = 1.2\n", "criteria.external_efficiency", "out of range", "such as 0.97"),
    (
        WHOLE.replace("torque", "module = 0.002\ntorque") + "series = true\n",
        "criteria.series",
        "series together with [strength] module",
        "remove module",
    ),
]


@pytest.mark.parametrize(("text", "path", "message", "remedy"), FAULTS)
def test_faults(text: str, path: str, message: str, remedy: str) -> None:
    check_fault(text, path, message, remedy)


def test_the_whole_tables() -> None:
    text = (
        f'{WHOLE}objectives = ["size", "error"]\nweights = {{ error = 2, size = 1, mass = 0 }}\nchoose = "weighted"\n'
        "external_efficiency = 0.98\nseries = true\n"
    )
    found = to_selection(parse_spec(text))
    assert found == SelectionTask(
        ("size", "error"), (("size", 1.0), ("error", 2.0)), "weighted", MeshEfficiency(0.98, 0.985), True
    )
    assert found.compared == ("size", "error")
    assert SelectionTask(choose="efficiency").compared == ("mass", "inertia", "size", "efficiency")


def test_without_a_table() -> None:
    spec = parse_spec(TRAIN + STRENGTH)
    assert to_selection(spec) == SelectionTask()
    sizing = to_sizing(spec)
    assert (sizing.torque, sizing.moment, sizing.ratio, sizing.strength.torque) == (75.0, None, None, 75.0)
    moment = to_sizing(parse_spec(TRAIN + STRENGTH.replace('torque = "75 N*m"', "moment = -90\nmoment_ratio = 3")))
    assert (moment.torque, moment.moment, moment.ratio) == (None, 90.0, 3.0)


@pytest.mark.parametrize("value", HOSTILE)
@pytest.mark.parametrize("key", ["objectives", "weights", "choose", "external_efficiency", "series"])
def test_any_value_is_read_or_refused_with_a_line(key: str, value: str) -> None:
    check_lines(f"{WHOLE}{key} = {value}\n")
