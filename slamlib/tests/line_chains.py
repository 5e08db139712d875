"""The chain rule of lines, judged for every pair of a parametrization and a camera: its values, Jacobians and batches.

In degenerate cases too: lines at infinity, behind the camera and through its centre, segments without a length.
"""

from functools import partial

import numpy as np

from slamlib.checks.judge import Judge
from slamlib.checks.line_pairs import visible_segments
from slamlib.checks.models import derivatives, model_properties, named
from slamlib.errors import SingularPointError
from slamlib.geometry.pose import ORIGIN, Pose, compose
from slamlib.models import Argument
from slamlib.observation import lines
from slamlib.sensors.sensor import Calibration

FINITE = "in degenerate cases all numbers are finite, or it is refused"
FRAMES = [Argument("robot", Pose), Argument("extrinsics", Pose)]


class Chain:
    """observe_line or initialize_line as a model of all that they give a Jacobian w.r.t., the camera's parameters last.

    `jac` takes the parameters from the calibration; what it is called with is a place to differentiate at.
    """

    result = None

    def __init__(self, run, own, calibration, names):
        self.run, self.calibration, self.names, self.own = run, calibration, names, len(own)
        self.given = [calibration.given[n] for n in names]
        self.arguments = [*own, *(Argument(n, len(g)) for n, g in zip(names, self.given, strict=True))]
        self.parameters = [a.name for a in self.arguments]

    def __call__(self, *place):
        c = self.calibration
        given = {**c.given, **dict(zip(self.names, place[self.own :], strict=True))}
        other = Calibration(c.sensor, c.noise, image=c.image, limits=c.limits, **given)
        return self.run(other, *place[: self.own])[0]

    def jac(self, *place):
        return self.run(self.calibration, *place[: self.own])


def check_chains(kind, calibration, seed=0, segments=8):
    """Judge initialize_line and observe_line at so many random segments; raises CheckError."""
    judge, name = Judge(f"{kind.name} seen by {calibration.sensor.name}", seed), kind.name
    rng = judge.rng
    initialized, observed = _initialized(kind, calibration), _observed(kind, calibration)
    made, seen = [], []
    for segment in visible_segments(calibration, rng, segments):
        place = [Pose.random(rng), Pose.random(rng), segment, rng.uniform(0.1, 0.5, 2), *initialized.given]
        made.append(place)
        seen.append([*place[:2], initialized.jac(*place)[0], *observed.given])
    elsewhere = [[Pose.random(rng), Pose.random(rng), *place[2:]] for place in seen]
    model_properties(judge, initialized, name, made, chain=True)
    model_properties(judge, observed, name, elsewhere, seen, chain=True)
    _nasty(judge, kind, initialized, observed, made[0], name)
    judge.conclude(silent=True)


def _initialized(kind, calibration):
    own = [*FRAMES, Argument("measurement", 4), Argument("unmeasured", 2)]
    names = [n for n, g in calibration.given.items() if len(g)]
    return Chain(partial(lines.initialize_line, kind), own, calibration, names)


def _observed(kind, calibration):
    """Against the same chain of the written formulas, whose derivatives are exact."""
    given_ones = lines.ideal_parameters(calibration)
    names = [n for n, g in given_ones.items() if len(g)]

    def run(camera, *place):
        seen = lines.observe_line(kind, camera, *place)
        return seen.value, seen.jacobians

    def definition(robot, extrinsics, landmark, *given):
        line = kind.to_frame.definition(compose.definition(robot, extrinsics), landmark)
        parameters = given_ones | dict(zip(names, given, strict=True))
        return calibration.sensor.project_line.definition(line, *parameters.values())

    chain = Chain(run, [*FRAMES, Argument("landmark", kind.manifold)], calibration, names)
    chain.definition = definition
    return chain


def _nasty(judge, kind, initialized, observed, ordinary, name):
    robot, extrinsics, segment, _, *given = ordinary
    priors = [np.array(p) for p in ([0.0, 0.0], [0.1, 0.0], [0.0, 0.1], [-0.1, 0.2], [-0.2, -0.1], [1e-9, 1e-9])]
    turned, point = np.roll(segment, 2), np.tile(segment[:2], 2)
    for s, p in [*((segment, p) for p in priors), (point, np.array([0.1, 0.2])), (turned, priors[1])]:
        made = _finite(judge, initialized, name, [robot, extrinsics, s, p, *given])
        if made is None:
            continue
        for camera in _cameras(kind, made[0], robot, extrinsics):
            place = [camera, ORIGIN, made[0], *observed.given]
            if seen := _finite(judge, observed, name, place):
                derivatives(judge.at(name, **named(observed, place)), observed, place, *seen, chain=True)


def _cameras(kind, landmark, robot, extrinsics):
    """Where it was measured, the same facing backwards, from a point of the line, and from the world's origin."""
    here = compose(robot, extrinsics)
    w, x, y, z = here[3:]
    behind = np.array([*here[:3], -y, -z, w, x])  # half a turn about its own axis that points down
    point = kind.point_at.definition(landmark, 0.3)
    finite = np.abs(point[3]) > 1e-6 * np.abs(point[:3]).max()
    return [here, behind, *([np.array([*point[:3] / point[3], *here[3:]])] if finite else []), ORIGIN]


def _finite(judge, chain, name, place):
    """The value and its Jacobians, all of whose numbers must be finite; None where refused, or not finite."""
    case = judge.at(name, **named(chain, place))
    try:
        value, jacobians = chain.jac(*place)
    except SingularPointError:
        case.hold(FINITE)
        return None
    parts = {"value": value, **vars(jacobians)}.items()
    wrong = [n for n, part in parts if not np.isfinite(part).all()]
    case.require(FINITE, not wrong, "not finite, and not refused", ", ".join(wrong))
    return None if wrong else (value, jacobians)
