"""A filter in a file: it goes on as if it had never stopped, and what is no filter is refused."""

from dataclasses import replace

import numpy as np
import pytest

from slamlib.errors import SlamlibError
from slamlib.experiments.presets import preset
from slamlib.slam import Slam


@pytest.mark.parametrize("name", ["points_and_lines", "self_calibration"])
def test_a_saved_run_goes_on_bit_for_bit(name, tmp_path):
    p = replace(preset(name), frames=30)
    frames = [frame for frame, _ in p.simulate()]
    whole, begun = p.slam(), p.slam()
    for frame in frames:
        whole.step(frame)
    for frame in frames[:12]:
        begun.step(frame)
    begun.save(tmp_path / "run.npz", note="half way")
    resumed, extra = Slam.resume(tmp_path / "run.npz")
    assert extra == {"note": "half way"}
    for frame in frames[12:]:
        resumed.step(frame)
    assert np.array_equal(whole.belief.matrix, resumed.belief.matrix)
    assert all(np.array_equal(a.mean, b.mean) for a, b in zip(whole.belief.blocks, resumed.belief.blocks, strict=True))
    assert [vars(lm)["searched"] for lm in whole.landmarks] == [vars(lm)["searched"] for lm in resumed.landmarks]
    assert (whole.number, whole.time) == (resumed.number, resumed.time)


def test_files_that_are_no_filter(tmp_path):
    for name, content in (("text", b"hello"), ("empty", b"")):
        (tmp_path / name).write_bytes(content)
        with pytest.raises(SlamlibError, match="no slamlib filter"):
            Slam.load(tmp_path / name)
    with pytest.raises(SlamlibError, match="no such file"):
        Slam.load(tmp_path / "absent")
    slam = preset("points").slam()
    slam.save(tmp_path / "good.npz")
    data = (tmp_path / "good.npz").read_bytes()
    (tmp_path / "cut.npz").write_bytes(data[: len(data) // 2])
    with pytest.raises(SlamlibError, match="damaged"):
        Slam.load(tmp_path / "cut.npz")
    assert not list(tmp_path.glob("*partial*"))
