"""The distinct points of a mechanism: pins shared by several links, and points named on one link alone."""

from __future__ import annotations

from dataclasses import dataclass

from tmmcalc.linkage.model import FRAME, Joint, Mechanism


@dataclass(frozen=True, eq=False)  # a pin is itself, whatever its points
class Pin:
    """A point: its name, its place in the axes of each link that carries it [m], the revolute joints there."""

    name: str
    at: dict[int, complex]
    joints: tuple[str, ...]

    @property
    def fixed(self) -> bool:
        """Whether it is a point of the frame."""
        return FRAME in self.at

    @property
    def centre(self) -> bool:
        """Whether it is a centre of mass alone: ``S`` and the number of its link."""
        return not self.joints and self.name[0] == "S" and self.name[1:].isdigit()


def find_pins(mechanism: Mechanism) -> tuple[Pin, ...]:
    """All points of a mechanism, each once: pins first, in the order of the joints, then other points by link.

    A pin that its links call by different names takes the shortest; one without a name takes the joint's.
    """
    clusters: list[tuple[dict[int, complex], list[str]]] = []
    for joint in mechanism.joints:
        if joint.kind == "revolute":
            _join(clusters, joint)
    for link in (mechanism.frame, *mechanism.links):
        for p in link.points.values():
            if not any(at.get(link.id) == p for at, _ in clusters):
                clusters.append(({link.id: p}, []))
    return tuple(Pin(_name(mechanism, at, joints), at, tuple(joints)) for at, joints in clusters)


def _join(clusters: list[tuple[dict[int, complex], list[str]]], joint: Joint) -> None:
    """Add a revolute joint, merging the pins that it shows to be one."""
    at, joints = dict(zip(joint.links, joint.points, strict=True)), [joint.name]
    for cluster in [c for c in clusters if any(c[0].get(link) == p for link, p in at.items())]:
        clusters.remove(cluster)
        at, joints = cluster[0] | at, cluster[1] + joints
    clusters.append((at, joints))


def _name(mechanism: Mechanism, at: dict[int, complex], joints: list[str]) -> str:
    names = {name for link, p in at.items() for name, own in mechanism.link(link).points.items() if own == p}
    return min(names, key=lambda name: (len(name), name), default=joints[0] if joints else "")
