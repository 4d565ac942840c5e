"""The ready specs, loaded once for all that choose their scenes by what stands in them."""

from __future__ import annotations

from pathlib import Path

from tmmcalc.project import Spec, load_spec

CONFIGS = Path(__file__).parents[1] / "configs"
NAMES = sorted(path.stem for path in CONFIGS.glob("*.toml"))
SPECS: dict[str, Spec] = {name: load_spec(CONFIGS / f"{name}.toml") for name in NAMES}
LINKAGES = [name for name, spec in SPECS.items() if spec.mechanism is not None]
