"""Does the lock install elsewhere? pip resolves it on each platform, with hashes and from wheels alone; nothing stays.

`make platforms` needs the network, and minutes when pip's cache is empty.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

from packaging.requirements import Requirement

from book.tools import layout

# Of each: what pip calls its wheels, and the values of the markers in the lock.
PLATFORMS = {
    "Linux": (["manylinux_2_28_x86_64", "manylinux_2_17_x86_64", "manylinux2014_x86_64"], "linux", "posix", "x86_64"),
    "macOS": (["macosx_14_0_arm64", "macosx_11_0_arm64"], "darwin", "posix", "arm64"),
    "Windows": (["win_amd64"], "win32", "nt", "AMD64"),
}
PYTHONS = ("3.11", "3.13")


def wanted(platform: str, python: str) -> list[str]:
    """The lines of the lock that count on a platform: pip itself judges markers by the machine that it runs on."""
    _, system, name, machine = PLATFORMS[platform]
    values = {
        "sys_platform": system,
        "platform_system": platform.replace("macOS", "Darwin"),
        "os_name": name,
        "platform_machine": machine,
        "python_version": python,
        "python_full_version": f"{python}.0",
        "implementation_name": "cpython",
        "platform_python_implementation": "CPython",
    }
    found = []
    for line in (layout.ROOT / "requirements.txt").read_text("utf-8").replace("\\\n", " ").splitlines():
        if line.strip() and not line.lstrip().startswith("#"):
            said, _, hashes = line.partition("--hash")
            one = Requirement(said.strip())
            if one.marker is None or one.marker.evaluate(values):
                found.append(f"{one.name}{one.specifier} --hash{hashes}")
    return found


def resolves(platform: str, python: str) -> bool:
    """Whether pip finds a wheel of the lock's hashes for each package; it says what is missing."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "lock.txt"
        file.write_text("\n".join(wanted(platform, python)) + "\n", "utf-8")
        command = ["--quiet", "--disable-pip-version-check", "--dry-run", "--no-deps", "--require-hashes"]
        command += ["--only-binary=:all:", "--implementation", "cp", "--python-version", python]
        command += ["--ignore-requires-python"]  # which pip would read for the Python that it runs on
        command += [word for tag in PLATFORMS[platform][0] for word in ("--platform", tag)]
        run = subprocess.run([sys.executable, "-m", "pip", "install", *command, "--target", folder, "-r", str(file)])
    return run.returncode == 0


def main() -> int:
    """Exit status 0 if the lock installs on every platform."""
    failed = 0
    for platform in PLATFORMS:
        for python in PYTHONS:
            good = resolves(platform, python)
            failed += not good
            print(f"{platform:<8} Python {python:<5} {'installs' if good else 'FAILED'}", flush=True)
    print(f"platforms: {len(PLATFORMS) * len(PYTHONS) - failed} of {len(PLATFORMS) * len(PYTHONS)} install the lock")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
