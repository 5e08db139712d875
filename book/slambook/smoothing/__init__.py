"""All data at once: the best estimate that a filter's measurements allow, as its yardstick. Chapter other_filters."""

from slambook.smoothing.smoother import Smoothed, Smoother

__all__ = ["Smoothed", "Smoother"]
