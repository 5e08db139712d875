"""Experiments whose results the chapters store: `python -m book.experiments.NAME` runs one, mostly by a make target."""

import os

# Read when NumPy loads: a run is to be the same whichever way it is begun, and two threads of BLAS wait for each other.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
