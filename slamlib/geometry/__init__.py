"""Rotations and frames: quaternion, euler, pose. Every formula module is tangled from chapter frames_and_quaternions."""
