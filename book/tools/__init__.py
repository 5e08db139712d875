"""Tools that build and check the book; run from the top of the repository by make."""

import os

# Read when NumPy loads, here and in every kernel: for matrices of a few hundred rows two threads of BLAS wait for each
# other (two robots of chapter many: twice the time, four times the work).
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
