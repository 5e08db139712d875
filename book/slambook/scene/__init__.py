"""Pictures of a filter at work: the map in space and what each sensor saw, on the page, in a window, as a video.

Everything here sees snapshots, worlds and truths alone, so that a new landmark, sensor or motion needs no new drawing.
"""

from slambook.scene.figures import map_figure, sensor_figure
from slambook.scene.image_scene import sensor_scene
from slambook.scene.options import MapOptions, SensorOptions
from slambook.scene.player import player
from slambook.scene.player_page import Player
from slambook.scene.scene import map_scene
from slambook.scene.video import animate
from slambook.scene.view import OrbitView
from slambook.scene.window import Window

__all__ = [
    "MapOptions",
    "OrbitView",
    "Player",
    "SensorOptions",
    "Window",
    "animate",
    "map_figure",
    "map_scene",
    "player",
    "sensor_figure",
    "sensor_scene",
]
