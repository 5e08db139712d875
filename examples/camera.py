"""A robot with one camera goes round a cloister: from its controls and pixels to its pose and a map of 72 points."""

import numpy as np

import slamlib as sl

preset = sl.presets.points()
noise = np.array([0.005, 0.005, 0.005, *np.radians([0.05, 0.05, 0.05])])
robot = sl.robot("odometry", noise=noise, position=preset.rig.robots[0].position)
camera = sl.camera([320, 240, 320, 320], position=(0, 0, 0.6), landmark="ahmPnt")
slam = sl.Slam(robot, camera)
for frame, _ in preset.simulate():
    pixels = frame.scans[0].points
    seen = dict(zip(pixels.ids.tolist(), pixels.values, strict=True))
    slam.step(frame.controls[0].value, seen, dt=frame.dt)
print(slam.robot)
print(slam.map)
