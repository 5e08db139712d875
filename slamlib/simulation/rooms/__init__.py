"""Rooms with textured walls, filmed by ray casting: frames with images, and the exact truth beside them."""

from slamlib.simulation.rooms.effects import NO_EFFECTS, Effects
from slamlib.simulation.rooms.film import Film, film
from slamlib.simulation.rooms.furnished import LOOKS, default_room
from slamlib.simulation.rooms.hand import hand_held
from slamlib.simulation.rooms.paths import PATHS, Path, path
from slamlib.simulation.rooms.quads import Room, TexturedQuad
from slamlib.simulation.rooms.renderer import Rendered, Renderer, render
from slamlib.simulation.rooms.saving import save_film
from slamlib.simulation.rooms.textures import PHOTOGRAPHS, Texture, photograph

__all__ = [
    "LOOKS",
    "NO_EFFECTS",
    "PATHS",
    "PHOTOGRAPHS",
    "Effects",
    "Film",
    "Path",
    "Rendered",
    "Renderer",
    "Room",
    "Texture",
    "TexturedQuad",
    "default_room",
    "film",
    "hand_held",
    "path",
    "photograph",
    "render",
    "save_film",
]
