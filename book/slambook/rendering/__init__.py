"""Rooms with textured walls, filmed by ray casting: frames with images, and the exact truth beside them."""

from slambook.rendering.effects import NO_EFFECTS, Effects
from slambook.rendering.film import Film, film
from slambook.rendering.furnished import LOOKS, default_room
from slambook.rendering.hand import hand_held
from slambook.rendering.paths import PATHS, Path, path
from slambook.rendering.quads import Room, TexturedQuad
from slambook.rendering.renderer import Rendered, Renderer, render
from slambook.rendering.saving import save_film
from slambook.rendering.textures import PHOTOGRAPHS, Texture, photograph

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
