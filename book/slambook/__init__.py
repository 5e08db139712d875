"""What the book needs and a filter does not: figures, scenes, rendered rooms, the report's filter."""

import os

# As of the command `slamlib`: one thread of BLAS is faster by far for matrices of this size. Read when NumPy loads.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
