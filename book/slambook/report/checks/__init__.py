"""The checks of E01 to E30, by the part of the report that they are about; importing this registers all of them."""

from slambook.report.checks import landmarks, motion, observation, turning, update
from slambook.report.findings import CHECKS, Findings, check

__all__ = ["CHECKS", "landmarks", "motion", "observation", "turning", "update"]

# What has to be read: history, spelling, references.


@check(
    "E29",
    "1.1",
    "ISRR'99: 'the Kalman filter based SLAM ... by Sebastian Thrun'",
    "convergence and the acronym are of ISRR'95",
)
def history() -> Findings:
    yield (
        "read: 1.1, last paragraph. Durrant-Whyte and Bailey (2006): the convergence result and the acronym were "
        "presented at the symposium of 1995. History only, no equation depends on it"
    )


@check("E30", "minor", "'(0,0)'; 'variances'; 2.2.1; (5.14); 'EFK'", "(0,0,0); covariances; 2.2; no equation; EKF")
def minor() -> Findings:
    yield (
        "read: (0,0) for the origin in 1.2 and 2.1; P_xx 'contains the variances' in 5.1.2, and it holds "
        "covariances too; 5.2.2 refers twice to 2.2.1, which is on applications, for what 2.2 says; (5.14) numbers "
        "an empty line, and 5.2.1 and 5.2.3 cite it; 'EFK SLAM' in 3.2"
    )
