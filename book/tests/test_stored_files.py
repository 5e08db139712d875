"""Every stored result file has a check, named here; and what the checks share can tell one number from another.

Three kinds of tests of stored results, told by their names. `..._again`: a row, or a short one, is computed again by
the function that made it. `test_form_of_...`: the file is whole; of what takes over ten seconds to compute nothing more
is known. `test_stored_claim_...`: a sentence of the book holds of the stored numbers; no code can make it fail.
"""

import ast
import json

import pytest

from book.tests.stored_results import comes_out_again
from book.tools import layout

DATA = "book/chapters/data"
FOLDERS, SUFFIXES = ("book", "benchmarks", "slamlib"), {".csv", ".json", ".npy", ".npz"}
# What computes a row again: tests, and cells of chapters, which print True (nbval compares what they print).
AGAIN = {
    f"{DATA}/absolute_measurements.json": [
        "book/tests/test_stored_absolute_measurements.py::test_a_run_of_each_type_comes_out_again",
        "book/tests/test_stored_absolute_measurements.py::test_a_run_of_each_filter_comes_out_again",
        "book/tests/test_stored_absolute_measurements.py::test_a_run_with_weak_fixes_comes_out_again",
    ],
    f"{DATA}/audit.json": ["book/tests/test_audit.py::test_number"],
    f"{DATA}/consistency.json": [
        "book/tests/test_stored_consistency.py::test_the_first_numbers_come_out_again",
        "book/tests/test_stored_consistency.py::test_a_whole_run_comes_out_again",
    ],
    f"{DATA}/conversion.json": [
        "book/tests/test_stored_conversion.py::test_the_beginning_of_the_runs_comes_out_again",
    ],
    f"{DATA}/error_coordinates.json": [
        "book/tests/test_stored_error_coordinates.py::test_the_first_runs_come_out_again",
        "book/tests/test_stored_error_coordinates.py::test_the_first_drives_come_out_again",
        "book/tests/test_stored_error_coordinates.py::test_a_run_of_chapter_ekf_slam_comes_out_again",
    ],
    f"{DATA}/experiments.json": [
        "book/tests/test_stored_experiments.py::test_the_first_numbers_come_out_again",
        "book/tests/test_stored_experiments.py::test_a_whole_run_comes_out_again_by_the_filter_and_by_all_data_at_once",
        "book/chapters/toolbox_tour.ipynb::17-060",
    ],
    f"{DATA}/invariant_nees.json": [
        "book/tests/test_stored_invariant_nees.py::test_the_first_numbers_come_out_again",
        "book/tests/test_stored_invariant_nees.py::test_a_whole_run_comes_out_again",
    ],
    f"{DATA}/many_maps.json": [
        "book/tests/test_stored_many_maps.py::test_the_first_run_comes_out_again",
        "book/chapters/many.ipynb::1c7de29b",
    ],
    f"{DATA}/measurement_errors.json": [
        "book/tests/test_stored_measurement_errors.py::test_a_short_film_comes_out_again",
    ],
    f"{DATA}/monocular.json": [
        "book/tests/test_stored_monocular.py::test_the_beginning_of_a_run_past_the_wall_comes_out_again",
        "book/tests/test_stored_monocular.py::test_the_end_of_a_way_round_comes_out_again_of_the_stored_path",
    ],
    f"{DATA}/odometry_noise.csv": ["book/chapters/toolbox_tour.ipynb::17-104"],
    f"{DATA}/other_filters.json": [
        "book/tests/test_other_filters.py::test_the_first_runs_come_out_again",
        "book/chapters/other_filters.ipynb::25-021",
    ],
    f"{DATA}/plane_all_data.csv": ["book/chapters/ekf_slam.ipynb::16-191"],
    f"{DATA}/plane_filters.csv": ["book/chapters/ekf_slam.ipynb::16-091"],
    f"{DATA}/predictions.json": [
        "book/tests/test_stored_predictions.py::test_the_first_runs_come_out_again",
        "book/tests/test_stored_predictions.py::test_a_run_by_all_data_at_once_comes_out_again",
    ],
    f"{DATA}/presets_by_both_errors.json": [
        "book/tests/test_stored_presets_by_both_errors.py::test_a_whole_run_comes_out_again",
    ],
    f"{DATA}/real_sequences.json": [
        "book/tests/test_stored_real_sequences.py::test_the_errors_of_a_stored_path_come_out_again",
    ],
    f"{DATA}/report_experiments.json": ["book/tests/test_report_experiments.py::test_the_light_run_comes_out_again"],
    f"{DATA}/starts.json": ["book/tests/test_stored_starts.py::test_a_film_comes_out_again"],
    f"{DATA}/stereo_slam.json": [
        "book/tests/test_stored_stereo_slam.py::test_the_last_repairs_come_out_again",
        "book/tests/test_stored_stereo_slam.py::test_a_row_of_wrong_covariances_comes_out_again",
        "book/tests/test_stored_stereo_slam.py::test_the_beginning_of_a_run_in_the_room_comes_out_again",
        "book/tests/test_stored_stereo_slam.py::test_the_beginning_once_round_comes_out_again_by_each_of_the_eight_filters",
    ],
    f"{DATA}/visp_cube_run.json": [
        "book/tests/test_stored_monocular.py::test_what_the_two_references_agree_to_comes_out_again",
        "book/tests/test_stored_monocular.py::test_the_beginning_of_the_real_run_comes_out_again",  # where images are
    ],
    f"{DATA}/visual_odometry.json": [
        "book/tests/test_stored_visual_odometry.py::test_the_beginning_of_a_walk_comes_out_again",
    ],
    "book/appendices/parity.csv": [
        "book/tests/site/test_live_cells.py::test_the_two_pythons_agree_number_by_number",
    ],
}
# What can be computed again where a recording is at hand, which may not be shipped; elsewhere its form is checked.
WITH_A_RECORDING = {
    f"{DATA}/victoria_park_run.json": [
        "book/tests/test_victoria_park.py::test_the_real_park_begins_as_it_is_stored",
        "book/tests/test_victoria_park.py::test_form_of_the_stored_run_is_a_path_with_a_map",
    ],
}
# What no program of ours computes.
GIVEN = {
    f"{DATA}/chessboard.pgm": "a picture of OpenCV's samples",
    f"{DATA}/chessboard_corners.csv": "corners in OpenCV's samples, located by OpenCV",
    f"{DATA}/iris_setosa.csv": "measured by E. Anderson",
    f"{DATA}/iris_versicolor.csv": "measured by E. Anderson",
    f"{DATA}/nile.csv": "measured at Aswan; test_nile.py has its sums",
    f"{DATA}/stereo_board.csv": "located by OpenCV in its samples; book.experiments.stereo_board compares",
    f"{DATA}/toolbox_runs.csv": "runs of the toolbox in Octave",
    f"{DATA}/victoria_park.csv": "measured by J. Guivant and E. Nebot, from a file of GTSAM",
    f"{DATA}/visp_cube_calibration.json": "a calibration, from the recording's own pictures",
    f"{DATA}/visp_cube_dots.txt": "located in the recording's pictures, which are not shipped",
    f"{DATA}/visp_cube_sfm.txt": "structure from motion by COLMAP",
    "book/moved.csv": "written by hand: addresses of pages that have moved",
    "book/sources/rosetta.csv": "written by hand; test_rosetta.py says that it is true",
    "slamlib/tests/data/toolbox/": "written by the toolbox in Octave; the tests of slamlib compare with it",
}
SKIPPED = {"nbval-ignore-output", "nbval-skip"}
CHECKED = AGAIN | WITH_A_RECORDING


def result_files():
    """Files of numbers, by their paths from the root."""
    found = (file for folder in FOLDERS for file in (layout.ROOT / folder).rglob("*") if file.is_file())
    return {
        file.relative_to(layout.ROOT).as_posix()
        for file in found
        if file.suffix in SUFFIXES or file.parent == layout.ROOT / DATA
    }


def known(file):
    return file in {**CHECKED, **GIVEN} or any(name.endswith("/") and file.startswith(name) for name in GIVEN)


def test_every_stored_file_has_a_check_or_is_not_ours():
    files = result_files()
    assert [file for file in sorted(files) if not known(file)] == [], "name what computes a row of it again, above"
    assert [name for name in {**CHECKED, **GIVEN} if not any(file.startswith(name) for file in files)] == []


@pytest.mark.parametrize(
    ("file", "check"), [(file, check) for file, checks in CHECKED.items() for check in checks], ids=str
)
def test_the_check_of_a_file_is_there_and_computes(file, check):
    where, name = check.split("::")
    text = (layout.ROOT / where).read_text("utf-8")
    if where.endswith(".py"):
        assert name in {node.name for node in ast.walk(ast.parse(text)) if isinstance(node, ast.FunctionDef)}
        assert file in WITH_A_RECORDING or not name.startswith(("test_form_of_", "test_stored_claim_"))
        return
    (cell,) = (cell for cell in json.loads(text)["cells"] if cell.get("id") == name)
    printed = "".join(line for output in cell["outputs"] for line in output.get("text", []))
    assert file.rsplit("/", 1)[1] in "".join(cell["source"])
    assert not SKIPPED & set(cell["metadata"].get("tags", []))
    assert ": True" in printed
    assert ": False" not in printed


SAME = {"a": 1.234, "b": [0.01, "nan", True, None, 3], "c": 0.0}


@pytest.mark.parametrize(
    ("change", "near"),
    [
        ({"a": 1.2349}, {}),
        ({"a": 1.26}, {"share": 0.03}),
        ({"b": [0.0149, float("nan"), True, None, 3]}, {"places": 2}),
        ({"c": 0.00009}, {"places": 4}),
    ],
)
def test_numbers_that_are_as_near_as_the_file_says_are_the_same(change, near):
    comes_out_again(SAME | change, SAME, "run it", **near)


@pytest.mark.parametrize(
    ("change", "where"),
    [
        ({"a": 1.236}, "at 'a': 1.236 now, 1.234 stored"),
        ({"a": -1.234}, "at 'a'"),
        ({"a": float("nan")}, "at 'a'"),
        ({"b": [0.01, "nan", True, None]}, "at 'b'"),
        ({"b": [0.01, "nan", False, None, 3]}, "[2]: False now, True stored"),
        ({"b": [0.01, "nan", True, 0.0, 3]}, "[3]: 0.0 now, None stored"),
        ({"b": [0.01, 1.0, True, None, 4]}, "2 differences from the stored file: run it"),
        ({"c": 1e-9}, "at 'c'"),
        ({"d": 1}, "at: "),
    ],
)
def test_what_is_another_number_or_word_or_shape_is_a_difference(change, where):
    with pytest.raises(pytest.fail.Exception) as failed:
        comes_out_again(SAME | change, SAME, "run it")
    assert where in str(failed.value)
