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
from slamlib.geometry.pose import Pose, relative
from slamlib.manifolds import Array
from slamlib.records.inputs import Control, Features, Frame, Scan
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.sensors import SENSORS
from slamlib.sensors.sensor import Calibration
from slamlib.slam import Options, Slam

PLANE, SPACE = (0, 1, 5), (0, 1, 2, 3, 4, 5)  # of a pose's errors, what is unknown
# All that is seen is used, and nothing is deleted: a bar code or a mark is right, wherever else it was not read.
OPTIONS = Options(
    points="eucPnt", updates=1000, max_new_first=1000, max_new=1000, min_matched_ratio=0.0, min_inlier_ratio=0.0
)
# Of MRCLAM, chosen once for all five robots: rates [m^2/s, rad^2/s] of a robot that stands, and by its speed squared;
# standard deviations [m, rad] of a measurement.
SLIP, BY_SPEED, SEEN_STD = (2e-4, 2e-3), 0.02, (0.2, np.radians(2.0))


@dataclass(frozen=True, eq=False)
class Sightings:
    """A recording: what a filter gets, and the truth.

    starts: a robot's true first pose (7,) each. sensors: calibration and extrinsics, one per robot. truths: of each
    robot, where it is known. points: true places (3,) by number, or none. meetings: by frame, what robots measured of
    each other: (observer, observed, range and bearing). free: the numbers of a pose's errors that are unknown.
    """

    frames: list[Frame]
    starts: Sequence[Array]
    sensors: Sequence[tuple[Calibration, Array]]
    truths: Sequence[Trajectory]
    points: dict[int, Array] = field(default_factory=dict)
    meetings: dict[int, list[tuple[int, int, Array]]] = field(default_factory=dict)
    free: tuple[int, ...] = PLANE
    options: Options = OPTIONS

    def slam(self, **said: Any) -> Slam:
        """The filter before the first frame; said: options that are others than the recording's."""
        robots = tuple(
            RobotSetup(str(i), position=tuple(start[:3]), euler=tuple(np.degrees(euler.from_quaternion(start[3:]))))
            for i, start in enumerate(self.starts)
        )
        setups = tuple(SensorSetup(str(i), robot=i, type="rangeBearing") for i in range(len(robots)))
        slam = Slam(Rig(robots, setups), options=replace(self.options, **said))
        for rig_sensor, (calibration, extrinsics) in zip(slam.sensors, self.sensors, strict=True):
            rig_sensor.calibration, rig_sensor.given_extrinsics = calibration, extrinsics
        return slam


def planar(x: Any, y: Any, heading: Any) -> Array:
    """Poses (..., 7) in the plane."""
    half, zero = np.asarray(heading) / 2, np.zeros_like(np.asarray(x, float))
    return np.stack([x, y, zero, np.cos(half), zero, zero, np.sin(half)], axis=-1)


def level(distance: Any, bearing: Any) -> Array:
    """Measurements (n, 3) of a scanner in the plane: the pitch is zero."""
    return np.column_stack([distance, bearing, 0 * np.asarray(bearing)])


def scanner(distance: float, bearing: float) -> Calibration:
    """A scanner in the plane, by its standard deviations [m, rad]."""
    return Calibration(SENSORS["rangeBearing"], np.diag([distance, bearing, bearing]) ** 2)


def matlab(path: Path) -> dict[str, Any]:
    """The variables of a MATLAB file."""
    found: dict[str, Any] = optional("scipy.io", "to read MATLAB's files", "fast").loadmat(path)
    return found


def woods(folder: Path) -> Sightings:
    """Barfoot's "lost in the woods": a robot with a scanner among 17 tubes, with the noise that the file states."""
    m = {name: np.squeeze(value) for name, value in matlab(folder / "dataset2.mat").items() if name[0] != "_"}
    poses = planar(m["x_true"], m["y_true"], m["th_true"])
    Q = np.diag([m["v_var"], 0, 0, 0, 0, m["om_var"]])
    frames = []
    for k, dt in enumerate(np.diff(m["t"]), 1):
        seen = np.flatnonzero(m["r"][k])
        scan = Scan({"points": Features(seen, level(m["r"][k, seen], m["b"][k, seen]))})
        control = Control(dt * np.array([m["v"][k], 0, 0, 0, 0, m["om"][k]]), dt**2 * Q)
        frames.append(Frame(k, float(dt), (control,), (scan,)))
    valid = m["true_valid"] > 0
    sensor = scanner(np.sqrt(m["r_var"]), np.sqrt(m["b_var"])), planar(m["d"], 0.0, 0.0)
    points = {j: np.array([*place, 0.0]) for j, place in enumerate(m["l"])}
    return Sightings(frames, [poses[0]], [sensor], [Trajectory((m["t"] - m["t"][0])[valid], poses[valid])], points)


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


def stereo(variances: Any, intrinsics: Any, baseline: float, turn: Array, place: Array) -> tuple[Calibration, Array]:
    """Two cameras: variances (4,) of u, v on the left and on the right; turn: from the body's axes to the camera's."""
    J = np.array([[1, 0, 0, 0], [0, 0.5, 0, 0.5], [1, 0, -1, 0]])  # of u, the mean v, and the disparity
    lens = {"intrinsics": intrinsics, "baseline": [baseline]}
    pose = np.concatenate([place, quaternion.from_rotation(turn.T, quaternion.best_pivot(turn.T))])
    return Calibration(SENSORS["stereo"], J @ np.diag(variances) @ J.T, **lens), pose


def starry_night(folder: Path) -> Sightings:
    """Barfoot's "starry night": a stereo camera with a gyro over 20 points, with the noise that the file states."""
    m = {name: np.squeeze(value) for name, value in matlab(folder / "dataset3.mat").items() if name[0] != "_"}
    poses = np.concatenate([m["r_i_vk_i"].T, quaternion.exponential(m["theta_vk_i"].T)], axis=1)
    times, noise = m["t"] - m["t"][0], np.concatenate([m["v_var"], m["w_var"]])
    velocities = np.concatenate([m["v_vk_vk_i"], m["w_vk_vk_i"]]).T
    frames = tracked(times, velocities, noise, m["y_k_j"].transpose(1, 2, 0))
    camera = stereo(m["y_var"], [m["cu"], m["cv"], m["fu"], m["fv"]], m["b"], m["C_c_v"], m["rho_v_c_v"])
    points = dict(enumerate(m["rho_i_pj_i"].T))
    return Sightings(frames, [poses[0]], [camera], [Trajectory(times, poses)], points, free=SPACE)


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
            found = {codes.get(int(code), 0): level(*z)[0] for _, code, *z in m[m[:, 0] == now]}
            tubes = {subject: z for subject, z in found.items() if subject > len(rows)}
            met = [(i, robots.index(subject), z) for subject, z in found.items() if subject in robots]
            meetings[k] = meetings.get(k, []) + met
            scans.append(Scan({"points": Features(np.array([*tubes], int), np.reshape([*tubes.values()], (-1, 3)))}))
        frames.append(Frame(k, float(dt), tuple(own[k - 1] for own in controls), tuple(scans)))
    truths = []
    for t, x, y, heading in (g.T for g in true):
        at = np.concatenate([[begin], np.unique(t[t > begin])])
        columns = (np.interp(at, t, column) for column in (x, y, np.unwrap(heading)))
        truths.append(Trajectory(at - begin, planar(*columns)))
    sensor = scanner(*SEEN_STD), planar(0.0, 0.0, 0.0)
    points = {int(n): np.array([x, y, 0.0]) for n, x, y, *_ in np.loadtxt(folder / "Landmark_Groundtruth.dat")}
    return Sightings(frames, [t.poses[0] for t in truths], [sensor] * len(robots), truths, points, meetings)


def driven(odometry: Array, instants: Array) -> list[Control]:
    """What speeds and turn rates (n, 3), with their times, amount to between instants, each valid until the next."""
    times, v, w = odometry.T
    dt = np.diff(times)
    heading = np.concatenate([[0.0], np.cumsum(w[:-1] * dt)])
    middle = heading[:-1] + w[:-1] * dt / 2
    way = np.cumsum((v[:-1] * dt)[:, None] * np.column_stack([np.cos(middle), np.sin(middle)]), axis=0)
    x, y = np.concatenate([np.zeros((1, 2)), way]).T
    poses = planar(*(np.interp(instants, times, column) for column in (x, y, heading)))
    steps, spans = Pose.minus(poses[1:], poses[:-1]), np.diff(instants)
    steps[:, :3] = relative(poses[:-1], poses[1:])[:, :3]
    speeds = np.column_stack([np.hypot(*steps[:, :2].T), steps[:, 5]]) / spans[:, None]
    rates = spans[:, None] * (SLIP + BY_SPEED * speeds**2)
    return [Control(u, np.diag([q, q, 0, 0, 0, p])) for u, (q, p) in zip(steps, rates, strict=True)]
