"""`python -m slamlib`: the command line."""

import sys

from slamlib.cli import main

if __name__ == "__main__":
    sys.exit(main())
