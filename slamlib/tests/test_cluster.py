"""Runs on a Dask cluster: a scheduler in this process, workers in their own, which know nothing of the folder."""

import os
import socket
import subprocess
import sys
import threading
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import slamlib
from slamlib.cli import main
from slamlib.errors import SlamlibError
from slamlib.experiments import monte_carlo as module
from slamlib.experiments.cluster import _call, on_cluster
from slamlib.experiments.monte_carlo import NAMES, monte_carlo, seeds
from slamlib.experiments.presets import preset
from slamlib.tests.interruptions import interrupted_after

distributed = pytest.importorskip("distributed", reason="Dask's cluster is optional: the extra `cluster`")

SHORT, RUNS, SEED = replace(preset("points"), frames=4), 10, 4
FOLDER = "finished-runs"  # below the folder in which the command runs, by its relative name
PATIENCE = 120.0  # [s] of a busy machine
STARTED = "started.txt"  # in each worker's own folder: the seeds of the runs that it began

# What a worker loads as it starts: it may not touch the folder, and notes the runs that it begins.
NO_FOLDER = f"""
import sys
from slamlib.experiments.runs import Run

def refuse(event, arguments):
    if event.split(".")[0] in ("open", "os", "shutil") and {FOLDER!r} in str(arguments):
        raise PermissionError(f"{{event}} {{arguments}}: this worker cannot reach the folder")

def noted(run):
    with open({STARTED!r}, "a") as file:
        file.write(f"{{run.preset.seed}}\\n")
    return Run.own_finish(run)

if not hasattr(Run, "own_finish"):  # Dask loads this file twice
    sys.addaudithook(refuse)
    Run.own_finish, Run.finish = Run.finish, noted
"""
# What the one that will die loads, too: it is in the middle of a run when it is killed.
IN_THE_MIDDLE = f"""
import time

def stuck(run):
    yield next(Run.own_iter(run))
    time.sleep({PATIENCE})
    raise RuntimeError("nobody has killed this worker")

if not hasattr(Run, "own_iter"):
    Run.own_iter, Run.__iter__ = Run.__iter__, stuck
"""


@contextmanager
def worker(address, folder, *preload):
    """A worker in a process and a folder of its own."""
    folder.mkdir()
    (folder / "loaded.py").write_text("".join(preload))
    call = [sys.executable, "-m", "dask", "worker", address, "--nthreads", "1", "--no-nanny", "--no-dashboard"]
    known = {**os.environ, "PYTHONPATH": str(Path(slamlib.__file__).parents[1]), "OPENBLAS_NUM_THREADS": "1"}
    with (folder / "log.txt").open("w") as log:
        process = subprocess.Popen(
            [*call, "--preload", "loaded.py", "--local-directory", "."],
            cwd=folder, env=known, stdout=log, stderr=log, stdin=subprocess.DEVNULL,
        )  # fmt: skip
    try:
        yield process
    finally:
        process.kill()
        process.wait()


def started(folder):
    """The seeds of the runs that a worker began."""
    file = folder / STARTED
    return [int(line) for line in file.read_text().split()] if file.is_file() else []


def same(a, b):
    return all(np.array_equal(getattr(a, n), getattr(b, n), equal_nan=True) for n in NAMES if n != "seconds")


@pytest.fixture(scope="module")
def cluster():
    """A scheduler, without workers."""
    with distributed.LocalCluster(n_workers=0, dashboard_address=":0") as made:
        yield made


@pytest.fixture(scope="module")
def others(cluster, tmp_path_factory):
    """The folder of a worker that lives on."""
    folder = tmp_path_factory.mktemp("workers") / "lives"
    with worker(cluster.scheduler_address, folder, NO_FOLDER), distributed.Client(cluster) as client:
        client.wait_for_workers(1, timeout=PATIENCE)
        yield folder


@pytest.fixture(scope="module")
def alone():
    """The runs as one process makes them."""
    return monte_carlo(SHORT, RUNS, seed=SEED)


def test_a_scheduler_without_workers_is_not_waited_for_for_ever(cluster):
    with pytest.raises(SlamlibError, match=r"has no worker, and none came within 3 s: .*'dask worker tcp://"):
        monte_carlo(SHORT, 2, scheduler=cluster.scheduler_address, wait=3)


def test_a_worker_dies_and_no_run_is_lost(cluster, others, alone, tmp_path, monkeypatch):
    """It is killed within a run, when three are written; all others are made once, and that one again elsewhere."""
    here = tmp_path / "here"
    here.mkdir()
    monkeypatch.chdir(here)
    before, write = len(started(others)), module.write_archive
    with worker(cluster.scheduler_address, tmp_path / "dies", NO_FOLDER, IN_THE_MIDDLE) as mortal:
        with distributed.Client(cluster) as client:
            client.wait_for_workers(2, timeout=PATIENCE)
        written = []

        def watched(path, *content):
            write(path, *content)
            written.append((Path(path), Path(path).stat().st_mtime_ns))
            if len(written) == 3:
                mortal.kill()

        monkeypatch.setattr(module, "write_archive", watched)
        found = monte_carlo(SHORT, RUNS, seed=SEED, scheduler=cluster.scheduler_address, wait=PATIENCE, folder=FOLDER)
        assert mortal.wait() != 0
    assert same(found, alone)
    assert len(written) == len({path for path, _ in written}) == RUNS
    assert all(path.stat().st_mtime_ns == time for path, time in written)
    assert sorted(os.listdir(FOLDER)) == sorted(path.name for path, _ in written)
    (lost,) = started(tmp_path / "dies")
    assert lost in started(others)[before:]
    assert sorted(started(others)[before:]) == sorted(seeds(SEED, RUNS))
    assert same(monte_carlo(SHORT, RUNS, seed=SEED, folder=FOLDER), alone)
    # what is there is not sent again, and a folder written by a cluster goes on without one
    more = monte_carlo(SHORT, RUNS + 1, seed=SEED, scheduler=cluster, wait=PATIENCE, folder=FOLDER)
    assert started(others)[before + RUNS :] == seeds(SEED, RUNS + 1)[-1:]
    assert same(more, monte_carlo(SHORT, RUNS + 1, seed=SEED, folder=FOLDER))


def test_the_command_on_a_cluster_prints_what_it_prints_here(cluster, others, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    call = ["compare", "ahmPnt", "--runs", "3", "--frames", "4", "--json", "--folder"]
    assert main([*call, "own"]) == 0
    wanted = capsys.readouterr().out
    there = ["--scheduler", cluster.scheduler_address, "--wait", str(PATIENCE)]
    assert main([*call, FOLDER, *there]) == 0
    found = capsys.readouterr()
    assert not found.err
    assert [line for line in found.out.splitlines() if "milliseconds" not in line] == [
        line for line in wanted.splitlines() if "milliseconds" not in line
    ]
    assert sorted(os.listdir(FOLDER)) == sorted(os.listdir("own"))


def test_ctrl_c_keeps_what_is_finished_and_takes_the_rest_back(cluster, others, tmp_path, monkeypatch):
    monkeypatch.setattr(module, "write_archive", interrupted_after(module.write_archive, 2))
    with pytest.raises(KeyboardInterrupt):
        monte_carlo(SHORT, 200, seed=SEED, scheduler=cluster, wait=PATIENCE, folder=tmp_path)
    assert len(list(tmp_path.iterdir())) == 2
    gone = threading.Event()
    for _ in range(int(10 * PATIENCE)):  # the scheduler hears of it a moment later
        if not cluster.scheduler.tasks:
            break
        gone.wait(0.1)
    assert not cluster.scheduler.tasks
    assert len(started(others)) < 200


def test_a_run_that_fails_is_named(cluster, others):
    wrong = replace(SHORT, worlds=(("thickCloister", {"n": "seven"}),))
    (own,) = seeds(SEED, 1)
    with pytest.raises(SlamlibError, match=f"^the run of seed {own} failed: .* whole number, got 'seven'"):
        monte_carlo(wrong, 1, seed=SEED, scheduler=cluster, wait=PATIENCE)
    with pytest.raises(TypeError, match="abs"):  # its own, with its traceback
        list(on_cluster(abs, ["seven"], cluster, PATIENCE))


ANOTHER = "import sys; sys.modules['slamlib'].__version__ = {!r}"
WITHOUT = "import sys; sys.without = sys.modules['slamlib']; sys.modules['slamlib'] = None"
WITH = "import sys; sys.modules['slamlib'] = sys.without"


def test_a_worker_with_another_slamlib_or_none_is_refused(cluster, others):
    with distributed.Client(cluster) as client:
        for change, back, found in (
            (ANOTHER.format("0.0.9"), ANOTHER.format(slamlib.__version__), r"0\.0\.9"),
            (WITHOUT, WITH, "import of slamlib halted; None in sys.modules"),
        ):
            client.run(exec, change, {})
            with pytest.raises(SlamlibError, match=rf"worker tcp://\S+ has another slamlib .* \({found}\): install"):
                monte_carlo(SHORT, 2, scheduler=cluster, wait=PATIENCE)
            client.run(exec, back, {})


def test_a_worker_that_comes_later_is_asked_as_well():
    assert _call(slamlib.__version__, abs, -3) == 3
    with pytest.raises(SlamlibError, match="a worker has another slamlib"):
        _call("0.0.9", abs, -3)


def test_an_address_where_nothing_answers(capsys):
    with socket.create_server(("127.0.0.1", 0)) as free:
        address = f"tcp://127.0.0.1:{free.getsockname()[1]}"
    for there, message in ((address, "no Dask scheduler answers at tcp://"), ("host", "host is no address of a Dask")):
        assert main(["compare", "ahmPnt", "--scheduler", there, "--wait", "1"]) == 2
        told = capsys.readouterr().err
        assert told.startswith(f"slamlib: {message}")
        assert told.count("\n") == 1
    with pytest.raises(SlamlibError, match="seconds above 0, got 0"):
        monte_carlo(SHORT, 2, scheduler=address, wait=0)


def test_jobs_and_a_scheduler_exclude_each_other(capsys):
    with pytest.raises(SystemExit) as ended:
        main(["compare", "ahmPnt", "--jobs", "2", "--scheduler", "tcp://127.0.0.1:8786"])
    assert ended.value.code == 2
    assert "not allowed with argument" in capsys.readouterr().err


def test_what_kills_every_worker_is_given_up_by_its_name(cluster, others, monkeypatch):
    """The last test of the file: it is the end of the worker that the others share."""
    monkeypatch.setattr(cluster.scheduler, "allowed_failures", 0)
    with pytest.raises(SlamlibError, match="the run of seed 5 was given up: 1 workers died of it"):
        list(on_cluster(os._exit, [5], cluster, PATIENCE))
