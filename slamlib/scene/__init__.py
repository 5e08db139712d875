"""Pictures of a filter at work: the map in space and what each sensor saw, on the page, in a window, as a video.

Everything here sees snapshots, worlds and truths alone, so that a new landmark, sensor or motion needs no new drawing.
"""

from slamlib.scene.figures import map_figure, sensor_figure
from slamlib.scene.image_scene import sensor_scene
from slamlib.scene.options import MapOptions, SensorOptions
from slamlib.scene.player import player
from slamlib.scene.player_page import Player
from slamlib.scene.scene import map_scene
from slamlib.scene.video import animate
from slamlib.scene.view import View
from slamlib.scene.window import Window

__all__ = [
    "MapOptions",
    "Player",
    "SensorOptions",
    "View",
    "Window",
    "animate",
    "map_figure",
    "map_scene",
    "player",
    "sensor_figure",
    "sensor_scene",
]
