"""Builders of setups from what is at hand: a robot by its motion, a sensor by its calibration; all checked at once.

The builders of cameras take K: the matrix (3, 3) of the intrinsics, without skew, or (u0, v0, au, av) [px]: the
principal point, then the focal lengths. OpenCV's order (fx, fy, cx, cy) is another one. image: (width, height) [px];
by default the image whose middle is the principal point; None: an image without a border.

noise: one standard deviation for all numbers of a measurement, one for each, or their covariance, in the units of the
measurement. All other arguments are fields of the setup that is returned, among them position [m] and euler [deg] in
the robot's frame. Where no euler is given, cameras look ahead, and sensors of other types have the robot's axes.
"""

from collections.abc import Iterable, Mapping
from typing import TypedDict, Unpack

import numpy as np
from numpy.typing import ArrayLike

from slamlib.errors import ShapeError, SlamlibError, UnknownNameError
from slamlib.manifolds import Array, finite, numbers
from slamlib.motions import Motion
from slamlib.rigs.setup import ZERO, Numbers, RobotSetup, SensorSetup
from slamlib.sensors import sensor

Image = tuple[float, float] | tuple[()] | None
CENTRED: tuple[()] = ()  # the image whose middle is the principal point
# What is beyond these is mostly a number of another unit or place: refused here, and taken by the setups themselves.
SQUARE = 0.6  # ratio of a pixel's sides
BASELINES = 0.001, 5.0  # [m]
ANY_ANGLE = float(np.pi / np.sqrt(3))  # [rad]: the standard deviation of an angle between -pi and pi, all alike
IF_RIGHT = "If it is right, make the setup by hand: slamlib.SensorSetup(type=..., parameters=...)"


class RobotFields(TypedDict, total=False):
    """Fields of a RobotSetup that a builder passes on."""

    name: str
    position: Numbers
    euler: Numbers
    velocity: Numbers
    position_std: Numbers
    orientation_std: Numbers
    velocity_std: Numbers
    control: Numbers


class SensorFields(TypedDict, total=False):
    """Fields of a SensorSetup that a builder passes on."""

    name: str
    robot: int
    position: Numbers
    euler: Numbers
    estimated: bool
    position_std: Numbers
    orientation_std: Numbers
    limits: dict[str, float]
    landmark: str | None


def robot(motion: Motion | str = "odometry", noise: ArrayLike = 0.0, **setup: Unpack[RobotFields]) -> RobotSetup:
    """A robot that moves by `motion`, with the noise of one step's control: standard deviations (c,) or covariance.

    motion: by its name, or one of your own. noise is in the control's own units, metres and radians; control and
    euler are in degrees, as in every setup. Raises SlamlibError.

        >>> import slamlib as sl
        >>> rover = sl.robot("odometry", noise=[0.01, 0.01, 0, 0, 0, 0.002], position=(0, -5, 0))
        >>> rover.noise.diagonal().round(6).tolist()
        [0.0001, 0.0001, 0.0, 0.0, 0.0, 4e-06]
    """
    _check_names("robot", setup, RobotFields)
    made = RobotSetup(motion=motion, **setup)
    std, covariance = _std_or_covariance(noise, made.model.control, made.name)
    if covariance is not None:
        made = RobotSetup(motion=motion, control_covariance=_rows(covariance), **setup)
    else:
        angles = np.isin(np.arange(len(std)), made.model.angles)
        degrees = np.where(angles, np.degrees(std), std)
        made = RobotSetup(motion=motion, control_std=tuple(degrees.tolist()), **setup)
    _ = made.state, made.covariance, made.nominal, made.noise  # computed when asked for: what is wrong is said here
    return made


def camera(
    K: ArrayLike,
    distortion: ArrayLike = (),
    *,
    image: Image = CENTRED,
    noise: ArrayLike = 1.0,
    **setup: Unpack[SensorFields],
) -> SensorSetup:
    """A pin-hole camera, which measures pixels (u, v); see the module for K, image and noise. Raises SlamlibError.

    distortion: up to eight radial coefficients, of r^2, r^4, ...; for OpenCV's list see `brown_conrady`.

        >>> import numpy as np
        >>> import slamlib as sl
        >>> K = np.array([[400, 0, 320], [0, 400, 240], [0, 0, 1]])
        >>> sl.camera(K, position=(0, 0, 0.6)).calibration.project([0.5, 0, 2, 1]).tolist()
        [420.0, 240.0]
    """
    parameters = {"intrinsics": intrinsics(K, "camera"), "distortion": distortion}
    return _sensor("camera", "pinHole", parameters, noise, setup, image)


def brown_conrady(
    K: ArrayLike,
    distortion: ArrayLike,
    *,
    image: Image = CENTRED,
    noise: ArrayLike = 1.0,
    **setup: Unpack[SensorFields],
) -> SensorSetup:
    """A pin-hole camera with radial and tangential distortion, which measures pixels (u, v). As `camera`.

    distortion: OpenCV's k1 k2 p1 p2, then k3, then k4 k5 k6: 4, 5 or 8 numbers, as its calibrateCamera returns them.

        >>> import slamlib as sl
        >>> kinect = sl.brown_conrady([318.6, 255.3, 517.3, 516.5], [0.2624, -0.9531, -0.0054, 0.0026, 1.1633])
        >>> kinect.calibration.project([0.5, 0, 2, 1]).round(1).tolist()
        [449.9, 255.1]
    """
    parameters = {"intrinsics": intrinsics(K, "brown_conrady"), "distortion": np.ravel(distortion)}
    return _sensor("Brown-Conrady camera", "brownConrady", parameters, noise, setup, image)


def davison(
    K: ArrayLike,
    distortion: float,
    *,
    image: Image = CENTRED,
    noise: ArrayLike = 1.0,
    **setup: Unpack[SensorFields],
) -> SensorSetup:
    """Davison's wide-angle camera, which measures pixels (u, v); one coefficient of distortion. As `camera`.

    >>> import slamlib as sl
    >>> sl.davison([320, 240, 400, 400], 0.1).calibration.project([0.5, 0, 2, 1]).round(1).tolist()
    [419.4, 240.0]
    """
    parameters: dict[str, ArrayLike] = {"intrinsics": intrinsics(K, "davison"), "distortion": distortion}
    return _sensor("davison", "davison", parameters, noise, setup, image)


def fisheye(
    K: ArrayLike,
    distortion: ArrayLike = (),
    *,
    image: Image = CENTRED,
    noise: ArrayLike = 1.0,
    **setup: Unpack[SensorFields],
) -> SensorSetup:
    """An equidistant fisheye camera, which measures pixels (u, v); OpenCV's four coefficients. As `camera`.

    limits: "angle" [rad], half the field of view.

        >>> import slamlib as sl
        >>> lens = sl.fisheye([320, 240, 200, 200], [0.02, 0.001], limits={"angle": 1.6})
        >>> lens.calibration.project([1, 0, 0, 1]).round(1).tolist()  # a right angle off the axis
        [651.6, 240.0]
    """
    parameters = {"intrinsics": intrinsics(K, "fisheye"), "distortion": distortion}
    return _sensor("fisheye", "fisheye", parameters, noise, setup, image)


def unified(
    K: ArrayLike,
    distortion: ArrayLike,
    *,
    image: Image = CENTRED,
    noise: ArrayLike = 1.0,
    **setup: Unpack[SensorFields],
) -> SensorSetup:
    """A wide-angle camera or one with a mirror, by the unified model, which measures pixels (u, v). As `camera`.

    distortion: xi, then k1, k2, p1, p2, k3 as far as they are known: OpenCV's omnidir, Kalibr's omni,
    camodocal's MEI. limits: "angle" [rad], half the field of view.

        >>> import slamlib as sl
        >>> lens = sl.unified([320, 240, 200, 200], [1.6, -0.1])
        >>> lens.calibration.project([1, 0, 0, 1]).round(1).tolist()  # a right angle off the axis
        [440.1, 240.0]
    """
    parameters = {"intrinsics": intrinsics(K, "unified"), "distortion": distortion}
    return _sensor("unified camera", "unified", parameters, noise, setup, image)


def extended_unified(
    K: ArrayLike,
    distortion: ArrayLike,
    *,
    image: Image = CENTRED,
    noise: ArrayLike = 1.0,
    **setup: Unpack[SensorFields],
) -> SensorSetup:
    """A wide-angle camera by the extended unified model, which measures pixels (u, v). As `camera`.

    distortion: alpha and beta, Kalibr's eucm. limits: "angle" [rad], half the field of view.

        >>> import slamlib as sl
        >>> lens = sl.extended_unified([320, 240, 200, 200], [0.6, 1.1])
        >>> lens.calibration.project([1, 0, 0, 1]).round(1).tolist()  # a right angle off the axis
        [637.8, 240.0]
    """
    parameters = {"intrinsics": intrinsics(K, "extended_unified"), "distortion": distortion}
    return _sensor("extended unified camera", "extendedUnified", parameters, noise, setup, image)


def double_sphere(
    K: ArrayLike,
    distortion: ArrayLike,
    *,
    image: Image = CENTRED,
    noise: ArrayLike = 1.0,
    **setup: Unpack[SensorFields],
) -> SensorSetup:
    """A wide-angle camera by the double-sphere model, which measures pixels (u, v). As `camera`.

    distortion: xi and alpha, Kalibr's ds. limits: "angle" [rad], half the field of view.

        >>> import slamlib as sl
        >>> lens = sl.double_sphere([320, 240, 200, 200], [-0.2, 0.55])
        >>> lens.calibration.project([1, 0, 0, 1]).round(1).tolist()  # a right angle off the axis
        [744.7, 240.0]
    """
    parameters = {"intrinsics": intrinsics(K, "double_sphere"), "distortion": distortion}
    return _sensor("double-sphere camera", "doubleSphere", parameters, noise, setup, image)


def omnidirectional(
    centre: ArrayLike,
    lens: ArrayLike,
    *,
    affine: ArrayLike = (1.0, 0.0, 0.0),
    image: Image = CENTRED,
    noise: ArrayLike = 1.0,
    **setup: Unpack[SensorFields],
) -> SensorSetup:
    """An omnidirectional camera, which measures pixels (u, v): centre (xc, yc) [px], lens, affine part (c, d, e).

    lens: the radius [px] by powers 1, 3, 4, ... of the angle; slamlib.sensors.scaramuzza.polynomials finds it from a
    published calibration. limits: "angle" [rad], half the field of view. image, noise: as `camera`.

        >>> import slamlib as sl
        >>> mirror = sl.omnidirectional((500, 400), [250.0], limits={"angle": 1.8})
        >>> mirror.calibration.project([1, 0, 0, 1]).round(1).tolist()  # a right angle off the axis
        [892.7, 400.0]
    """
    shape = [*finite(centre, (2,), "omnidirectional", "centre"), *finite(affine, (3,), "omnidirectional", "affine")]
    return _sensor("omnidirectional", "omniCam", {"intrinsics": np.array(shape), "lens": lens}, noise, setup, image)


def depth_camera(
    K: ArrayLike,
    distortion: ArrayLike = (),
    *,
    image: Image = CENTRED,
    noise: ArrayLike = (1.0, 1.0, 0.01),
    **setup: Unpack[SensorFields],
) -> SensorSetup:
    """A depth camera (RGB-D), which measures pixels with their depth (u, v, z) [px, px, m]. As `camera`.

    limits: "near" and "far" [m].

        >>> import slamlib as sl
        >>> kinect = sl.depth_camera([320, 240, 525, 525], noise=(1, 1, 0.02), limits={"far": 4.0})
        >>> kinect.calibration.project([0.4, 0, 2, 1]).round(1).tolist()
        [425.0, 240.0, 2.0]
    """
    parameters = {"intrinsics": intrinsics(K, "depth_camera"), "distortion": distortion}
    return _sensor("depth camera", "pinHoleDepth", parameters, noise, setup, image)


def stereo(
    K: ArrayLike,
    baseline: float,
    *,
    image: Image = CENTRED,
    noise: ArrayLike = 1.0,
    **setup: Unpack[SensorFields],
) -> SensorSetup:
    """A rectified stereo pair with a baseline [m], which measures left pixels with disparity (u, v, d). As `camera`.

    limits: "disparity" [px], the least.

        >>> import slamlib as sl
        >>> pair = sl.stereo([320, 240, 400, 400], baseline=0.12, noise=0.5)
        >>> pair.calibration.project([0.5, 0, 2, 1]).round(1).tolist()
        [420.0, 240.0, 24.0]
    """
    length = float(finite(baseline, (), "stereo", "baseline"))
    if length > 0 and not BASELINES[0] <= length <= BASELINES[1]:
        raise SlamlibError(f"stereo: is a baseline of {length:g} m right, or is it in another unit? {IF_RIGHT}")
    parameters: dict[str, ArrayLike] = {"intrinsics": intrinsics(K, "stereo"), "baseline": baseline}
    return _sensor("stereo", "stereo", parameters, noise, setup, image)


def range_bearing(noise: ArrayLike, **setup: Unpack[SensorFields]) -> SensorSetup:
    """A laser scanner, radar or sonar: distance, yaw and pitch [m, rad, rad] of points; in the plane without the pitch.

    noise: two standard deviations or a covariance (2, 2) for one in the plane; three or (3, 3) for one in space.
    limits: "near", "far" [m], "bearing" [rad] in the plane, "yaw", "pitch" [rad] in space. Raises SlamlibError.

        >>> import numpy as np
        >>> import slamlib as sl
        >>> laser = sl.range_bearing(noise=[0.05, np.radians(0.5)], limits={"far": 30.0})
        >>> laser.calibration.project([3, 4, 0, 1]).round(3).tolist()
        [5.0, 0.927]
        >>> sonar = sl.range_bearing(noise=[0.05, *np.radians([0.5, 0.5])])
        >>> sonar.calibration.project([3, 4, -12, 1]).round(3).tolist()
        [13.0, 0.927, 1.176]
    """
    in_plane = np.shape(numbers(noise, "range and bearing", "noise")) in ((2,), (2, 2))
    return _sensor("range and bearing", "planeRangeBearing" if in_plane else "rangeBearing", {}, noise, setup)


def bearing_only(noise: ArrayLike, **setup: Unpack[SensorFields]) -> SensorSetup:
    """A sensor in the plane that measures bearings [rad] alone, to the left of its front. As `range_bearing`.

    limits: "bearing" [rad].

        >>> import numpy as np
        >>> import slamlib as sl
        >>> sl.bearing_only(noise=np.radians(1.0)).calibration.project([3, 4, 0, 1]).round(3).tolist()
        [0.927]
    """
    return _sensor("bearing only", "planeBearing", {}, noise, setup)


def range_only(noise: ArrayLike, **setup: Unpack[SensorFields]) -> SensorSetup:
    """A sensor in the plane that measures distances [m] alone, as radio beacons give them. As `range_bearing`.

    It updates landmarks that another sensor has initialized: of one distance a point may lie in any direction, which no
    Gaussian describes. limits: "near", "far" [m].

        >>> import slamlib as sl
        >>> sl.range_only(noise=0.1).calibration.project([3, 4, 0, 1]).tolist()
        [5.0]
    """
    return _sensor("range only", "planeRange", {}, noise, setup)


def relative_position(noise: ArrayLike, **setup: Unpack[SensorFields]) -> SensorSetup:
    """A sensor that measures the position (x, y, z) [m] of points in its own frame.

    noise: one standard deviation, one for each (3,), or their covariance (3, 3). limits: "near", "far" [m]. Raises
    SlamlibError.

        >>> import slamlib as sl
        >>> tracker = sl.relative_position(noise=0.02)
        >>> tracker.calibration.project([3, 4, 0, 2]).tolist()  # homogeneous: divided by its last number
        [1.5, 2.0, 0.0]
    """
    return _sensor("relative position", "relativePosition", {}, noise, setup)


def intrinsics(K: ArrayLike, function: str) -> Array:
    """The intrinsics (u0, v0, au, av) [px] of a matrix (3, 3) without skew, or as they are. Raises SlamlibError."""
    given = numbers(K, function, "K")
    if given.shape not in ((4,), (3, 3)):
        raise ShapeError(f"{function}: K is a matrix (3, 3), or (u0, v0, au, av), and has shape {given.shape}")
    found = given if given.ndim == 1 else np.array([given[0, 2], given[1, 2], given[0, 0], given[1, 1]])
    u0, v0, au, av = finite(found, (4,), function, "K").tolist()
    if given.ndim == 2 and not np.array_equal(given, [[au, 0, u0], [0, av, v0], [0, 0, 1]]):
        raise SlamlibError(
            f"{function}: K is [[au, 0, u0], [0, av, v0], [0, 0, 1]], without skew, and was given as {given.tolist()}"
        )
    if min(au, av) > 0 and not SQUARE < au / av < 1 / SQUARE:
        factor = max(au / av, av / au)
        raise SlamlibError(
            f"{function}: the focal lengths {au:g} and {av:g} px differ by a factor of {factor:.3g}, and pixels are "
            f"nearly square: is one of them wrong, or their order (u0, v0, au, av)? {IF_RIGHT}"
        )
    return found


def _sensor(
    name: str,
    kind: str,
    parameters: Mapping[str, ArrayLike],
    noise: ArrayLike,
    setup: SensorFields,
    image: Image = None,
) -> SensorSetup:
    """The setup of a sensor of this type."""
    _check_names(name, setup, SensorFields)
    type_ = sensor(kind)
    std, covariance = _std_or_covariance(noise, type_.size, name)
    stds = np.broadcast_to(std, type_.size) if covariance is None else np.sqrt(np.abs(covariance.diagonal()))
    if (stds[type_.angles] > ANY_ANGLE).any():
        raise SlamlibError(
            f"{name}: a direction of which nothing is known has a standard deviation of {ANY_ANGLE:.2f} rad, and the "
            f"noise of an angle is {stds[type_.angles].max():g}: angles are in radians (np.radians)"
        )
    if image is CENTRED:
        u0, v0 = np.asarray(parameters["intrinsics"])[:2].tolist()
        image = (2 * u0, 2 * v0)
    own: SensorFields = {"name": name} if type_.pixels else {"name": name, "euler": ZERO}
    fields: SensorFields = {**own, **setup}
    made = SensorSetup(
        type=kind,
        std=tuple(std.tolist()),
        noise=None if covariance is None else _rows(covariance),
        image=image,
        parameters={key: tuple(np.atleast_1d(numbers(value, name, key)).tolist()) for key, value in parameters.items()},
        **fields,
    )
    _ = made.extrinsics, made.covariance, made.calibration  # made when asked for: what is wrong with it is said here
    return made


def _std_or_covariance(noise: ArrayLike, size: int, name: str) -> tuple[Array, Array | None]:
    """Standard deviations (size,), and the covariance (size, size) where that was given. Raises SlamlibError."""
    given = numbers(noise, name, "noise")
    if given.shape not in ((), (size,), (size, size)):
        raise ShapeError(
            f"{name}: noise is one standard deviation, {size} of them, or a covariance ({size}, {size}), "
            f"and has shape {given.shape}"
        )
    given = finite(given, given.shape, name, "noise")
    if given.ndim == 2:
        return np.ones(1), given
    if not (given >= 0).all():
        raise SlamlibError(f"{name}: standard deviations are zero or more, and noise is {given.tolist()}")
    return np.broadcast_to(given, (size,)), None


def _rows(matrix: Array) -> tuple[Numbers, ...]:
    return tuple(map(tuple, matrix.tolist()))


def _check_names(builder: str, setup: Iterable[str], known: type) -> None:
    """Raise UnknownNameError for an argument that the builder does not pass on."""
    for name in setup:
        if name not in known.__annotations__:
            raise UnknownNameError.of(f"argument of the builder of a {builder}", name, known.__annotations__)
