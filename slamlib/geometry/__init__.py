"""Rotations and frames: quaternion, euler, pose. Every formula module is tangled from chapter 6."""
