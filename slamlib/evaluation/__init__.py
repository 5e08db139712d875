"""Evaluation: consistency (NEES, NIS and their bands); trajectories, their alignment and errors (ATE, RPE)."""
