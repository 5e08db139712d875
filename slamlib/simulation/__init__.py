"""Simulated robots and sensors in simulated worlds: the frames that a real run would have, and the ground truth."""

from slamlib.simulation import controls
from slamlib.simulation.frames import NOISE_IN, simulate
from slamlib.simulation.recording import Recording, load, save
from slamlib.simulation.sensors import Faults
from slamlib.simulation.worlds import WORLDS, join, world

__all__ = ["NOISE_IN", "WORLDS", "Faults", "Recording", "controls", "join", "load", "save", "simulate", "world"]
