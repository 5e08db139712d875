"""Rooms with textured walls, filmed by ray casting: frames with images, and the exact truth beside them."""

from slambook.rendering.effects import NO_EFFECTS, Effects
from slambook.rendering.film import Film, film, rig_along_path
from slambook.rendering.furnished import ROOM_STYLES, default_room
from slambook.rendering.pairs import stereo_frame, stereo_rig
from slambook.rendering.paths import PATHS, CameraPath, path
from slambook.rendering.quads import Room, TexturedQuad
from slambook.rendering.renderer import Rendered, Renderer, render
from slambook.rendering.saving import save_film
from slambook.rendering.textures import PHOTOGRAPHS, Texture, photograph

__all__ = [
    "NO_EFFECTS",
    "PATHS",
    "PHOTOGRAPHS",
    "ROOM_STYLES",
    "CameraPath",
    "Effects",
    "Film",
    "Rendered",
    "Renderer",
    "Room",
    "Texture",
    "TexturedQuad",
    "default_room",
    "film",
    "path",
    "photograph",
    "render",
    "rig_along_path",
    "save_film",
    "stereo_frame",
    "stereo_rig",
]
