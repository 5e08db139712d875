"""A Jacobian written by hand, and a slip in it: range and bearing of a point, seen from a robot in the plane."""

import numpy as np

import slamlib as sl


def measure(x, p):  # robot (x, y, heading), point (x, y)
    dx, dy = p - x[:2]
    return np.array([np.hypot(dx, dy), np.arctan2(dy, dx) - x[2]])


def by_robot(x, p, power=2):
    (dx, dy), r = p - x[:2], np.hypot(*(p - x[:2]))
    return np.array([[-dx / r, -dy / r, 0.0], [dy / r**power, -dx / r**power, -1.0]])


x, p = np.array([1.0, 2.0, 0.3]), np.array([4.0, 6.0])
sl.check_jacobian(measure, by_robot, x, p)
try:
    sl.check_jacobian(measure, by_robot(x, p, power=1), x, p)  # the square forgotten
except sl.SlamlibError as error:
    print(error)
