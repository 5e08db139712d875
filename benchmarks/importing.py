"""How long `import slamlib` takes beside `import numpy`, each in processes of its own, in turn.

The least of several is taken, since whatever else the machine does only adds. The package loads its names when they
are first used, and NumPy with the first of them, so that its import may be the shorter one; what loading the filter
takes is measured as well.
"""

import argparse
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
LIMIT = 20.0  # [ms], of `import slamlib` above `import numpy`
IMPORTS = ("import numpy", "import slamlib", "from slamlib import Slam")
PROGRAM = """
import time
start = time.perf_counter()
{statement}
print(1e3 * (time.perf_counter() - start))
"""


def once(statement: str) -> float:
    """Time [ms] of an import in a new process, without the start of Python itself."""
    call = [sys.executable, "-c", PROGRAM.format(statement=statement)]
    return float(subprocess.run(call, cwd=ROOT, capture_output=True, text=True, check=True).stdout)


def least(repetitions: int) -> dict[str, float]:
    """The least time [ms] of each import, of so many processes of each, in turn."""
    rounds = [{statement: once(statement) for statement in IMPORTS} for _ in range(repetitions)]
    return {statement: min(times[statement] for times in rounds) for statement in IMPORTS}


def report(repetitions: int = 15) -> str:
    """The times as text."""
    times = least(repetitions)
    lines = [f"{statement:<24} {time:6.1f} ms" for statement, time in times.items()]
    difference = times["import slamlib"] - times["import numpy"]
    lines.append(f"import slamlib is {difference:+.1f} ms from import numpy (limit {LIMIT:+g} ms)")
    return "\n".join([f"least of {repetitions} processes each", *lines])


def main() -> None:
    """Print the times."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.importing", description=__doc__.split("\n")[0])
    parser.add_argument("--repetitions", type=int, default=15, help="processes of each (default: 15)")
    print(report(parser.parse_args().repetitions))


if __name__ == "__main__":
    main()
