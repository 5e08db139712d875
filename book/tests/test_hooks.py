"""pre-commit's hooks are stages of `make test`, by the command that is written there."""

import subprocess

import pytest
import yaml

from book.tools import ci, layout

HOOKS = [
    hook
    for repository in yaml.safe_load((layout.ROOT / ".pre-commit-config.yaml").read_text("utf-8"))["repos"]
    for hook in repository["hooks"]
]
SLOW = {"types", "generated"}  # by their names alone: `make test` has them as stages of their own


@pytest.mark.parametrize("hook", HOOKS, ids=lambda hook: hook["id"])
def test_a_hook_runs_stages_that_exist(hook):
    python, *tool, stages = hook["entry"].split(maxsplit=3)
    assert [python, *tool] == [".venv/bin/python", "-m", "book.tools.ci"]
    quick = [stage for stage in stages.split() if stage not in SLOW]
    assert {*stages.split()} <= {stage.name for stage in ci.stages()}
    run = subprocess.run([python, *tool, *quick], cwd=layout.ROOT, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr
    assert f"stages: {len(quick)} passed, 0 failed, 0 skipped" in run.stdout
