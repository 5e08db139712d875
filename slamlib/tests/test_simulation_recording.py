"""Recordings: back bit for bit, saved atomically, open to others, and no damage goes unnoticed."""

import json
import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from slamlib.errors import SlamlibError
from slamlib.records.inputs import Frame, Scan
from slamlib.rigs.setup import Rig
from slamlib.simulation import Faults, Recording, join, load, save, simulate, world
from slamlib.tests.simulated import CAMERA, CLOISTER, LENS, RANGE, WALKER, same_runs

RIG = Rig(
    (WALKER, replace(WALKER, name="second", motion="constVel")),
    (replace(LENS, estimated=True, position_std=(0.1,) * 3), replace(RANGE, name="range", robot=1)),
)
WORLD = join(CLOISTER, world("house"))


def run(frames=4, seed=1, faults=Faults()):  # noqa: B008 - frozen
    rng = np.random.default_rng(seed)
    return list(simulate(RIG, WORLD, frames=frames, dt=0.1, rng=rng, faults=faults))


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    path = tmp_path_factory.mktemp("recordings") / "run.npz"
    save(path, run(), rig=RIG, world=WORLD)
    return path


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 2**32), st.integers(0, 4), st.sampled_from([0.0, 0.5, 1.0]))
def test_a_run_comes_back_bit_for_bit(seed, frames, rate):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "run.npz"
        pairs = run(frames, seed, Faults(miss=rate, swap=rate))
        save(path, pairs, rig=RIG, world=WORLD)
        back = load(path)
    same_runs(back, pairs)
    assert back.rig == RIG
    assert len(back) == frames
    for x in ("points", "segments"):
        assert (getattr(back.world, x).ids == getattr(WORLD, x).ids).all()
        assert getattr(back.world, x).values.tobytes() == getattr(WORLD, x).values.tobytes()
    assert back.world.faces.tobytes() == WORLD.faces.tobytes()


def test_a_loaded_recording_can_be_saved_again_to_the_same_bytes(file, tmp_path):
    again = load(file)
    save(tmp_path / "again.npz", again, rig=again.rig, world=again.world)
    assert (tmp_path / "again.npz").read_bytes() == file.read_bytes()


def test_it_is_read_with_numpy_and_json_alone(file):
    """As the module's docstring describes it: somebody else's filter needs nothing of slamlib."""
    with np.load(file, allow_pickle=False) as data:
        header = json.loads(str(data["header"]))
        assert (header["format"], header["version"], header["truth"]) == ("slamlib recording", 1, True)
        camera = header["rig"]["sensors"][0]
        assert camera["parameters"]["distortion"] == [-0.3, 0.1]
        frames = run()
        assert data["number"].tolist() == [1, 2, 3, 4]
        assert data["dt"].tolist() == [0.1] * 4
        for row, (frame, truth) in enumerate(frames):
            assert (data["robot1.control"][row] == frame.controls[1].value).all()
            assert (data["robot1.noise"][row] == frame.controls[1].covariance).all()
            assert (data["truth.robot1"][row] == truth.robots[1]).all()
            assert (data["truth.mount0"][row] == truth.extrinsics[0]).all()
            for j, scan in enumerate(frame.scans):
                for name, features in (("points", scan.points), ("segments", scan.segments)):
                    first = data[f"sensor{j}.{name}.first"]
                    rows = slice(first[row], first[row + 1])
                    assert data[f"sensor{j}.{name}.ids"][rows].tolist() == features.ids.tolist()
                    assert data[f"sensor{j}.{name}.values"][rows].tolist() == features.values.tolist()
        assert data["world.points.values"].shape == (72, 3)
        assert data["world.segments.values"].shape == (23, 6)


def test_the_docstring_names_every_array(file):
    from slamlib.simulation import recording

    with np.load(file) as data:
        for name in data.files:
            general = name.replace("robot0", "robot{i}").replace("robot1", "robot{i}").replace("points", "X")
            general = general.replace("sensor0", "sensor{j}").replace("sensor1", "sensor{j}").replace("segments", "X")
            general = general.replace("mount0", "mount{j}").replace("mount1", "mount{j}")
            assert general in recording.__doc__ or name in recording.__doc__, name


def test_without_truth_and_without_a_control(tmp_path):
    real = [(Frame(f.number, f.dt, (None, f.controls[1]), f.scans), None) for f, _ in run()]
    save(tmp_path / "real.npz", real, rig=RIG, world=WORLD)
    back = load(tmp_path / "real.npz")
    same_runs(back, real)
    assert back.truths == (None,) * 4
    assert back.frames[0].controls[0] is None


def test_a_setup_given_as_arrays_is_saved_as_numbers(tmp_path):
    rig = Rig((replace(WALKER, position=np.array([1.0, 2.0, 3.0])),), (CAMERA,))
    save(tmp_path / "run.npz", [], rig=rig, world=WORLD)
    assert load(tmp_path / "run.npz").rig.robots[0].position == (1.0, 2.0, 3.0)


def test_what_cannot_be_saved_is_named_and_leaves_the_file_as_it_was(tmp_path):
    path = tmp_path / "run.npz"
    pairs = run(2)
    save(path, pairs, rig=RIG, world=WORLD)
    before = path.read_bytes()
    frame, truth = pairs[0]
    with_image = replace(frame, scans=(Scan(frame.scans[0].features, image=np.zeros((2, 2))), frame.scans[1]))
    for wrong, message in (
        ([(replace(frame, controls=()), truth)], "has 0 controls and 2 scans, but the rig has 2 robots and 2 sensors"),
        ([(with_image, truth)], "holds an image"),
        ([(frame, truth), (frame, None)], "truth is known of some frames only"),
    ):
        with pytest.raises(SlamlibError, match=message):
            save(path, wrong, rig=RIG, world=WORLD)

    def interrupted():
        yield pairs[0]
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        save(path, interrupted(), rig=RIG, world=WORLD)
    assert path.read_bytes() == before
    assert list(tmp_path.iterdir()) == [path]


@settings(max_examples=150, deadline=None)
@given(st.data())
def test_no_changed_byte_goes_unnoticed(file, data):
    good = bytearray(file.read_bytes())
    place, value = data.draw(st.integers(0, len(good) - 1)), data.draw(st.integers(1, 255))
    good[place] ^= value
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "run.npz"
        path.write_bytes(good)
        try:
            back = load(path)
        except SlamlibError as error:
            assert "run.npz" in str(error)
        else:
            same_runs(back, run())


@settings(max_examples=50, deadline=None)
@given(st.floats(0, 0.999))
def test_no_cut_goes_unnoticed(file, share):
    whole = file.read_bytes()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "run.npz"
        path.write_bytes(whole[: int(share * len(whole))])
        with pytest.raises(SlamlibError, match=r"run\.npz cannot be read"):
            load(path)


def test_foreign_files_are_named(tmp_path, file):
    path = tmp_path / "other.npz"
    np.savez(path, x=np.zeros(3))
    with pytest.raises(SlamlibError, match=r"other\.npz is no slamlib recording: it has no header"):
        load(path)
    np.savez(path, header=np.array(json.dumps({"format": "slamlib recording", "version": 2})))
    with pytest.raises(SlamlibError, match="version 2, and this slamlib reads 1"):
        load(path)
    with np.load(file) as data:
        arrays = {n: data[n] for n in data.files if n != "dt"}
    np.savez(path, **arrays)
    with pytest.raises(SlamlibError, match=r"has been changed since it was written: its checksum differs"):
        load(path)
    del arrays["digest"]  # as written by another program
    np.savez(path, **arrays)
    with pytest.raises(SlamlibError, match=r"is incomplete, or has been changed: KeyError 'dt'"):
        load(path)
    np.save(tmp_path / "one.npy", np.zeros(3))
    path.write_text("no archive")
    for foreign in (tmp_path / "one.npy", path, tmp_path):
        with pytest.raises(SlamlibError, match="cannot be read"):
            load(foreign)
    with pytest.raises(SlamlibError, match="no such file"):
        load(tmp_path / "missing.npz")


def test_a_recording_drives_what_a_simulation_drives(file):
    assert isinstance(load(file), Recording)
    for (frame, truth), (again, real) in zip(load(file), run(), strict=True):
        assert frame.number == again.number
        assert (truth.robots[0] == real.robots[0]).all()
