"""Rotations and frames: quaternion, euler, pose. Formula modules are tangled from chapter frames_and_quaternions."""
