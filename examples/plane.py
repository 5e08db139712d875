"""EKF-SLAM in the plane: a robot with a laser scanner, and a landmark that gets two numbers, no more."""

import slamlib as sl

robot = sl.robot(motion="unicycle", noise=(0.05, 0.01))  # of a step's speed [m/s] and rate of turn [rad/s]
laser = sl.range_bearing(noise=(0.1, 0.02))  # two numbers [m, rad]: it is one in the plane
slam = sl.Slam(robot, laser)

recording = [((1.0, 0.2), {1: (4.0, 0.4), 2: (3.0, -0.9)}), ((1.0, 0.2), {1: (3.1, 0.35), 2: (2.6, -1.3)})]
for u, seen in recording:  # seen: {number: (range, bearing)}
    slam.step(u, seen, dt=1.0)

print(slam.robot)
print(slam.map)
