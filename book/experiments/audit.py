"""`make audit`: every number E01 to E30 of the list of the report's errata, computed.

For each: what the report states and where, what is right, the figures, their limits, and a verdict: computed, read (an
error of words), or FAILED. The exit status is 1 if one failed. --store writes the file of page report_audited's table.
"""

import argparse
import json
import textwrap
from typing import Any

from slambook.report import SWITCHES
from slambook.report.checks import CHECKS
from slambook.report.findings import RUNS, SEED, AuditFigure, AuditFinding, ran
from slambook.report.runs import DOF, Outcome

from book.experiments import stored
from book.tools import layout
from slamlib.errors import UnknownNameError
from slamlib.evaluation.consistency import band
from slamlib.experiments.progress import progress

FILE = layout.BOOK / "chapters" / "data" / "audit.json"
SHOWN = "gentle", "hard"  # scenes of the chapter's figure
ELSEWHERE = {"E21"}  # switches that these scenes do not show
ALSO = {"E03": "uneven", "E06": "optical", "E17": "rig"}  # scenes in which these errors show
WIDTH = 118


def chosen(names: list[str]) -> list[str]:
    """The numbers asked for, or all; raises UnknownNameError."""
    for name in names:
        if name not in CHECKS:
            raise UnknownNameError.of("number of the list", name, CHECKS)
    return sorted(names or CHECKS)


def text(found: AuditFinding) -> str:
    """What is printed of a finding: its head, then a line for each figure."""
    check = found.check
    head = f"{check.number} {check.where}: {check.says}. Right: {check.right}"
    lines = [f"{found.verdict if i == 0 else '':<11}{part}" for i, part in enumerate(_wrapped(head))]
    lines += [line for figure in found.figures for line in _figure(figure)]
    return "\n".join([*lines, *(f"{'':11}{part}" for part in _wrapped(found.note))])


def _figure(figure: AuditFigure) -> list[str]:
    mark = " " if figure.holds else "!"
    line = f"{mark:>10} {figure.what:<62}{figure.measured:>10.4g}  {figure.tolerance}"
    return [line, *(f"{'':14}{part}" for part in _wrapped(figure.remark))]


def _wrapped(words: str) -> list[str]:
    return textwrap.wrap(words, WIDTH - 14)


def plain(found: AuditFinding) -> dict[str, Any]:
    """A finding as plain data."""
    told = {name: getattr(found.check, name) for name in ("number", "where", "says", "right")}
    figures = [stored.plain(vars(figure), 5) for figure in found.figures]
    return {**told, "verdict": found.verdict, "figures": figures, "note": found.note}


def series() -> dict[str, Any]:
    """For the figure with switches: NEES over its degrees of freedom at each step, averaged over the runs."""
    wanted = [(scene, name) for scene in SHOWN for name in ("", *SWITCHES) if name not in ELSEWHERE]
    wanted += [(scene, name) for error, scene in ALSO.items() for name in ("", error)]
    found: dict[str, Any] = {}
    for scene, name in progress(wanted, len(wanted), "switches"):
        try:
            outcome = ran(scene, *([name] if name else []))
        except ValueError as refused:  # the shapes do not fit
            found.setdefault(scene, {})[name] = {"refused": str(refused)}
        else:
            found.setdefault(scene, {})[name] = summary(outcome)
    return found


def summary(outcome: Outcome) -> dict[str, Any]:
    """What is kept of the runs with one error."""
    kept = {"nees": outcome.nees.mean(0) / DOF, "inside": round(outcome.inside, 3)}
    return stored.plain(kept | {n: getattr(outcome, n) for n in ("ratio", "position", "rotation")})


def file_text(found: list[AuditFinding]) -> str:
    """The chapter's file: a row a line."""
    limits = [round(v / DOF, 4) for v in band(DOF, RUNS)]
    switches = {n: {"equation": s.equation, "slip": s.slip} for n, s in SWITCHES.items()}
    head = {"runs": RUNS, "seed": SEED, "dof": DOF, "band": limits, "switches": switches, "scenes": series()}
    lines = ",\n".join(json.dumps(plain(r)) for r in found)
    return json.dumps(head)[:-1] + ', "rows": [\n' + lines + "\n]}\n"


def main() -> int:
    """Compute, print, and say whether all of it holds."""
    parser = argparse.ArgumentParser(description="Compute every figure of the errata E01 to E30.")
    parser.add_argument("--only", nargs="+", default=[], metavar="E07", help="these numbers alone")
    parser.add_argument("--json", action="store_true", help="print the rows as JSON")
    parser.add_argument("--store", action="store_true", help=f"write {FILE.relative_to(layout.ROOT)} (all numbers)")
    given = parser.parse_args()
    try:
        names = chosen(given.only)
    except UnknownNameError as error:
        parser.error(str(error))
    found = []
    for name in progress(names, len(names), "audit"):
        found.append(CHECKS[name].run())
        if not given.json:
            print(text(found[-1]), flush=True)
    if given.json:
        print(json.dumps([plain(r) for r in found], indent=1))
    failed = [r.check.number for r in found if not r.holds]
    if given.store and not given.only and not failed:
        layout.write_whole(FILE, file_text(found).encode())
    if not given.json:
        verdicts = [finding.verdict for finding in found]
        counts = ", ".join(f"{verdicts.count(v)} {v}" for v in ("computed", "read") if v in verdicts)
        told = f"FAILED: {' '.join(failed)}" if failed else "all within their limits"
        seconds = sum(finding.seconds for finding in found)
        print(f"audit: {len(found)} numbers, {counts}; {told} ({seconds:.0f} s)")
    return 1 if failed else 0


if __name__ == "__main__":
    raise SystemExit(main())
