"""Public recordings of numbered landmarks with a truth, as frames for the filter.

UTIAS MRCLAM (Leung and others, 2011), and two of Barfoot's course (State Estimation for Robotics). `slamlib datasets`
says where they are offered. Each robot starts at its true pose, exactly known.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.errors import optional
from slamlib.evaluation.trajectory import Trajectory
from slamlib.geometry import euler, quaternion
from slamlib.geometry.pose2 import compose, in_space, inverse
from slamlib.manifolds import Array
from slamlib.records.inputs import Control, Features, Frame, Scan
from slamlib.rigs import builders
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.slam import Options, Slam

# All that passes the gate is used, and nothing is deleted: a bar code is right, wherever else it was not read.
OPTIONS = Options(
    points="planePnt", updates=1000, max_new_first=1000, max_new=1000, min_matched_ratio=0.0, min_inlier_ratio=0.0
)
# Of MRCLAM, chosen once for all five robots: rates [m^2/s, rad^2/s] of a robot that stands, and by its speed squared;
# standard deviations [m, rad] of a measurement.
SLIP, BY_SPEED, SEEN_STD = (2e-4, 2e-3), 0.02, (0.2, np.radians(2.0))


@dataclass(frozen=True, eq=False)
class Sightings:
    """A recording: what a filter gets, and the truth.

    rig: the robots at their true first poses, with a sensor each. truths: of each robot, where it is known. points:
    true places (3,) by number, or none. meetings: by frame, what robots measured of each other: (observer, observed,
    measurement by the observer's sensor).
    """

    frames: list[Frame]
    rig: Rig
    truths: Sequence[Trajectory]
    points: dict[int, Array] = field(default_factory=dict)
    meetings: dict[int, list[tuple[int, int, Array]]] = field(default_factory=dict)
    options: Options = OPTIONS

    def slam(self, **said: Any) -> Slam:
        """The filter before the first frame; said: options that are others than the recording's."""
        return Slam(self.rig, options=replace(self.options, **said))


def robot_at(pose: Array, motion: str, name: str = "robot") -> RobotSetup:
    """A robot that starts at a pose (7,), exactly known."""
    angles = np.degrees(euler.from_quaternion(pose[3:]))
    return builders.robot(motion, name=name, position=tuple(pose[:3].tolist()), euler=tuple(angles.tolist()))


def matlab(path: Path) -> dict[str, Any]:
    """The variables of a MATLAB file."""
    found: dict[str, Any] = optional("scipy.io", "to read MATLAB's files", "fast").loadmat(path)
    return found


def woods(folder: Path) -> Sightings:
    """Barfoot's "lost in the woods": a robot with a scanner among 17 tubes, with the noise that the file states.

    Without a gate: no measurement is of another tube, and by this noise one of 99 % refuses so many that it gets lost.
    """
    m = {name: np.squeeze(value) for name, value in matlab(folder / "dataset2.mat").items() if name[0] != "_"}
    poses = in_space(np.column_stack([m["x_true"], m["y_true"], m["th_true"]]))
    noise, frames = np.diag([m["v_var"], m["om_var"]]), []
    for k, dt in enumerate(np.diff(m["t"]), 1):
        seen = np.flatnonzero(m["r"][k])
        scan = Scan({"points": Features(seen, np.column_stack([m["r"][k, seen], m["b"][k, seen]]))})
        frames.append(Frame(k, float(dt), (Control(np.array([m["v"][k], m["om"][k]]), noise),), (scan,)))
    valid = m["true_valid"] > 0
    scanner = builders.range_bearing(np.sqrt([m["r_var"], m["b_var"]]), position=(float(m["d"]), 0.0, 0.0))
    points = {j: np.array([*place, 0.0]) for j, place in enumerate(m["l"])}
    truth = Trajectory((m["t"] - m["t"][0])[valid], poses[valid])
    rig, options = Rig((robot_at(poses[0], "unicycle"),), (scanner,)), replace(OPTIONS, gate=1.0)
    return Sightings(frames, rig, [truth], points, options=options)


def tracked(times: Array, velocities: Array, noise: Array, pixels: Array) -> list[Frame]:
    """Frames of stereo tracks: a body's velocities (n, 6), their noise (6,), pixels (n, m, 4), -1 where not seen."""
    frames = []
    for k, dt in enumerate(np.diff(times), 1):
        seen = np.flatnonzero((pixels[k] >= 0).all(-1))
        u, row, right, other = pixels[k, seen].T
        scan = Scan({"points": Features(seen, np.column_stack([u, (row + other) / 2, u - right]))})
        control = Control(dt * velocities[k], dt**2 * np.diag(noise))
        frames.append(Frame(k, float(dt), (control,), (scan,)))
    return frames


def stereo(variances: Any, intrinsics: Any, baseline: float, turn: Array, place: Array) -> SensorSetup:
    """Two cameras: variances (4,) of u, v on the left and on the right; turn: from the body's axes to the camera's."""
    J = np.array([[1, 0, 0, 0], [0, 0.5, 0, 0.5], [1, 0, -1, 0]])  # of u, the mean v, and the disparity
    angles = np.degrees(euler.from_quaternion(quaternion.from_rotation(turn.T, quaternion.best_pivot(turn.T))))
    position, noise = tuple(place.tolist()), J @ np.diag(variances) @ J.T
    return builders.stereo(
        intrinsics, baseline, image=None, noise=noise, position=position, euler=tuple(angles.tolist())
    )


def starry_night(folder: Path) -> Sightings:
    """Barfoot's "starry night": a stereo camera with a gyro over 20 points, with the noise that the file states."""
    m = {name: np.squeeze(value) for name, value in matlab(folder / "dataset3.mat").items() if name[0] != "_"}
    poses = np.concatenate([m["r_i_vk_i"].T, quaternion.exponential(m["theta_vk_i"].T)], axis=1)
    times, noise = m["t"] - m["t"][0], np.concatenate([m["v_var"], m["w_var"]])
    velocities = np.concatenate([m["v_vk_vk_i"], m["w_vk_vk_i"]]).T
    frames = tracked(times, velocities, noise, m["y_k_j"].transpose(1, 2, 0))
    camera = stereo(m["y_var"], [m["cu"], m["cv"], m["fu"], m["fv"]], m["b"], m["C_c_v"], m["rho_v_c_v"])
    points, options = dict(enumerate(m["rho_i_pj_i"].T)), replace(OPTIONS, points="eucPnt")
    rig = Rig((robot_at(poses[0], "odometry"),), (camera,))
    return Sightings(frames, rig, [Trajectory(times, poses)], points, options=options)


def mrclam(folder: Path, robots: Sequence[int] = (1, 2, 3, 4, 5)) -> Sightings:
    """UTIAS MRCLAM: a frame for each instant at which one of these robots saw something, all of which start at once."""
    codes = {int(code): int(subject) for subject, code in np.loadtxt(folder / "Barcodes.dat")}
    names = "Odometry", "Measurement", "Groundtruth"
    rows = {i: [np.loadtxt(folder / f"Robot{i}_{name}.dat.gz") for name in names] for i in range(1, 6)}
    begin = max(part[0, 0] for row in rows.values() for part in row)
    odometry, seen, true = zip(*(rows[i] for i in robots), strict=True)
    instants = np.unique(np.concatenate([m[m[:, 0] > begin, 0] for m in seen]))
    controls = [driven(o, np.concatenate([[begin], instants])) for o in odometry]
    frames, meetings = [], dict[int, list[tuple[int, int, Array]]]()
    for k, (now, dt) in enumerate(zip(instants, np.diff(instants, prepend=begin), strict=True), 1):
        scans = []
        for i, m in enumerate(seen):
            found = {codes.get(int(code), 0): np.array(z) for _, code, *z in m[m[:, 0] == now]}
            tubes = {subject: z for subject, z in found.items() if subject > len(rows)}
            met = [(i, robots.index(subject), z) for subject, z in found.items() if subject in robots]
            meetings[k] = meetings.get(k, []) + met
            scans.append(Scan({"points": Features(np.array([*tubes], int), np.reshape([*tubes.values()], (-1, 2)))}))
        frames.append(Frame(k, float(dt), tuple(own[k - 1] for own in controls), tuple(scans)))
    truths = []
    for t, x, y, heading in (g.T for g in true):
        at = np.concatenate([[begin], np.unique(t[t > begin])])
        columns = (np.interp(at, t, column) for column in (x, y, np.unwrap(heading)))
        truths.append(Trajectory(at - begin, in_space(np.column_stack([*columns]))))
    starts = [robot_at(truth.poses[0], "planeOdometry", f"robot {i}") for i, truth in zip(robots, truths, strict=True)]
    cameras = [builders.range_bearing(SEEN_STD, name=f"camera {i}", robot=k) for k, i in enumerate(robots)]
    points = {int(n): np.array([x, y, 0.0]) for n, x, y, *_ in np.loadtxt(folder / "Landmark_Groundtruth.dat")}
    return Sightings(frames, Rig(tuple(starts), tuple(cameras)), truths, points, meetings)


def driven(odometry: Array, instants: Array) -> list[Control]:
    """What speeds and turn rates (n, 3), with their times, amount to between instants, each valid until the next."""
    times, v, w = odometry.T
    dt = np.diff(times)
    heading = np.concatenate([[0.0], np.cumsum(w[:-1] * dt)])
    middle = heading[:-1] + w[:-1] * dt / 2
    way = np.cumsum((v[:-1] * dt)[:, None] * np.column_stack([np.cos(middle), np.sin(middle)]), axis=0)
    places = np.column_stack([np.concatenate([np.zeros((1, 2)), way]), heading])
    poses = np.column_stack([np.interp(instants, times, column) for column in places.T])
    steps, spans = compose(inverse(poses[:-1]), poses[1:]), np.diff(instants)
    speeds = np.column_stack([np.hypot(*steps[:, :2].T), steps[:, 2]]) / spans[:, None]
    rates = spans[:, None] * (SLIP + BY_SPEED * speeds**2)
    return [Control(u, np.diag([q, q, p])) for u, (q, p) in zip(steps, rates, strict=True)]
