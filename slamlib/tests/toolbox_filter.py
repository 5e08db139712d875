"""Our filter with our corrections of the toolbox switched off, one by one, for a replay of its recorded runs.

Each name of SWITCHES undoes one correction. The formulas are the facts of the runs; the models are ours.
"""

from dataclasses import dataclass

import numpy as np

from slamlib.entities import RigSensor
from slamlib.geometry import plucker
from slamlib.geometry.pose import compose
from slamlib.geometry.quaternion import rotation
from slamlib.landmarks import idp_point
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.landmarks.linearity import to_euclidean
from slamlib.observation.family import Innovation, PredictedBatch, state_columns
from slamlib.observation.points import PointFamily
from slamlib.observation.segments import LineFamily
from slamlib.slam import Slam
from slamlib.slam.data_association.front_end import FrontEndInput, match
from slamlib.slam.data_association.selection import select
from slamlib.slam.measurement_update import convert, update_sequentially

SWITCHES = {
    "selection": "by det(E) of the expectation alone, not by det(Z) with the noise (errata E57)",
    "at once": "a point is converted right after its own correction, not after all corrections of the sensor",
    "index": "by the linearity index of the toolbox, not by that of chapter points",
    "reset": "a negative inverse distance becomes 0.001, and its covariance stays (no point is deleted for it)",
    "seven": "the pose is a vector of seven numbers, normalised with I / |q|, its Jacobians along |q| the toolbox's",
}


def by_determinant(E, count):
    """The largest determinants first."""
    return np.argsort(-np.linalg.det(E), kind="stable")[:count]


@dataclass(eq=False)
class SevenSensor(RigSensor):
    """A sensor whose robot's pose has seven rows in the covariance."""

    @property
    def columns(self):
        return self.robot.block.start + np.arange(7)


def camera_of(sensor):
    """The camera's pose, and its Jacobian by the robot's pose: by six numbers of the tangent space or by all seven."""
    seven = isinstance(sensor, SevenSensor)
    camera, J = (compose.storage_jac if seven else compose.jac)(sensor.robot.pose, sensor.extrinsics)
    return camera, J.outer


def jac(sensor, model, *arguments):
    return (model.storage_jac if isinstance(sensor, SevenSensor) else model.jac)(*arguments)


def in_camera(sensor, kind, means):
    """Homogeneous points in the camera (n, 4), their Jacobians by the robot's pose and by the landmarks.

    With seven numbers of a pose they are the toolbox's, which differ from ours along |q| alone, where no unit
    quaternion has an error, but a covariance of four numbers has: it goes by the robot's frame and then the camera's,
    instead of composing them, and turns the bearing of an idpPnt into two angles, which do not grow with |q|^2.
    """
    if not isinstance(sensor, SevenSensor):
        camera, by_robot = camera_of(sensor)
        h, F = kind.to_frame.jac(camera, means)
        return h, F.pose @ by_robot, F.landmark
    q, (to_camera, by_point) = sensor.robot.pose[3:], EUC_POINT.to_frame.jac(sensor.extrinsics, np.zeros(3))
    h, F = kind.to_frame.storage_jac(sensor.robot.pose, means)
    by_pose = F.pose.copy()
    if kind is idp_point.IDP_POINT:
        bearing = idp_point.direction(means[..., 3:5]) @ rotation(q)
        by_pose[..., :3, 3:] -= 2 * bearing[..., None] * q
    H = np.column_stack([by_point.landmark, to_camera])
    return h @ H.T, H @ by_pose, H @ F.landmark


@dataclass(frozen=True)
class Points(PointFamily):
    """Points, with switches."""

    switches: frozenset = frozenset()

    def _observe(self, sensor, kind, means):
        h, by_robot, by_landmark = in_camera(sensor, kind, means)
        seen = sensor.calibration.visible(h)
        value, S = sensor.calibration.project_jac(np.where(seen[..., None], h, np.array([0.25, 0.5, 1, 1])))
        by = np.concatenate([S.point @ by_robot, S.point @ by_landmark], axis=-1)
        return value, seen & sensor.calibration.inside(value), by

    def predict_batch(self, view, group, options):
        landmarks = group.landmarks
        value, seen, by = self._observe(view.sensor, group.kind, group.means())
        looked = [lm for lm, is_seen in zip(landmarks, seen, strict=True) if is_seen]
        return PredictedBatch(
            looked, value[seen], value[seen], by[seen], state_columns(view.sensor, landmarks)[seen], options
        )

    def innovation(self, view, landmark, measured, options):
        sensor = view.sensor
        value, _, by = self._observe(sensor, landmark.kind, landmark.block.mean)
        return Innovation(measured - value, by, sensor.calibration.noise)

    def initialize(self, sensor, kind, value, options):
        x, own, jacobians = super().initialize(sensor, kind, value, options)
        if isinstance(sensor, SevenSensor):
            camera, by_robot = camera_of(sensor)
            ray, _ = sensor.calibration.back_project_jac(value, np.array([options.inverse_distance[0]]))
            jacobians = [kind.from_frame.storage_jac(camera, ray)[1].pose @ by_robot]
        return x, own, jacobians

    def after_update(self, belief, sensor, landmarks, measured, options):
        if "reset" in self.switches:
            for landmark in landmarks:
                reset(belief, landmark, [5])
        if "index" not in self.switches:
            if not isinstance(sensor, SevenSensor):
                super().after_update(belief, sensor, landmarks, measured, options)
            return
        camera = camera_of(sensor)[0]
        for landmark in landmarks:
            if landmark.kind is not EUC_POINT and self._index(belief, landmark, camera[:3]) < options.convert_below:
                belief.replace(landmark.block, 3, *to_euclidean(landmark.kind, landmark.block.mean))
                landmark.kind = EUC_POINT

    def _index(self, belief, landmark, eye):
        """Four standard deviations of the distance from the anchor, by the distance, times a cosine."""
        x, m = landmark.block.mean, idp_point.direction(landmark.block.mean[3:5])
        away = landmark.kind.to_point(x) - eye
        distance = np.linalg.norm(away)
        sigma = np.sqrt(belief.covariance(landmark.block)[5, 5]) / x[5] ** 2
        return 4 * sigma / distance * abs(m @ away / distance)

    def invalid(self, belief, landmarks):
        return set() if "reset" in self.switches else super().invalid(belief, landmarks)

    def certainty(self, belief, sensor, landmark):
        """E of a predicted measurement."""
        _, _, by = self._observe(sensor, landmark.kind, landmark.block.mean)
        at = state_columns(sensor, [landmark])[0]
        return by @ belief.matrix[np.ix_(at, at)] @ by.T


@dataclass(frozen=True)
class Lines(LineFamily):
    """Lines idpLin, with switches."""

    switches: frozenset = frozenset()

    def predict_batch(self, view, group, options):
        found, sensor = super().predict_batch(view, group, options), view.sensor
        if not found.landmarks or not isinstance(sensor, SevenSensor):
            return found
        rows = [self._line(sensor, lm) for lm in found.landmarks]
        by = np.array([row[1] for row in rows])
        return PredictedBatch(
            found.landmarks, found.value, found.innovation_input, by, state_columns(sensor, found.landmarks), options
        )

    def _line(self, sensor, landmark):
        """By the robot's frame and then the camera's, as the toolbox does; here bearings do grow with |q|^2."""
        line, F = jac(sensor, landmark.kind.to_frame, sensor.robot.pose, landmark.block.mean)
        line, J = plucker.to_frame.jac(sensor.extrinsics, line)
        return line, J.line @ np.concatenate([F.pose, F.landmark], axis=-1)

    def innovation(self, view, landmark, measured, options):
        return self.residual(view.sensor, *self._line(view.sensor, landmark), measured, options)

    def initialize(self, sensor, kind, value, options):
        x, own, jacobians = super().initialize(sensor, kind, value, options)
        if isinstance(sensor, SevenSensor):
            camera, by_robot = camera_of(sensor)
            rays = sensor.calibration.back_project_jac(value.reshape(2, 2), np.ones((2, 1)))[0][:, :3].ravel()
            prior = np.array(options.line_prior(kind.name)[0])
            jacobians = [kind.from_frame.storage_jac(camera, rays, prior)[1].pose @ by_robot]
        return x, own, jacobians

    def after_update(self, belief, sensor, landmarks, measured, options):
        if "reset" in self.switches:
            for landmark in landmarks:
                reset(belief, landmark, [5, 8])

    def certainty(self, belief, sensor, landmark):
        """E (3, 3) of the homogeneous image line through two pixels, its normal of unit length."""
        camera, by_robot = camera_of(sensor)
        x = landmark.block.mean
        pixels, parts = [], []
        for own in ([0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8]):
            h, F = jac(sensor, idp_point.to_frame, camera, x[own])
            pixel, S = sensor.calibration.project_jac(h)
            by = np.zeros((3, by_robot.shape[1] + 9))
            by[:2, : by_robot.shape[1]] = S.point @ F.pose @ by_robot
            by[:2, by_robot.shape[1] + np.array(own)] = S.point @ F.landmark
            pixels.append(np.append(pixel, 1.0))
            parts.append(by)
        line = np.cross(*pixels)
        by = (np.cross(parts[0].T, pixels[1]) + np.cross(pixels[0], parts[1].T)).T / np.linalg.norm(line[:2])
        at = state_columns(sensor, [landmark])[0]
        return by @ belief.matrix[np.ix_(at, at)] @ by.T


def reset(belief, landmark, places):
    """All inverse distances become 0.001 if any is negative; the covariance stays."""
    x = landmark.block.mean.copy()
    places = [i for i in places if len(x) > 3]
    if places and (x[places] < 0).any():
        x[places] = 0.001
        belief.replace(landmark.block, landmark.block.manifold, x, np.eye(len(x)))


class ToolboxFilter(Slam):
    """The filter with some of our corrections switched off."""

    def __init__(self, rig, options, switches=()):
        super().__init__(rig, options=options)
        self.switches = frozenset(switches)
        self.families = {"points": Points(self.switches), "segments": Lines(self.switches)}
        if "seven" in self.switches:
            robot = self.robots[0]
            self.belief.replace(robot.block, 7, robot.pose, np.zeros((7, 6)))  # the start is known exactly
            self.state.sensors = [SevenSensor(**vars(s)) for s in self.sensors]

    def _normalise(self):
        block = self.robots[0].block
        if "seven" in self.switches:
            length = np.linalg.norm(block.mean[3:])
            shorten = np.diag([1.0] * 3 + [1 / length] * 4)
            self.belief.replace(block, 7, shorten @ block.mean, shorten)

    def _predict(self, robot, control, dt):
        if "seven" not in self.switches:
            super()._predict(robot, control, dt)
            return
        self._normalise()
        state, J = robot.motion.step.storage_jac(robot.block.mean, control.value, dt)
        self.belief.predict(robot.block, state, J.state, J.control @ control.covariance @ J.control.T)

    def _update(self, i, scan):
        sensor = self.sensors[i]
        self._normalise()
        predictions = self.project(i)
        if "selection" in self.switches:
            for prediction in predictions:
                E = prediction.family.certainty(self.belief, sensor, prediction.landmark)
                batch = prediction.batch
                prediction.batch = batch._replace(S=np.broadcast_to(E, (len(batch.landmarks), *E.shape)))
        inputs, front_end = FrontEndInput(scan, sensor, predictions), self.front_ends[i]
        matched = match(inputs, front_end, select(inputs, front_end, self.options.selection, self.options.updates))
        if "at once" in self.switches:
            for prediction in matched:
                self._one(sensor, prediction)
        else:
            update_sequentially(self.belief, sensor, matched, self.options, moved=True)
            convert(self.belief, sensor, matched, self.options)
        self.scans[i], self.predictions[i] = scan, predictions
        self._normalise()

    def _one(self, sensor, prediction):
        self._normalise()
        prediction.batch.columns[prediction.row] = state_columns(sensor, [prediction.landmark])[0]
        update_sequentially(self.belief, sensor, [prediction], self.options, moved=True)
        self._normalise()
        convert(self.belief, sensor, [prediction], self.options)
