"""A run as an interactive map that lives in a page without Python: play, step, turn, zoom.

What the page gets is data, not pictures: whole numbers of a small unit of length, and of each frame what differs from
the frame before. The script that draws them (player.js) travels with the figure and starts when somebody touches it;
until then, and where scripts are not allowed, the figure is a still picture.
"""

import json
from collections.abc import Callable, Sequence
from typing import Any

from slambook.figures import figure
from slambook.figures.colors import paint
from slambook.figures.page import must_describe
from slambook.figures.paths import number
from slambook.figures.style import DASHES
from slambook.scene.figures import SHELL, draw, map_figure
from slambook.scene.image_frames import ImageFrames
from slambook.scene.image_scene import OUTCOMES, sensor_scene
from slambook.scene.options import MapOptions, SensorOptions
from slambook.scene.packing import packed
from slambook.scene.player_page import Player
from slambook.scene.roles import HALO, MAP, OUTLINE, SENSOR, Role, over_image
from slamlib.errors import SlamlibError
from slamlib.plain_data.fields import read
from slamlib.records.inputs import Truth, World
from slamlib.records.snapshots import Snapshot

SECOND = 3.6  # inches: width of the sensor's view, which stands beside the map or below it
WEIGHT = 200_000  # characters of data at most, beside the script and the still picture
WEIGHT_OF_IMAGES = 600_000  # so many more if images are asked for


def player(
    snapshots: Sequence[Snapshot],
    *,
    alt: str,
    world: World | None = None,
    truths: Sequence[Truth] = (),
    frames: int = 80,
    fps: float = 10.0,
    note: Callable[[Snapshot], str] | None = None,
    sensor: int | str | None = None,
    sensor_options: SensorOptions | None = None,
    images: bool = False,
    width: float = 5.8,
    height: float = 4.0,
    **options: Any,
) -> Player:
    """An interactive map of a run, for the page; the other keywords are those of MapOptions.

    alt: a sentence that describes the figure. truths: one a snapshot, or none. frames: at most so many are shown,
    evenly spread and the last among them; fewer if their data would weigh more than 200 kB. fps: frames per second.
    note: gives a text for each frame, below the map. sensor: index or name of the one shown beside the map. images:
    whether that camera's images lie below its view, small; then all weighs up to 800 kB. Raises SlamlibError.
    """
    map_options = read(MapOptions, options)
    _check(snapshots, truths, alt, frames, fps)
    shots = None if sensor is None else ImageFrames(snapshots, sensor, sensor_options or SensorOptions(), images)
    most = WEIGHT + WEIGHT_OF_IMAGES * images
    last, count = snapshots[-1], min(frames, len(snapshots))
    while True:
        data = packed(snapshots, world, truths, count, map_options, width / height)
        for frame, snapshot in zip(data["frames"], data["shown"], strict=True):
            frame |= {} if shots is None else {"measurements": shots.frame(snapshot)}
        weight = len(json.dumps(data["frames"], separators=(",", ":")))
        if weight <= most or count <= 2:
            break
        count = max(2, min(count - 1, int(count * most / weight)))
    for frame, snapshot in zip(data["frames"], data.pop("shown"), strict=True):
        frame["note"] = note(snapshot) if note is not None else ""
    kinds = {row[0] for frame in data["frames"] for row in frame["landmarks"].values()}
    lines = {role for frame in data["frames"] for role, found in frame["lines"].items() if found}
    used = {"label", *data["still"], *lines, *(data["kinds"][kind] for kind in kinds)}  # of which something is seen
    data |= {"fps": fps, "roles": {name: _styles(role) for name, role in MAP.items() if name in used}}
    shown: dict[str, Any] = {"world": world, "truth": truths[-1] if truths else None, "true_path": truths}
    still = map_figure(last, path=snapshots, width=width, height=height, **shown, **{**options, "legend": False})
    stills = [still.svg(alt)]
    if shots is not None:
        data["sensor"] = _sensor(shots, [frame["measurements"] for frame in data["frames"]])
        stills.append(_still(last, shots, alt))
    return Player(data, "".join(stills), alt, map_options.labels)


def _sensor(shots: ImageFrames, measurements: Sequence[dict[str, Any]]) -> dict[str, Any]:
    """The sensor's data for the script, but for its measurements; over images, roles are bright with a dark outline."""
    roles = {name: _styles(role) for name, role in SENSOR.items()}
    found: dict[str, Any] = {"roles": roles, "limits": shots.limits, "outcomes": list(OUTCOMES)}
    if any("image" in frame for frame in measurements):
        over = {name: _styles(over_image(role)) for name, role in SENSOR.items()}
        for name, style in over.items():
            width = number(SENSOR[name].width + 2 * HALO)
            style["halo"] = f"stroke:{OUTLINE};stroke-width:{width};stroke-linejoin:round"
            style["text"] += f";paint-order:stroke;stroke:{OUTLINE};stroke-width:{number(2 * HALO)}"
        found["over"] = over
    return found


def _still(snapshot: Snapshot, shots: ImageFrames, alt: str) -> str:
    """The sensor's view before the script draws it."""
    left, right, low, high = shots.limits
    shape = abs((right - left) / (high - low)) if shots.view.image is not None else 4 / 3
    fig, ax = figure(width=SECOND, height=SECOND / shape)
    ax.axis("off")
    ax.set(xlim=(left, right), ylim=(low, high))
    ax.plot([left, right, right, left, left], [low, low, high, high, low], color=SENSOR["raw"].color, lw=1.2)
    photo, layers = shots.photo(snapshot), sensor_scene(snapshot, shots.sensor, options=shots.options)
    draw(ax, layers, SENSOR, photo)
    ax.set(aspect="auto")
    return fig.svg(f"What {shots.view.name} saw. {alt}")


def _check(snapshots: Sequence[Snapshot], truths: Sequence[Truth], alt: str, frames: int, fps: float) -> None:
    if len(snapshots) < 2 or frames < 2:
        raise SlamlibError(f"player: at least two frames are wanted, got {min(len(snapshots), frames)}")
    if truths and len(truths) != len(snapshots):
        raise SlamlibError(f"player: one truth a snapshot is wanted, got {len(truths)} for {len(snapshots)}")
    must_describe("player", alt)
    if not fps > 0:
        raise SlamlibError(f"player: fps should be a positive number of frames per second, got {fps!r}")


def _styles(role: Role) -> dict[str, Any]:
    """A role as the styles of what the script draws."""
    color, spaced = paint(role.color), " ".join(number(d * role.width) for d in DASHES[role.linestyle])
    line = f"stroke:{color};stroke-opacity:{number(role.alpha)};stroke-width:{{}}"
    line += f";stroke-dasharray:{spaced}" if spaced else ""
    filled = "none" if role.hollow else color
    return {
        "label": role.label,
        "marker": role.marker,
        "size": role.size,
        "raised": role.raised - 0.36 * role.size,
        "line": line.format(number(role.width)),
        "shell": line.format(number(SHELL * role.width)),
        "mark": f"stroke:{color};stroke-width:1;fill:{filled}",
        "text": f"fill:{color};font-size:{number(role.size)}px;text-anchor:middle",
    }
