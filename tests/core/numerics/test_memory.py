"""Temporaries keep their pages: counted by the system, in a process of its own that has freed nothing large before."""

from __future__ import annotations

import platform
import subprocess
import sys

import pytest
from sparing import sparing

COUNT = """
import resource
import numpy as np
from tmmcalc.core.numerics.memory import keep_pages
if {kept}:
    keep_pages()
def faults():
    before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
    for _ in range(20):
        blocks = [np.ones(1 << 17) for _ in range(8)]
        del blocks
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before
faults()
print(faults())
"""


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="the rule is that of the GNU C library")
@sparing(("kept", "least", "most"), [(True, 0, 200), (False, 2000, 10**6)], every=2)
def test_repeated_temporaries_fetch_no_pages(kept: bool, least: int, most: int) -> None:
    done = subprocess.run([sys.executable, "-c", COUNT.format(kept=kept)], capture_output=True, text=True, check=True)
    assert least <= int(done.stdout) <= most
