"""Random cams over what users ask for: from a micrometre to a metre, easy and hard, of every kind."""

from __future__ import annotations

from math import radians

import numpy as np
from bounding import FLOOR

from cams.exact import SCENES, judge, random_program
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.task import AngleLimits, Asked, CamTask
from tmmcalc.core.errors import NoSolutionError, SingularityError

KINDS = ("translating", "oscillating", "flat")


def random_follower(random, kind, stroke=0.01):
    """Sizes of the order of the stroke (of a rocker of its arm), from slender to near the level of the axis."""
    size = stroke * 10 ** random.uniform(-0.3, 1.0)
    sense = int(random.choice([-1, 1]))
    if kind == "translating":
        offset = random.uniform(-0.8, 0.8) * size * (random.random() < 0.7)
        return Follower(kind, size, offset, size * random.choice([0.0, 0.1, 0.4, 1.2]), sense=sense)
    if kind == "flat":
        return Follower(kind, size, sense=sense)
    centres = 10 ** random.uniform(-3, 0)
    rocker = centres * random.uniform(0.5, 0.95)
    roller = rocker * random.choice([0.0, 0.1, 0.5])
    return Follower(kind, random.uniform(0.3, 1.2), 0.0, roller, centres, rocker, int(random.choice([-1, 1])), sense)


def random_cam(random, kind, rows=(5, 40), **given):
    """A task with its follower."""
    stroke = random.uniform(0.05, 0.6) if kind == "oscillating" else 10 ** random.uniform(-5, -0.5)
    follower = random_follower(random, kind, stroke)
    limits = AngleLimits(radians(random.uniform(15, 50)), radians(random.uniform(15, 60)))
    tool = None if kind == "flat" else (follower.roller or 0.1 * stroke) * random.uniform(0.2, 0.9)
    asked = Asked(kind, follower.sense, report_faults=True, tool=tool, assembly=follower.assembly)
    return CamTask(random_program(random, stroke), asked, limits, int(random.integers(*rows)), **given), follower


def some(random, n, rows=24):
    """Numbers of some rows."""
    return np.sort(random.permutation(n)[:rows])


def briefly(scene, seed, scenes):
    """Check that all estimates are bounds in a few scenes."""
    random, seen = np.random.default_rng(seed), 0
    while seen < scenes:
        try:
            found = scene(random)
        except (NoSolutionError, SingularityError):
            continue
        seen += 1
        for name, (estimate, true) in found.items():
            assert estimate >= max(true, FLOOR), name


def judged(scene, seed, scenes=SCENES, tries=20):
    """Judge estimates by random scenes until every quantity has enough: ``scene(random)`` gives name: (estimate, true).

    A scene that is refused gives nothing. Tells the share of scenes that are.
    """
    random, pairs, seen, refused = np.random.default_rng(seed), {}, 0, 0
    while seen < scenes or (seen < tries * scenes and min(map(len, pairs.values())) < scenes):
        try:
            found = scene(random)
        except (NoSolutionError, SingularityError):
            refused += 1
            assert refused < tries * scenes, "nearly all scenes are refused"
            continue
        seen += 1
        for name, pair in found.items():
            if len(pairs.setdefault(name, [])) < scenes:
                pairs[name].append(pair)
    print(f"{refused} of {seen + refused} scenes refused")
    judge(pairs, scenes)
    return pairs
