"""Every kind of fault in [train]: its place, its words, what to write instead."""

from __future__ import annotations

import pytest
from faults import HOSTILE, check_fault
from project.scenes import CONFIGS, TRAIN

from tmmcalc.core.errors import Fault, NoSolutionError, SpecError
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec, parse_spec

AI = '[train]\nlayout = "AI"\n'
RADIAL = '[train]\nlayout = "2A-AA"\nratio = 5\nradial = '
UNFOLDED = '[train]\nlayout = "unfolded2"\nratio = "8.15"\n'

# the whole spec; then the path of its one fault, a piece of its message and of its remedy
FAULTS = [
    ("[train]\nratio = 8\n", "train.layout", "missing key: a train has its layout", 'layout = "AI"'),
    ('[train]\nlayout = "coaxal"\nratio = 8\n', "train.layout", "'coaxal' is no layout", 'did you mean "coaxial"'),
    ('[train]\nlayout = ["AI", "AI"]\nratio = 8\n', "train.layout", "'AI' is named twice", "remove"),
    ("[train]\nlayout = []\nratio = 8\n", "train.layout", "empty list", "one value"),
    (AI, "train", "missing key: a train has its ratio", 'ratio = "8.15"'),
    (AI + "ratio = 0\n", "train.ratio", "other than 0", "such as"),
    (AI + 'ratio = "8.15 %"\n', "train.ratio", "is not a ratio", "such as"),
    (AI + "ratio = nan\n", "train.ratio", "is not a ratio", "such as"),
    (AI + 'ratio = "8/0"\n', "train.ratio", "not a finite number", "such as"),
    (AI + "ratio = 0.9\n", "train.ratio", "i_1H = 1 + U is above 1", "another layout"),
    ('[train]\nlayout = "AA"\nratio = 7\n', "train.ratio", "i_1H = 1 - U is below 1", "i_H1"),
    ('[train]\nlayout = "AA"\nratio_kind = "i_H1"\nratio = 0.5\n', "train.ratio", "i_H1 = 1/(1 - U)", "layout"),
    ('[train]\nlayout = "coaxial"\nratio = 1\n', "train.ratio", "a reducer is above 1", "another ratio"),
    ('[train]\nlayout = "unfolded2"\nratio = -8\n', "train.ratio", "a reducer is above 1", "another ratio"),
    (AI + 'ratio = 8\nratio_kind = "i_14"\n', "train.ratio_kind", "AI has no ratio i_14", '"i_1H", "i_H1", "u"'),
    (AI + 'ratio = 8\nratio_kind = "i1H"\n', "train.ratio_kind", "is not allowed here", '"i_1H"'),
    (AI + 'ratio = 8\ninput_speed = "1450 rpm"\n', "train.ratio", "ratio together with input_speed", "remove one"),
    (AI + 'input_speed = "1450 rpm"\n', "train", "missing key: a train has its ratio", "output_speed"),
    (
        '[train]\nlayout = "coaxial"\ninput_speed = "1450 rpm"\noutput_speed = "-178 rpm"\n',
        "train.output_speed",
        "the output of layout coaxial turns the same way as the input",
        "change the sign",
    ),
    (
        AI + 'input_speed = "1450 rpm"\noutput_speed = "-178 rpm"\n',
        "train.output_speed",
        "cannot have the ratio -8.14607",
        "layout",
    ),
    (AI + "ratio = 8\ntolerance = -0.01\n", "train.tolerance", "a tolerance is at least 0", "0.01"),
    (AI + 'ratio = 8\ntolerance = "100 %"\n', "train.tolerance", "100 % or more", "1 %"),
    (AI + 'ratio = 8\ntolerance = 8\ntolerance_kind = "absolute"\n', "train.tolerance", "as large as", "smaller"),
    (AI + 'ratio = 8\ntolerance = "1 %"\ntolerance_kind = "absolute"\n', "train.tolerance", "relative", "remove"),
    (AI + "ratio = 8\nradial = { y = 1.2 }\n", "train.radial", "of no use to layout AI", "remove it"),
    (RADIAL + "{ y = 0 }\n", "train.radial.y", "a ratio is above 0", "1.2"),
    (RADIAL + '{ mesh_angles = ["20 deg", "21 deg"] }\n', "train.radial.mesh_angles", "list of 3", "22 deg"),
    (RADIAL + '{ mesh_angles = ["20 deg", "50 deg", "20 deg"] }\n', "train.radial.mesh_angles", "10 and 44", "22 deg"),
    (
        RADIAL + '{ t1 = 1.1, mesh_angles = ["20 deg", "21 deg", "20 deg"] }\n',
        "train.radial.mesh_angles",
        "mesh_angles together with t1",
        "remove one",
    ),
    (AI + "ratio = 8\nplanets = 0\n", "train.planets", "between 1 and 12", "between 1 and 12"),
    (AI + "ratio = 8\nplanets = [3, 3]\n", "train.planets", "3 is named twice", "remove"),
    (AI + "ratio = 8\nz_min = 160\n", "train.z_min", "z_min = 160 leaves no number of teeth with z_max = 150", "first"),
    (AI + "ratio = 8\nring_max = 30\n", "train.ring_max", "with ring_min = 40", "first"),
    (UNFOLDED + "z_min = 30\n", "train.z_min", "with z_pinion_max = 25", "first"),
    (AI + "ratio = 8\nz_min = 5\n", "train.z_min", "less than 6", "6 or more"),
    (AI + "ratio = 8\nmodule_ratios = [[2, 0]]\n", "train.module_ratios", "above 0", "such as 2"),
    (AI + "ratio = 8\nmodule_ratios = [2, 3]\n", "train.module_ratios", "not a list of 2 values", "[2, 3]"),
    (AI + "ratio = 8\nmodule_ratio_range = [2, 1]\n", "train.module_ratio_range", "runs backwards", "smaller"),
    (AI + 'ratio = 8\nmodules = ["2 mm"]\n', "train.modules", "has 1 value", "3.5 mm"),
    (
        AI + 'ratio = 8\nmodules = ["2 mm", "3 mm"]\nmodule_ratios = [[2, 3]]\n',
        "train.modules",
        "module_ratios and modules together",
        "keep one",
    ),
    (AI + 'ratio = 8\nmodules = ["2 mm", "3 mm"]\nmodule = "2 mm"\n', "train.module", "with modules", "remove"),
    (UNFOLDED + "planets = 3\n", "train.planets", "of no use to layout unfolded2", "remove it"),
    (AI + "ratio = 8\nz_pinion_max = 20\n", "train.z_pinion_max", "of no use to layout AI", "remove it"),
    (
        '[train]\nlayout = "AIbar"\nratio = 8\nmodule_ratios = [[2, 3]]\n',
        "train.module_ratios",
        "of no use to layout AIbar",
        "remove it",
    ),
    (
        UNFOLDED + "constraints = { ring_difference = 5 }\n",
        "train.constraints.ring_difference",
        "it has no internal wheels",
        "remove it",
    ),
    ('[train]\nlayout = "II"\nratio = 0.5\nmethod = "textbook"\n', "train.method", "no program for layout II", "AIbar"),
    (
        AI + 'ratio = 8\nmethod = "textbook"\nconstraints = { mesh_angle_max = "24 deg" }\n',
        "train.constraints.mesh_angle_max",
        "reference centre distance alone",
        "remove",
    ),
    (
        AI + 'ratio = 8\nconstraints = { mesh_angle_max = "19 deg" }\n',
        "train.constraints.mesh_angle_max",
        "between the angle of the rack, 20 deg, and 44 deg",
        "26 deg",
    ),
    (AI + 'ratio = 8\npressure_angle = "5 deg"\n', "train.pressure_angle", "no pressure angle", "20 deg"),
    (
        AI + 'ratio = 8\nconstraints = { centre_distance = ["80 mm", "120 mm"] }\n',
        "train.constraints.centre_distance",
        "without a module",
        'module = "2 mm"',
    ),
    (
        AI + 'ratio = 8\nmodule = 0.002\nconstraints = { centre_distance = ["90 mm", "80 mm"] }\n',
        "train.constraints.centre_distance",
        "runs backwards",
        "smaller",
    ),
    (
        AI + "ratio = 8\nmodule = 0.002\nconstraints = { envelope = true }\n",
        "train.constraints.envelope",
        "not a length",
        "or false",
    ),
    (AI + "ratio = 8\nconstraints = { gap = 1 }\n", "train.constraints.gap", "unknown key", "adjacency_gap"),
]


@pytest.mark.parametrize(("text", "path", "message", "remedy"), FAULTS, ids=[str(k) for k in range(len(FAULTS))])
def test_faults(text: str, path: str, message: str, remedy: str) -> None:
    check_fault(text, path, message, remedy)


def check_places(text: str) -> None:
    """A spec is read, or refused with faults of the train alone."""
    faults: list[Fault] = []
    try:
        parse_spec(text)
    except SpecError as error:
        faults = error.faults
    assert all(fault.path.startswith("train") for fault in faults)


KEYS = ["layout", "ratio", "ratio_kind", "input_speed", "tolerance", "planets", "module_ratios", "modules", "z_min"]
KEYS += ["module_ratio_range", "keep", "pressure_angle", "addendum", "constraints", "method", "ring_max"]


@pytest.mark.parametrize("key", KEYS)
@pytest.mark.parametrize("value", HOSTILE)
def test_hostile_values_are_faults_and_nothing_else(key: str, value: str) -> None:
    lines = {"layout": '"AI"', "ratio": "8", key: value}
    text = "[train]\n" + "".join(f"{name} = {each}\n" for name, each in lines.items())
    check_places(text)


CONSTRAINTS = ["mesh_angle_max", "adjacency_gap", "ring_difference", "stage_ratio_max", "centre_distance", "undercut"]


@pytest.mark.parametrize("key", CONSTRAINTS)
@pytest.mark.parametrize("value", HOSTILE)
def test_hostile_constraints_are_faults_and_nothing_else(key: str, value: str) -> None:
    check_places(f'[train]\nlayout = "AI"\nratio = 8\n[train.constraints]\n{key} = {value}\n')


def test_a_train_stands_alone_and_beside_anything(shaper: str) -> None:
    for text in (TRAIN, shaper + TRAIN):
        train = parse_spec(text).train
        assert train is not None
        assert train.layout == ["AI", "AIbar"]
        assert train.constraints.envelope is False


def test_modules_are_in_a_ratio_of_whole_numbers() -> None:
    text = (CONFIGS / "gears-coaxial.toml").read_text("utf-8")
    check_fault(
        text.replace("[[2, 3]]", "[[2, 1e-13]]"),
        "train.module_ratios[0]",
        "[2, 1e-13] is no ratio of whole numbers up to 1000000000000",
        "fewer digits",
    )


@pytest.mark.parametrize("ratio", ["[1000000, 3]", "[3, 1000000]", "[2, 1e-6]"])
@pytest.mark.parametrize("name", ["gears-coaxial", "gears-three-centrals", "gears-double-planets"])
def test_modules_far_apart_leave_no_tooth_set(name: str, ratio: str) -> None:
    spec = load_spec(CONFIGS / f"{name}.toml", (f"train.module_ratios=[{ratio}]",))
    with pytest.raises(NoSolutionError, match="no tooth set"):
        run(spec, target="train")
