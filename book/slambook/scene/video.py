"""A run as a video, an animated GIF, or a folder of numbered pictures, written atomically.

What writes a frame is chosen by the ending of the path's name; a name without one is a folder.
"""

import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from itertools import chain, islice, zip_longest
from pathlib import Path
from typing import Any

import numpy as np

from slambook.figures.images import png
from slambook.scene.options import MapOptions
from slambook.scene.parts import extra
from slambook.scene.scene import bounds
from slambook.scene.window import Window
from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.experiments.progress import progress
from slamlib.manifolds import Array
from slamlib.plain_data.files import atomic_write
from slamlib.records.inputs import Truth, World
from slamlib.records.snapshots import Snapshot

Writer = Callable[[Path, Iterable[Array], float], None]


def animate(
    snapshots: Iterable[Snapshot],
    path: str | Path,
    *,
    world: World | None = None,
    truths: Iterable[Truth] = (),
    fps: float = 10.0,
    every: int = 1,
    overwrite: bool = False,
    **options: Any,
) -> Path:
    """Write a run as a film: path ends in .mp4, .webm (for web pages) or .gif, or is a folder for 0001.png, ...

    snapshots: a list, or an iterator, of which each is shown when it comes and none is kept: then no bar, and without a
    world the map's limits grow. truths: one a snapshot, or none. every: only each so many-th snapshot. overwrite:
    whether what is there may be replaced. The other keywords are those of Window and of MapOptions (view, orbit, ...).
    A progress bar shows where stderr is a terminal. Raises SlamlibError, also for a missing package, which it names.
    """
    write = ready(path, overwrite=overwrite)
    target = Path(path)
    _check(snapshots, truths, fps, every)
    shown = islice(_pairs(snapshots, truths), 0, None, every)
    first = next(shown, None)
    if first is None:
        raise SlamlibError("animate: there is no snapshot to show")
    known = snapshots if isinstance(snapshots, Sequence) else ()
    corners = None
    if known:  # the last one is known already: limits of the map that hold in all frames
        last = truths[-1] if isinstance(truths, Sequence) and truths else None
        corners = bounds(known[-1], world, last, known, MapOptions(limits=options.get("limits")))
    window = Window(first[0], world=world, corners=corners, coming=known, **options)

    def pictures() -> Iterator[Array]:
        for snapshot, truth in chain([first], shown):
            window.update(snapshot, truth)
            yield window.pixels()

    frames = pictures()
    target.parent.mkdir(parents=True, exist_ok=True)
    with atomic_write(target) as unfinished:
        write(unfinished, progress(frames, -(-len(known) // every), "video") if known else frames, fps)
    return target


def ready(path: str | Path, *, overwrite: bool = False) -> Writer:
    """What will write a film to this path. Raises SlamlibError if nothing can: ask before a long run, not after it."""
    target = Path(path)
    ending = target.suffix.lower()
    if ending not in WRITERS:
        raise UnknownNameError.of("ending of a video's name", target.suffix, [n or "(a folder)" for n in WRITERS])
    if target.name in ("", ".."):
        raise SlamlibError(f"{path} is no name of a film: a film without an ending is a new folder of pictures")
    if target.is_dir() and not _is_film(target):
        raise SlamlibError(f"{target} is a folder, and holds other things than a film's pictures: choose another name")
    if target.exists() and not overwrite:
        raise SlamlibError(f"{target} exists: choose another name, or replace it (overwrite=True, or --overwrite)")
    for package in ("matplotlib", *PACKAGES[ending]):
        extra(package, "a film")
    return WRITERS[ending]


def _is_film(folder: Path) -> bool:
    """Whether a folder holds what `_write_folder` has written, and nothing else: it may be replaced."""
    names = {path.name for path in folder.iterdir()}
    return names == {_numbered(i) for i in range(1, len(names) + 1)}


def _numbered(i: int) -> str:
    """The name of the i-th picture, from 1 on, in a folder."""
    return f"{i:04d}.png"


def _check(snapshots: Iterable[Snapshot], truths: Iterable[Truth], fps: float, every: int) -> None:
    if isinstance(snapshots, Sequence) and isinstance(truths, Sequence) and len(truths) not in (0, len(snapshots)):
        raise SlamlibError(f"animate: one truth a snapshot is wanted, got {len(truths)} for {len(snapshots)}")
    if not fps > 0 or every < 1:
        raise SlamlibError(f"animate: fps is positive and every is at least 1, got {fps!r} and {every!r}")


def _pairs(snapshots: Iterable[Snapshot], truths: Iterable[Truth]) -> Iterator[tuple[Snapshot, Truth | None]]:
    """Each snapshot with its truth, or with None if there are none at all."""
    for snapshot, truth in zip_longest(snapshots, truths):
        if truths and (snapshot is None or truth is None):
            raise SlamlibError("animate: one truth a snapshot is wanted, but one of the two ended before the other")
        yield snapshot, truth


def _write_folder(path: Path, frames: Iterable[Array], fps: float) -> None:
    """Numbered PNG files."""
    path.mkdir()
    for i, frame in enumerate(frames, 1):
        (path / _numbered(i)).write_bytes(png(frame))


def _write_gif(path: Path, frames: Iterable[Array], fps: float) -> None:
    """One palette for each frame; it begins again at its end."""
    image = extra("PIL.Image", "a GIF")
    pictures = (image.fromarray(frame).quantize(128) for frame in frames)
    first = next(iter(pictures))
    first.save(path, save_all=True, append_images=pictures, duration=round(1000 / fps), loop=0)


def _write_film(codec: str, path: Path, frames: Iterable[Array], fps: float) -> None:
    """A film; OpenCV brings its own encoders, so that no outside program is needed."""
    cv2 = extra("cv2", "a film")
    os.environ.setdefault("OPENCV_FFMPEG_LOGLEVEL", "-8")  # its errors are noticed below
    level = cv2.utils.logging.setLogLevel(cv2.utils.logging.LOG_LEVEL_SILENT)
    film, count = None, 0
    try:
        for frame in frames:
            even = frame[: frame.shape[0] // 2 * 2, : frame.shape[1] // 2 * 2]  # as the codecs want it
            if film is None:
                size = even.shape[1], even.shape[0]
                film = cv2.VideoWriter(str(path), cv2.VideoWriter_fourcc(*codec), float(fps), size)
                if not film.isOpened():
                    raise SlamlibError(
                        f"OpenCV cannot write {path.suffix} here: choose a .gif, or a folder of pictures"
                    )
            film.write(np.ascontiguousarray(even[..., ::-1]))
            count += 1
    finally:
        if film is not None:
            film.release()
        cv2.utils.logging.setLogLevel(level)
    written = cv2.VideoCapture(str(path))  # OpenCV does not report a disk that is full
    found = int(written.get(cv2.CAP_PROP_FRAME_COUNT)) if written.isOpened() else 0
    written.release()
    if found != count:
        raise SlamlibError(f"the film has {max(found, 0)} of its {count} frames: is the disk full?")


# MPEG-4 part 2 is quick and plays in every player; VP8 plays in web pages too, and takes ten times as long.
WRITERS: dict[str, Writer] = {
    "": _write_folder,
    ".gif": _write_gif,
    ".mp4": partial(_write_film, "mp4v"),
    ".webm": partial(_write_film, "VP80"),
}
PACKAGES = {"": (), ".gif": ("PIL.Image",), ".mp4": ("cv2",), ".webm": ("cv2",)}
