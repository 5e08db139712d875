"""The checks report which definition is wrong, in which argument, where and by how much; nothing wrong passes."""

import dataclasses

import numpy as np
import pytest
import sympy

from slamlib.analytic import cos, exp, log, sin, sqrt
from slamlib.checks import CheckError, check_landmark, check_motion, check_pair, check_sensor, line_pairs
from slamlib.checks.judge import Judge
from slamlib.checks.models import JACOBIAN, derivatives
from slamlib.checks.sensors import visible_points
from slamlib.codegen import assert_same, derive
from slamlib.errors import SingularPointError, SlamlibError
from slamlib.geometry.moved import Parts, number, vector
from slamlib.geometry.pose import Pose, compose
from slamlib.geometry.pose2 import Pose2, from_space
from slamlib.geometry.quaternion import rotation
from slamlib.landmarks import LINES, POINTS
from slamlib.landmarks.idp_point import angles_of, direction
from slamlib.landmarks.parametrization import PointLandmark
from slamlib.manifolds import as_manifold
from slamlib.models import AtMost, model
from slamlib.motions import CONSTANT_VELOCITY, MOTIONS, ODOMETRY
from slamlib.observation import lines
from slamlib.observation.points import NamedJacobians
from slamlib.sensors import SENSORS, Calibration
from slamlib.slam import Options
from slamlib.tests.line_chains import check_chains
from slamlib.tests.test_every_type import example


@model(pose=Pose, point=4)
def turned_back(pose, point):
    """An anchored point whose ray is not turned into the world but once more into the camera."""
    return np.concatenate([pose[:3], rotation(pose[3:]).T @ point[:3], point[3:]])


@model(pose=Pose, landmark=7)
def divided(pose, landmark):
    """A Euclidean point where a homogeneous one is wanted: it has no points at infinity."""
    point = landmark[:3] + landmark[3:6] / landmark[6] - pose[:3]
    return np.concatenate([rotation(pose[3:]).T @ point, np.array([1])])


@model(landmark=7)
def nearer(landmark):
    """The point, one percent too near."""
    return landmark[:3] + landmark[3:6] / landmark[6] * 99 / 100


@model(point=3)
def other_argument(point):
    """Takes something else."""
    return point


@model(pose=Pose, landmark=6)
def log_to_frame(pose, landmark):
    """The homogeneous point of (anchor, elevation, azimuth, logarithm of the distance)."""
    inverse_distance = exp(-landmark[5])
    h = direction(landmark[3:5]) + inverse_distance * (landmark[:3] - pose[:3])
    return np.concatenate([rotation(pose[3:]).T @ h, np.array([inverse_distance])])


@model(pose=Pose, point=4)
def log_from_frame(pose, point):
    """Anchored at the frame's origin; the distance is positive and finite."""
    h, w = point[:3], point[3]
    return np.concatenate([pose[:3], angles_of(rotation(pose[3:]) @ h), np.array([log(sqrt(h @ h) / w)])])


@model(landmark=6)
def log_to_point(landmark):
    """The point in the world."""
    return landmark[:3] + direction(landmark[3:5]) * exp(landmark[5])


@model(pair=2)
def grown(pair):
    """Exponentials and logarithms, within each other."""
    x, y = pair
    return np.array([exp(x) * log(y), log(exp(x) + y * y), exp(-x / 2) ** 2])


def test_a_log_distance_landmark_can_be_written(capsys):
    check_landmark(PointLandmark("ldpPnt", as_manifold(6), log_to_frame, log_from_frame, log_to_point))
    assert "holds" in capsys.readouterr().out


@model(pose=Pose, landmark=7)
def distance_to_frame(pose, landmark):
    """Of anchor, unit direction and distance."""
    offset = landmark[6] * landmark[3:6] + landmark[:3] - pose[:3]
    return np.array([*(rotation(pose[3:]).T @ offset), 1])


@model(pose=Pose, point=4)
def distance_from_frame(pose, point):
    """The distance is the length of a difference, which far away is large and rounds as such."""
    ray = rotation(pose[3:]) @ (point[:3] / point[3])
    return np.array([*pose[:3], *(ray / sqrt(ray @ ray)), sqrt(ray @ ray)])


@model(landmark=7)
def distance_to_point(landmark):
    """Of anchor, unit direction and distance."""
    return landmark[:3] + landmark[6] * landmark[3:6]


def test_a_right_derivative_passes_although_a_large_value_rounds(capsys):
    check_landmark(PointLandmark("dstPnt", as_manifold(7), distance_to_frame, distance_from_frame, distance_to_point))
    assert "holds" in capsys.readouterr().out


@model(x=1)
def far_and_near(x):
    """A large number and a small one."""
    return np.array([x[0] + 10**9, x[0]])


@pytest.mark.parametrize(
    ("wrong", "right"), [([0, 0], True), ([1e-7, 0], True), ([0, 1e-7], False), ([1e-5, 0], False)]
)
def test_a_large_number_of_a_value_hides_no_error_beside_it(wrong, right):
    judge, place = Judge("far"), [np.array([0.5])]
    value, jacobians = far_and_near.jac(*place)
    derivatives(judge.at("far"), far_and_near, place, value, jacobians._replace(x=jacobians.x + np.array([wrong]).T))
    assert judge.lacks(JACOBIAN) is not right


def test_exponential_and_logarithm_are_proved_and_differentiated():
    made = derive(grown)
    x, y = made.symbols[0]
    assert_same(made.pair[0, 0], sympy.exp(x) * sympy.log(y), silent=True)
    assert_same(made.pair[1, 1], 2 * y / (sympy.exp(x) + y**2), silent=True)
    batch = np.random.default_rng(0).uniform(0.1, 3, (20, 2))
    value, jacobians = grown.jac(batch)
    steps = [grown.definition(batch.T + 1e-30j * np.eye(2)[:, [k]]).imag / 1e-30 for k in range(2)]
    assert value == pytest.approx(grown.definition(batch.T).T, rel=1e-14)
    assert jacobians.pair == pytest.approx(np.moveaxis(steps, (0, 1, 2), (2, 1, 0)), rel=1e-13, abs=1e-15)
    assert [grown(pair) for pair in batch] == [pytest.approx(v, rel=1e-14) for v in value]
    for outside in ([0.0, 0.0], [0.0, -1.0], [800.0, 1.0], [[0.0, 1.0], [0.0, -1.0]]):
        with pytest.raises(SingularPointError, match="grown is not defined"):
            grown(outside)


class WrongJacobian:
    """A model whose Jacobian by one argument has one wrong entry."""

    def __init__(self, right, argument):
        self.right, self.argument = right, argument
        self.arguments, self.parameters, self.definition = right.arguments, right.parameters, right.definition
        self.result = right.result

    def __call__(self, *args, **kwargs):
        return self.right(*args, **kwargs)

    def jac(self, *args, **kwargs):
        value, jacobians = self.right.jac(*args, **kwargs)
        wrong = getattr(jacobians, self.argument).copy()
        wrong[..., 1, 2] += 0.1
        return value, jacobians._replace(**{self.argument: wrong})


AHM = POINTS["ahmPnt"]


@pytest.mark.parametrize(
    ("change", "definition", "argument"),
    [
        ({"from_frame": turned_back}, "ahmPnt.from_frame", "point"),
        ({"to_frame": divided}, "ahmPnt.to_frame", "landmark"),
        ({"to_point": nearer}, "ahmPnt.from_frame", "pose"),
        ({"to_point": other_argument}, "ahmPnt.to_point", ""),
        ({"to_frame": WrongJacobian(AHM.to_frame, "landmark")}, "ahmPnt.to_frame", "landmark"),
        ({"from_frame": WrongJacobian(AHM.from_frame, "pose")}, "ahmPnt.from_frame", "pose"),
    ],
)
def test_a_wrong_landmark_is_found_and_named(change, definition, argument, capsys):
    with pytest.raises(CheckError) as caught:
        check_landmark(dataclasses.replace(AHM, **change))
    findings = caught.value.findings
    assert any(f.definition == definition and f.argument == argument for f in findings)
    assert str(caught.value).startswith("ahmPnt: ")
    assert "all" not in capsys.readouterr().out.splitlines()[-1:]


def test_a_finding_says_where_and_by_how_much():
    with pytest.raises(CheckError) as caught:
        check_landmark(dataclasses.replace(AHM, from_frame=turned_back), silent=True)
    finding = next(f for f in caught.value.findings if "ratio" in f.what)
    assert "pose = [" in finding.where
    assert "should be" in finding.how_much
    assert 0.1 < finding.error < 3
    assert caught.value._render_traceback_()[0].startswith("CheckError: ahmPnt")


def test_a_wrong_line_is_found():
    kind = LINES["ahmLin"]
    wrong = dataclasses.replace(kind, to_frame=WrongJacobian(kind.to_frame, "pose"))
    with pytest.raises(CheckError, match=r"ahmLin\.to_frame, argument 'pose'"):
        check_landmark(wrong, silent=True)
    with pytest.raises(CheckError, match="same point"):
        check_landmark(dataclasses.replace(kind, abscissas=(0.5, 0.5)), silent=True)


def without(function, argument):
    """A function that omits one of its Jacobians."""

    def forgetful(*args):
        found = function(*args)
        value, jacobians = found if isinstance(found, tuple) else (found.value, found.jacobians)
        jacobians = NamedJacobians(**{**vars(jacobians), argument: 0 * getattr(jacobians, argument)})
        return (value, jacobians) if isinstance(found, tuple) else dataclasses.replace(found, jacobians=jacobians)

    return forgetful


CAMERA = example(SENSORS["pinHole"])


@pytest.mark.parametrize(
    ("function", "argument"),
    [
        *(("observe_line", a) for a in ("robot", "extrinsics", "landmark", "intrinsics")),
        *(
            ("initialize_line", a)
            for a in ("robot", "extrinsics", "measurement", "unmeasured", "intrinsics", "distortion")
        ),
    ],
)
def test_a_jacobian_that_the_chain_of_lines_lacks_is_named(monkeypatch, function, argument):
    monkeypatch.setattr(lines, function, without(getattr(lines, function), argument))
    with pytest.raises(CheckError, match=f"argument '{argument}': the Jacobian is the derivative"):
        check_chains(LINES["plkLin"], CAMERA, segments=2)


@pytest.mark.parametrize(
    ("function", "argument"),
    [
        *(("observe_line", a) for a in ("robot", "extrinsics")),
        *(("initialize_line", a) for a in ("robot", "extrinsics", "measurement", "unmeasured")),
    ],
)
def test_a_line_that_does_not_follow_its_segment_is_found(monkeypatch, function, argument):
    right = getattr(line_pairs, function)

    def mistaken(*args):
        found = right(*args)
        value, jacobians = found if isinstance(found, tuple) else (found.value, found.jacobians)
        jacobians = NamedJacobians(**{**vars(jacobians), argument: getattr(jacobians, argument) + 0.1})
        return (value, jacobians) if isinstance(found, tuple) else dataclasses.replace(found, jacobians=jacobians)

    monkeypatch.setattr(line_pairs, function, mistaken)
    with pytest.raises(CheckError, match=f"argument '{argument}': and follows them, whatever"):
        check_pair(LINES["plkLin"], CAMERA, silent=True)


@model(line=6, intrinsics=4)
def image_of_the_direction(line, intrinsics):
    """A camera that takes the wrong half of a line's coordinates."""
    (a, b, c), (u0, v0, au, av) = line[3:], intrinsics
    return np.array([av * a, au * b, au * av * c - av * u0 * a - au * v0 * b])


def swapped(function):
    """Takes the endpoints of a segment for each other's columns and rows."""

    def mistaken(kind, calibration, robot, extrinsics, segment, prior):
        return function(kind, calibration, robot, extrinsics, np.asarray(segment)[..., [1, 0, 3, 2]], prior)

    return mistaken


def test_a_line_that_misses_its_segment_is_found(monkeypatch):
    kind, sensor = LINES["plkLin"], dataclasses.replace(CAMERA.sensor, project_line=image_of_the_direction)
    camera = Calibration(sensor, CAMERA.noise, image=CAMERA.image, **CAMERA.given)
    with pytest.raises(CheckError, match="goes through both endpoints of its segment"):
        check_pair(kind, camera, silent=True)
    monkeypatch.setattr(line_pairs, "initialize_line", swapped(line_pairs.initialize_line))
    with pytest.raises(CheckError, match="goes through both endpoints of its segment"):
        check_pair(kind, CAMERA, silent=True)


def test_numbers_without_a_value_are_found_at_nasty_places(monkeypatch):
    right = lines.observe_line

    def lost_at_the_centre(kind, calibration, robot, extrinsics, landmark):
        found = right(kind, calibration, robot, extrinsics, landmark)
        through_centre = np.abs(found.value).max() < 1e-6
        return dataclasses.replace(found, value=found.value * (np.nan if through_centre else 1))

    monkeypatch.setattr(lines, "observe_line", lost_at_the_centre)
    with pytest.raises(CheckError, match="in degenerate cases all numbers are finite, or it is refused"):
        check_chains(LINES["plkLin"], CAMERA)


def test_a_narrow_lens_is_judged_too_and_one_that_sees_nothing_is_reported():
    def camera(focal, image=(640, 480)):
        return Calibration(CAMERA.sensor, np.eye(2), image=image, intrinsics=[320, 240, focal, focal], distortion=[])

    assert check_pair(LINES["ahmLin"], camera(1200.0), silent=True)  # thirty degrees across
    with pytest.raises(CheckError, match="it sees too few directions for a segment"):
        check_pair(LINES["ahmLin"], camera(1e6, (1, 1)), silent=True)


@pytest.mark.parametrize(("across", "aside"), [(10.0, 0.0), (3.0, 0.0), (0.1, 0.0), (10.0, 5.0), (3.0, 5.0)])
def test_a_telephoto_lens_is_judged(across, aside):
    """Degrees from side to side, and from the optical axis to the middle of the image, in widths of the image."""
    focal = 320 / np.tan(np.radians(across / 2))
    centre = [320 + 640 * aside, 240]
    narrow = Calibration(CAMERA.sensor, np.eye(2), image=(640, 480), intrinsics=[*centre, focal, focal], distortion=[])
    points = visible_points(narrow, np.random.default_rng(0), 50)
    pixels = narrow.project(points)
    assert len(points) == 50
    assert narrow.inside(pixels).all()
    assert (np.ptp(pixels, axis=0) > [400, 300]).all()
    check_sensor(narrow, silent=True)


def test_a_sensor_that_sees_nothing_is_reported():
    nothing = Calibration(CAMERA.sensor, np.eye(2), image=(1, 1), intrinsics=[320, 240, 1e6, 1e6], distortion=[])
    assert len(visible_points(nothing, np.random.default_rng(0), 10)) == 0
    with pytest.raises(CheckError, match="of 340000 directions all around none is visible and inside the image"):
        check_sensor(nothing, silent=True)


@pytest.mark.parametrize("told", ["", "some line"])
def test_a_sensor_without_lines_must_say_so(monkeypatch, told):
    def silent(*_):
        if told:
            raise SlamlibError(told)

    monkeypatch.setattr(line_pairs, "observe_line", silent)
    with pytest.raises(CheckError, match="a sensor that sees no lines says so"):
        check_pair(LINES["plkLin"], example(SENSORS["relativePosition"]), silent=True)


@model(point=4)
def unscaled(point):
    """A relative position that forgets to divide by w."""
    return point[:3]


def everything(point, calibration):
    """Calls everything visible, points at infinity too."""
    return np.ones(np.shape(point)[:-1], dtype=bool)


def single(point, calibration):
    """Works for one point only."""
    return bool(point[3] > 0)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"project": unscaled}, "only the ratio"),
        ({"visible": everything}, "what is visible can be measured"),
        ({"visible": single}, "mask|truth value|ambiguous"),
        ({"parameters": ("velocity",)}, r"takes point \(4\); should take point \(4\), velocity"),
    ],
)
def test_a_wrong_sensor_is_found(change, message):
    right = SENSORS["relativePosition"]
    calibration = example(right)
    object.__setattr__(calibration, "sensor", dataclasses.replace(right, **change))
    with pytest.raises((CheckError, ValueError), match=message):
        check_sensor(calibration, silent=True)


def test_a_sensor_with_a_wrong_jacobian_is_found_by_both_tests_of_it():
    right = SENSORS["stereo"]
    calibration = example(right)
    wrong = dataclasses.replace(right, project=WrongJacobian(right.project, "point"))
    object.__setattr__(calibration, "sensor", wrong)
    with pytest.raises(CheckError) as caught:
        check_sensor(calibration, silent=True)
    found = {f.what for f in caught.value.findings}
    assert any("complex step" in what for what in found)
    assert any("undo each other" in what for what in found)


def test_an_unmeasured_number_must_be_called_so():
    camera = example(SENSORS["pinHole"])

    @model(measurement=2, depth=1, intrinsics=4, distortion=AtMost(8))
    def back_project(measurement, depth, intrinsics, distortion):
        """Calls its second argument otherwise."""
        return np.concatenate([measurement, depth, depth])

    wrong = dataclasses.replace(camera.sensor, back_project=back_project)
    object.__setattr__(camera, "sensor", wrong)
    with pytest.raises(
        CheckError, match=r"takes measurement, depth, .*should take measurement, unmeasured, intrinsics"
    ):
        check_sensor(camera, silent=True)


@model(pose=Pose, returns=Pose2)
def mirrored(pose):
    """The pose in the plane, turned the other way."""
    x, y, heading = from_space(pose)
    return np.array([x, y, -heading])


@model(state=Pose2, control=2, dt=(), returns=Pose2)
def drifting(state, control, dt):
    """A robot that is blown along the world's x axis, faster than it says."""
    return np.array([state[0] + dt * (control[0] + 1), state[1], state[2] + dt * control[1]])


@model(state=Pose2, control=2, dt=(), returns=Pose2)
def leaping(state, control, dt):
    """A robot that is further on before it has moved."""
    return np.array([state[0] + control[0] * dt + 1, state[1], state[2] + dt * control[1]])


@model(state=Pose2, control=2, dt=())
def flat(state, control, dt):
    """The heading is a plain number."""
    return np.array([state[0] + control[0] * dt, state[1], state[2] + dt * control[1]])


@model(state=Pose2, speed=2, dt=(), returns=Pose2)
def misnamed(state, speed, dt):
    """The control has another name."""
    return np.array([state[0] + speed[0] * dt, state[1], state[2] + dt * speed[1]])


class ByStateTransposed:
    """moved(motion, state) whose Jacobian by the state is wrong."""

    def __init__(self, right):
        self.right = right

    def __call__(self, motion, state):
        return self.right(motion, state)

    def jac_where(self, motion, state):
        return self.right.jac_where(motion, state)

    def jac(self, motion, state):
        value, (by_motion, by_state) = self.right.jac(motion, state)
        return value, (by_motion, by_state.swapaxes(-1, -2))


UNTURNED = Parts(compose, *[number] * 6)  # the velocities stay, although those in the world's axes turn
ALL_TURNED = Parts(compose, vector, vector)  # those in the robot's axes do not


@pytest.mark.parametrize(
    ("right", "change", "definition", "message"),
    [
        ("constVel", {"moved": UNTURNED}, "constVel.moved", "not noticed by a step"),
        ("constVel", {"moved": ALL_TURNED}, "constVel.moved", "not noticed by a step"),
        ("constVel", {"moved": ByStateTransposed(CONSTANT_VELOCITY.moved)}, "constVel.moved", "by the state"),
        ("unicycle", {"from_pose": mirrored}, "unicycle.from_pose", "from_pose, then pose_of"),
        ("unicycle", {"step": drifting}, "unicycle.moved", "not noticed by a step"),
        ("unicycle", {"step": leaping}, "unicycle.step", "no control and no time"),
        ("unicycle", {"step": flat}, "unicycle.step", "returns no manifold; should return pose in the plane"),
        ("unicycle", {"step": misnamed}, "unicycle.step", r"should take state \(3\), control \(2\), dt \(1\)"),
        ("unicycle", {"moved": MOTIONS["odometry"].moved}, "unicycle", "argument 'inner'|should have|shape"),
    ],
)
def test_a_wrong_motion_is_found_and_named(right, change, definition, message):
    check_motion(MOTIONS[right], silent=True)
    with pytest.raises(SlamlibError, match=message) as found:
        check_motion(dataclasses.replace(MOTIONS[right], **change), silent=True)
    assert definition in str(found.value) or not isinstance(found.value, CheckError)


def test_misuse_is_reported():
    with pytest.raises(SlamlibError, match="give a Motion, not Sensor"):
        check_motion(SENSORS["stereo"])
    with pytest.raises(SlamlibError, match="give a PointLandmark or a LineLandmark, not str"):
        check_landmark("ahmPnt")
    with pytest.raises(SlamlibError, match="checked with its calibration"):
        check_sensor(SENSORS["stereo"])


def test_a_pair_that_does_not_exist_is_distinguished_from_a_wrong_one():
    behind = Calibration(SENSORS["relativePosition"], np.eye(3))
    assert check_pair(AHM, behind, silent=True)
    with pytest.raises(SlamlibError):
        check_pair(dataclasses.replace(AHM, from_frame=WrongJacobian(AHM.from_frame, "point")), behind, silent=True)


REQUIRED = [
    *((AHM, part) for part in ("name", "manifold", "to_frame", "from_frame", "to_point")),
    *((LINES["ahmLin"], part) for part in ("name", "manifold", "to_frame", "from_frame", "point_at", "abscissas")),
    *((CAMERA.sensor, part) for part in ("name", "project", "back_project", "parameters", "visible")),
    *((ODOMETRY, part) for part in ("name", "manifold", "control", "step")),
]


@pytest.mark.parametrize(("kind", "part"), REQUIRED, ids=[f"{kind.name}.{part}" for kind, part in REQUIRED])
def test_an_unfinished_type_names_the_part_that_it_lacks(kind, part):
    with pytest.raises(SlamlibError, match=rf"is unfinished; it lacks\n  {part}: [^\n]+$"):
        dataclasses.replace(kind, **{part: None})


OPTIONAL = [
    (AHM, "moved", "a function under @model(motion=Pose, ...), or Parts(...)"),
    (LINES["plkLin"], "constrain", "a function under @model(...)"),
    (CAMERA.sensor, "check", "a function; see its help"),
    (CAMERA.sensor, "project_line", "a function under @model(...)"),
    (CAMERA.sensor, "limits", "a tuple; see its help"),
    (ODOMETRY, "moved", "a function under @model(motion=Pose, ...), or Parts(...)"),
    (ODOMETRY, "angles", "a tuple; see its help"),
]


@pytest.mark.parametrize(("kind", "part", "what"), OPTIONAL, ids=[f"{kind.name}.{part}" for kind, part, _ in OPTIONAL])
def test_an_optional_part_of_a_type_may_not_be_something_else(kind, part, what):
    with pytest.raises(SlamlibError) as caught:
        dataclasses.replace(kind, **{part: 7})
    name = type(kind).__name__
    assert str(caught.value) == f"{name} {kind.name!r} is unfinished; it lacks\n  {part}: {what}"


def test_an_unfinished_type_names_all_that_it_lacks_and_a_function_that_is_no_model():
    def to_frame(pose, landmark):
        """Lacks its decorator."""

    with pytest.raises(SlamlibError) as caught:
        PointLandmark("newPnt", 7, to_frame, AHM.from_frame, None)
    assert str(caught.value).splitlines() == [
        "PointLandmark 'newPnt' is unfinished; it lacks",
        "  manifold: a manifold, such as as_manifold(7)",
        "  to_frame: a function under @model(...)",
        "  to_point: a function under @model(...)",
    ]


def test_a_type_without_a_file_is_added_by_its_name(monkeypatch):
    monkeypatch.setattr(POINTS, "_values", dict(POINTS))
    own = dataclasses.replace(AHM, name="ownPnt")
    POINTS.add(own)
    assert POINTS["ownPnt"] is own
    assert Options(points="ownPnt").points == "ownPnt"
    again = dataclasses.replace(own, moved=None)
    POINTS.add(again)  # the cell that defines it was run once more
    assert POINTS["ownPnt"] is again


@model(measurement=1, unmeasured=2)
def somewhere_that_way(measurement, unmeasured):
    """The point of an azimuth, with elevation and inverse distance unmeasured."""
    azimuth, (elevation, inverse_distance) = measurement[0], unmeasured
    level = cos(elevation)
    return np.array([level * cos(azimuth), level * sin(azimuth), sin(elevation), inverse_distance])


def test_a_sensor_that_leaves_two_numbers_open_says_that_it_initializes_nothing():
    azimuth = dataclasses.replace(SENSORS["planeBearing"], name="azimuth", plane=False, initializes=False)
    azimuth = dataclasses.replace(azimuth, back_project=somewhere_that_way)
    check_sensor(Calibration(azimuth, [[0.01]]), silent=True)
    with pytest.raises(SlamlibError, match="'azimuth': a filter has a prior for one unmeasured number"):
        dataclasses.replace(azimuth, initializes=True)
