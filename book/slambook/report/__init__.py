"""The student report's filter, built from its own equations, with each of its errors as a switch.

A state is the report's (5.3): x, y, z [m], yaw, pitch, roll [rad], then three coordinates [m] of each landmark. All
functions take runs side by side: leading axes count them. `equations("E04", "E10")` is the filter with two errors
turned on, `equations()` the corrected one; `slambook.report.runs.monte_carlo` runs it. Numbers such as E04 are those of
the list of errata in the appendix "Audit of the sources".
"""

from slambook.report.filter import Memory
from slambook.report.switches import SWITCHES, Equations, equations

__all__ = ["SWITCHES", "Equations", "Memory", "equations"]
