"""The checks of E01 to E30, by the part of the report that they are about; importing this registers all of them."""

from slambook.report.checks import landmarks, motion, observation, text, turning, update
from slambook.report.findings import CHECKS

__all__ = ["CHECKS", "landmarks", "motion", "observation", "text", "turning", "update"]
