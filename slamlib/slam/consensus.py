"""Which of the matches of one frame are believed together, before the gate judges each by itself. Chapter 19.

A consensus yields groups of looks, one after another: the filter corrects by a group before it asks for the next one,
so that a later group is chosen in the light of the earlier correction.
"""

from collections.abc import Callable, Iterator

from slamlib.belief import Belief
from slamlib.slam.entities import MountedSensor
from slamlib.slam.looking import Look
from slamlib.slam.options import Options

Consensus = Callable[[Belief, MountedSensor, list[Look], Options], Iterator[list[Look]]]


def each(belief: Belief, sensor: MountedSensor, looks: list[Look], options: Options) -> Iterator[list[Look]]:
    """All of them: the gate judges each alone."""
    yield looks


CONSENSUS: dict[str, Consensus] = {"each": each}
