"""Fastest changes of a contact force along the track, compared with the hanger joints."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

# Changes are counted over pieces of this length in m, the paper's contact-wire element: what its
# mesh and its step, one element, can resolve. It stays the same when either is varied.
PIECE = 0.25
# A piece belongs to a joint when its middle is at most two such elements away, in m: the joint's
# mass acts through its elements, and backward differences spread an event over two steps.
REACH = 0.5


@dataclass(frozen=True, slots=True)
class Joint:
    """The fastest changes of force around one joint.

    Attributes
    ----------
    x
        Place of the joint, m.
    place, change
        Middle of the piece with the largest change within reach of the joint, m, and the change, N.
    elsewhere
        Largest change, as a magnitude, up to halfway to the neighbouring joints, N.
    fastest
        Middle of the piece with the largest change of all these, m.
    """

    x: float
    place: float
    change: float
    elsewhere: float
    fastest: float

    @property
    def ratio(self) -> float:
        """Largest change at the joint over the largest one elsewhere; above 1 it is located."""
        return abs(self.change) / self.elsewhere if self.elsewhere else float(self.change != 0.0)


@dataclass(frozen=True, slots=True)
class JointChanges:
    """Changes of a contact force over pieces of `PIECE`, at the joints and elsewhere.

    Attributes
    ----------
    joints
        The joints whose reach lies inside the section.
    near, elsewhere
        Root mean square of the changes within reach of a joint, and of all others, N.
    """

    joints: tuple[Joint, ...]
    near: float
    elsewhere: float

    @property
    def located(self) -> int:
        """Number of joints whose stretch of track has its fastest change within reach."""
        return sum(joint.ratio > 1.0 for joint in self.joints)

    @property
    def least_ratio(self) -> float:
        """Lowest ratio of all joints."""
        return min(joint.ratio for joint in self.joints)

    @property
    def rms_ratio(self) -> float:
        """Changes at joints over changes elsewhere, root mean square."""
        return self.near / self.elsewhere if self.elsewhere else float(self.near > 0.0)

    @property
    def largest(self) -> Joint:
        """The joint with the largest change of all."""
        return max(self.joints, key=lambda joint: abs(joint.change))


def joint_changes(
    x: Floats, force: Floats, joints: Floats, section: tuple[float, float]
) -> JointChanges:
    """Measure how fast the force changes at joints, and elsewhere in the section.

    Parameters
    ----------
    x, force
        Position of the pantograph, m, increasing, and contact force, N, unfiltered.
    joints
        Places of the hanger joints, m. Where two wires are held at one place it counts once.
    section
        Begin and end of the stretch of track that counts, m.

    Notes
    -----
    The section is cut into pieces of `PIECE`; the force at their ends is interpolated between the
    records. Every piece is assigned to the joint that is nearest.
    """
    begin, end = section
    pieces = int((end - begin) / PIECE + 1e-9)  # an end that misses by round-off is reached
    ends = begin + PIECE * np.arange(pieces + 1)
    change = np.diff(np.interp(ends, x, force))
    middle = np.asarray(ends[:-1] + 0.5 * PIECE, dtype=np.float64)
    places = np.array(sorted(set(joints.tolist())))
    inside = places[(places >= begin + REACH) & (places <= end - REACH)]
    if not inside.size:
        return JointChanges((), 0.0, _rms(change))
    distance = np.abs(middle[:, None] - inside)
    nearest, near = distance.argmin(axis=1), distance.min(axis=1) <= REACH
    found = tuple(
        _joint(float(at), middle, change, near, nearest == number)
        for number, at in enumerate(inside)
    )
    return JointChanges(found, _rms(change[near]), _rms(change[~near]))


def _joint(x: float, middle: Floats, change: Floats, near: Flags, own: Flags) -> Joint:
    size = np.abs(change)
    at_joint = int(np.argmax(np.where(own & near, size, -1.0)))
    fastest = int(np.argmax(np.where(own, size, -1.0)))
    elsewhere = size[own & ~near].max(initial=0.0)
    return Joint(
        x, float(middle[at_joint]), float(change[at_joint]), float(elsewhere),
        float(middle[fastest]),
    )  # fmt: skip


def _rms(values: Floats) -> float:
    return float(np.sqrt(np.mean(values**2))) if values.size else 0.0
