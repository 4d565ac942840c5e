"""Laws of one's own in [cam]: by points, accelerations, coefficients and files; faults of the files."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from cams.tables.camscenes import DEGREE, FOLLOWER, MOTION, cam, law_names, own
from tmmcalc.cams.laws.catalogue import LAWS, law_of
from tmmcalc.cams.tables.tasks.cam import to_cam
from tmmcalc.cams.task import CamTask
from tmmcalc.core.errors import SpecError
from tmmcalc.project import load_spec
from tmmcalc.project.files import named_files


def values(task: CamTask, phase: int = 0) -> np.ndarray:
    law = task.program.phases[phase].law
    assert law is not None
    return law.at(np.linspace(0, 1, 41))


def test_a_polynomial_of_ones_own() -> None:
    for scale in (1.0, 1e6, 0.003):
        found = own(f"polynomial = [0, 0, {3 * scale}, {-2 * scale}]")
        assert values(found) == pytest.approx(LAWS["linear"].at(np.linspace(0, 1, 41)), abs=1e-12)
        assert law_names(found) == ["polynomial"] * 2


@pytest.mark.parametrize(
    "points",
    [
        "[[0, 1], [0.5, 1], [0.5, -1], [1, -1]]",
        "[[0, 7], [20, 7], [20, -7], [40, -7]]",
        '[[0, 1], ["30 deg", 1], ["30 deg", -1], ["60 deg", -1]]',
    ],
)
def test_an_acceleration_of_ones_own(points: str) -> None:
    found = values(own(f"acceleration = {points}"))
    assert found[:2] == pytest.approx(LAWS["const"].at(np.linspace(0, 1, 41))[:2], abs=1e-14)


def points_of(name: str, count: int, k: float = 1.0, s: float = 1.0) -> list[tuple[float, float]]:
    parts = np.linspace(0, 1, count)
    return [(float(k * a), float(s * b)) for a, b in zip(parts, law_of(name).at(parts)[0], strict=True)]


@pytest.mark.parametrize(
    ("k", "s", "k_unit", "s_unit"), [(1, 1, "", ""), (60, 30, "deg", "mm"), (1.5, 0.2, "rad", "rad")]
)
def test_points_of_the_3_4_5_polynomial_give_it_back(k: float, s: float, k_unit: str, s_unit: str) -> None:
    """A spline of the fifth degree holds that polynomial exactly, whatever the scale of its points."""

    def put(value: float, unit: str) -> str:
        return f'"{value!r} {unit}"' if unit else repr(value)

    points = ", ".join(f"[{put(a, k_unit)}, {put(b, s_unit)}]" for a, b in points_of("shun", 9, k, s))
    assert values(own(f"points = [{points}]")) == pytest.approx(LAWS["shun"].at(np.linspace(0, 1, 41)), abs=1e-9)


def test_a_file_is_the_same_as_its_points(tmp_path: Path) -> None:
    points = points_of("shun", 7, 60, 30)
    motion = MOTION.replace('"sine"', '{ file = "law.csv" }')
    (tmp_path / "spec.toml").write_text(f"[cam]\n{FOLLOWER['RT']}{motion}")
    found = []
    for header, k, s in (
        ("phi[deg],s[mm]", 1, 1),
        ("k,s", 1 / 60, 1 / 30),
        ("phi[rad],psi[deg]", DEGREE, 5),
        ("i\th[-]", 1, 1),
    ):
        sign = "\t" if "\t" in header else ","
        rows = "\n".join(f"{a * k!r}{sign}{b * s!r}" for a, b in points)
        (tmp_path / "law.csv").write_text(f"# measured\n{header}\n{rows}\n")
        spec = load_spec(tmp_path / "spec.toml")
        found.append(to_cam(spec))
        assert named_files(spec, tmp_path) == [tmp_path / "law.csv"]
    for task in found:
        assert values(task) == pytest.approx(LAWS["shun"].at(np.linspace(0, 1, 41)), abs=1e-9)
        assert law_names(task) == ["law.csv"] * 2
    inside = own(f"points = {[[*point] for point in points]}")
    assert values(found[0]) == pytest.approx(values(inside), rel=1e-12, abs=1e-11)


PARTS = [(k, s) for k, s in zip(np.linspace(0, 1, 9), LAWS["shun"].at(np.linspace(0, 1, 9))[0], strict=True)]
COLUMNS = {
    "swapped": ("s,k", [(s, k) for k, s in PARTS], "shun"),
    "swapped with units": ("S[mm],phi[deg]", [(30 * s, 60 * k) for k, s in PARTS], "shun"),
    "no header": (None, PARTS, "shun"),
    "acceleration": ("k,a", [(0, 7), (0.5, 7), (0.5, -7), (1, -7)], "const"),
    "acceleration first": ("s'',phi[deg]", [(1, 0), (1, 30), (-1, 30), (-1, 60)], "const"),
}


@pytest.mark.parametrize("name", COLUMNS)
def test_columns_of_a_file_go_by_their_names(folder: Callable[[str, str], Path], name: str) -> None:
    header, rows, law = COLUMNS[name]
    lines = [*([header] if header else []), *(f"{float(a)!r},{float(b)!r}" for a, b in rows)]
    found = values(to_cam(load_spec(folder(OWN, "\n".join(lines)))))
    parts = np.linspace(0, 1, 41)
    assert found[:2] == pytest.approx(LAWS[law].at(parts)[:2], abs=1e-9)


@pytest.mark.parametrize("kind", ["acceleration = [[0, 1], [1, -1]]", "polynomial = [0, 0, 3, -2]"])
def test_a_file_beside_a_law_in_the_spec(folder: Callable[[str, str], Path], kind: str) -> None:
    with pytest.raises(SpecError) as caught:
        load_spec(folder(OWN.replace("{ file", f"{{ {kind}, file"), "k,s\n0,0\n1,1\n"))
    (fault,) = caught.value.faults
    assert f"{kind.split()[0]} and file together" in fault.message


def test_the_return_runs_its_law_backwards() -> None:
    task = cam(motion=MOTION.replace("law =", "return_law = { points = [[0, 0], [0.3, 0.1], [1, 1]] }\nrise_law ="))
    assert task.program.at(np.array([180 - 0.3 * 90]) * DEGREE)[0, 0] == pytest.approx(0.003, abs=1e-15)


@pytest.fixture
def folder(tmp_path: Path) -> Callable[[str, str], Path]:
    """Write a spec and the file q.csv that it names; return the spec's place."""

    def write(text: str, content: str) -> Path:
        (tmp_path / "q.csv").write_text(content)
        (tmp_path / "spec.toml").write_text(text)
        return tmp_path / "spec.toml"

    return write


OWN = f"[cam]\n{FOLLOWER['RT']}{MOTION}".replace('"sine"', '{ file = "q.csv" }')
FORCES = f'[cam]\n{FOLLOWER["RT"]}{MOTION}speed = 10\n[cam.loads]\nforce_table = {{ file = "q.csv" }}\n'
FILES = [
    (OWN, "k,s\n0,0\n", "cam.law.file", "q.csv, line 1: fewer than two rows", "one row"),
    (OWN, "k\n0\n1\n", "cam.law.file", "q.csv, line 1: 1 column; a table of a law of motion has two, k and", "k,s"),
    (OWN, "k[mm],s\n0,0\n1,1\n", "cam.law.file", "'k[mm]' is not a column of angles with its unit, or of", "k,s"),
    (OWN, "k,s[N]\n0,0\n1,1\n", "cam.law.file", "'s[N]' is not a column of lengths or angles", "phi[deg],s[mm]"),
    (OWN, "k,v\n0,0\n1,1\n", "cam.law.file", "line 1: the columns are 'k' and 'v'; a law of motion has", "k and s"),
    (OWN, "s,h\n0,0\n1,1\n", "cam.law.file", "line 1: the columns are 's' and 'h'; a law of motion has", "k and s"),
    (OWN, "k,a[mm]\n0,1\n1,-1\n", "cam.law.file", "'a[mm]' has a unit; accelerations are to any scale", "such as a"),
    (OWN, "k,a\n0,1\n1,0\n", "cam.law.file", "cannot move a follower: its acceleration does not add up", "equal"),
    (OWN, "0,2;0\n1;1\n", "cam.law.file", "q.csv, line 1: '0,2' is not a number", "0.2"),
    (OWN, "0.2,0\n1,1\n", "cam.law.file", "q.csv, line 1: k begins at 0.2", "beginning of the phase"),
    (OWN, "k[parts],s\n0,0\n1,1\n", "cam.law.file", "'k[parts]' is not a column", "k,s"),
    (OWN, "k,s\n0,0\n0.5,x\n1,1\n", "cam.law.file", "q.csv, line 3: 'x' is not a number", "without its unit"),
    (OWN, "k,s\n0,0\n0.5;1\n", "cam.law.file", "q.csv, line 3: 1 value in a table of two columns", "x, value"),
    (OWN, "k,s\n0,0\n0.6,0.5\n# a remark\n0.5,1\n", "cam.law.file", "q.csv, line 5: 0.5 does not come after", "order"),
    (OWN, "k,s\n0.2,0\n1,1\n", "cam.law.file", "q.csv, line 2: k begins at 0.2", "beginning of the phase"),
    (OWN, "k,s\n0,1\n1,2\n", "cam.law.file", "the law 'q.csv' cannot move a follower: s runs from 1 to 2", "from 0"),
    (FORCES, "phi[deg],M[N*m]\n0,1\n9,2\n", "cam.loads.force_table.file", "on which a force acts", "write force"),
    (FORCES, "phi,Q[N]\n0,1\n9,2\n", "cam.loads.force_table.file", "'phi' is not a column of angles", "phi[deg]"),
    (
        FORCES,
        "phi[deg],Q[N]\n0,1\n20,1\n10,2\n",
        "cam.loads.force_table.file",
        "q.csv, line 4: 10 deg does not come after 20 deg",
        "in order",
    ),
    (FORCES, "phi[deg],Q[N]\n0,1\n380,2\n", "cam.loads.force_table.file", "line 3: 380 deg is more than", "360"),
]


@pytest.mark.parametrize(("text", "content", "path", "message", "remedy"), FILES)
def test_faults_of_files(
    folder: Callable[[str, str], Path], text: str, content: str, path: str, message: str, remedy: str
) -> None:
    with pytest.raises(SpecError) as caught:
        load_spec(folder(text, content))
    (fault,) = caught.value.faults
    assert fault.path == path
    assert message in fault.message
    assert remedy in fault.remedy
