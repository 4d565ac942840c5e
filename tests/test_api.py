"""The public names: loaded late, each from its module, and the same for a type checker as for a program."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import tmmcalc

BEARING = Path(__file__).parents[1] / "configs" / "extra-bearing.toml"
STUB = Path(tmmcalc.__file__).with_name("__init__.pyi")


def declared() -> dict[str, str]:
    """Names of the stub with their modules."""
    body = ast.parse(STUB.read_text(encoding="utf-8")).body
    return {
        alias.asname or "": node.module or ""
        for node in body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }


def test_the_stub_has_the_public_names() -> None:
    assert sorted(declared()) == sorted(tmmcalc.__all__) == sorted(dir(tmmcalc))
    assert len({*tmmcalc.__all__}) == len(tmmcalc.__all__)


@pytest.mark.parametrize("name", tmmcalc.__all__)
def test_a_name_is_that_of_its_module(name: str) -> None:
    assert getattr(tmmcalc, name) is getattr(sys.modules[declared()[name]], name)


def test_a_name_that_is_not_there() -> None:
    with pytest.raises(AttributeError, match="module 'tmmcalc' has no attribute 'solve_everything'"):
        _ = tmmcalc.solve_everything


def test_nothing_is_loaded_before_it_is_used() -> None:
    code = "import sys; before = {*sys.modules}; import tmmcalc; print(*sorted({*sys.modules} - before))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert {*done.stdout.split()} == {"__future__", "tmmcalc", "tmmcalc._version"}


@pytest.mark.parametrize("path", [BEARING, str(BEARING)])
def test_a_run_takes_the_path_of_a_spec(path: str | Path, tmp_path: Path) -> None:
    found = tmmcalc.run(path, out=tmp_path)
    of_spec = tmmcalc.run(tmmcalc.load_spec(BEARING))
    assert found.value("bearing.BPFO") == of_spec.value("bearing.BPFO") > 0
    assert (tmp_path / "bearing.toml").exists()


def test_a_run_of_a_file_that_is_not_there() -> None:
    with pytest.raises(tmmcalc.UsageError, match=r"nowhere\.toml"):
        tmmcalc.run("nowhere.toml")
