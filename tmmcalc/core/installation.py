"""How the program was installed, and so the command that adds a package which it lacks."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

NAME = "tmmcalc"


def install(extra: str) -> str:
    """The command that adds the packages of an extra to this installation."""
    from importlib.metadata import PackageNotFoundError, distribution  # late: only a missing package needs it

    source = Path(__file__).resolve().parents[2]
    checkout = source if (source / "pyproject.toml").is_file() else None
    installer, url = "pip", {}
    try:
        own = distribution(NAME)
        installer = (own.read_text("INSTALLER") or "pip").strip()
        url = json.loads(own.read_text("direct_url.json") or "{}")
    except (PackageNotFoundError, OSError, ValueError):
        pass  # run from its files alone
    return command_of(extra, Path(sys.prefix), checkout, installer, url)


def command_of(extra: str, prefix: Path, checkout: Path | None, installer: str, url: Mapping[str, Any]) -> str:
    """The command for a program in the environment ``prefix``.

    ``checkout``: the folder of its sources, if it runs from there. ``installer`` and ``url`` are what the installation
    itself says (PEP 376 and 610): who made it, and from where if not from an index.

    >>> command_of("plot", Path("/usr"), None, "pip", {})
    'pip install "tmmcalc[plot]"'
    """
    if checkout is not None:
        what = f'--editable "{checkout}[{extra}]"'
    elif "url" in url:
        version = url.get("vcs_info", {})
        scheme, at = (f"{version['vcs']}+", f"@{version['commit_id']}") if version else ("", "")
        what = f'"{NAME}[{extra}] @ {scheme}{url["url"]}{at}"'
    else:
        what = f'"{NAME}[{extra}]"'
    if (prefix / "pipx_metadata.json").is_file():
        return f"pipx install --force {what}"
    if (prefix / "uv-receipt.toml").is_file():
        return f"uv tool install --force {what}"
    return f"{'uv pip' if installer == 'uv' else _pip(prefix)} install {what}"


def _pip(prefix: Path) -> str:
    """The pip of this environment: where it is not the active one, the bare word is that of another."""
    own = (prefix / "pyvenv.cfg").is_file()
    return f'"{sys.executable}" -m pip' if own and os.environ.get("VIRTUAL_ENV") != str(prefix) else "pip"
