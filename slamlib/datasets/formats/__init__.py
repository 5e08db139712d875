"""Layouts of data sets and formats of calibrations, a file for each; both are found by walking this folder."""

from slamlib.datasets.dataset import CalibrationReader, Dataset
from slamlib.registry import Registry

DATASETS = Registry(__name__, Dataset, "data set")
READERS = Registry(__name__, CalibrationReader, "format of calibrations")
