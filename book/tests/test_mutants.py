"""The tool that puts errors into the code: on a tiny package with one tested formula and one that no test looks at."""

import ast
from pathlib import Path

import pytest

from book.tools import layout, mutants

CODE = '''"""Two formulas."""


def watched(a: float, b: float = 0) -> float:
    """a minus one."""
    if not a:
        raise ValueError(f"a is {a - 1}")
    return a - 1


def unseen(a, b):
    return (a @ b.T  # a comment with a + and a -
            + b)
'''
TESTS = """
from slamlib.code import watched


def test_it():
    assert watched(3) == 2


def test_of_drift():
    with open("slamlib/code.py") as file:
        assert "b.T  # a comment" in file.read()
"""
TABLE = """
tests = "slamlib/tests"
left_out = ["test_code.py::test_of_drift"]

[areas.all]
"slamlib/code.py" = ["test_code.py"]
"""


@pytest.fixture
def root(tmp_path):
    files = {"slamlib/__init__.py": "", "slamlib/code.py": CODE, "slamlib/tests/test_code.py": TESTS}
    for name, text in {**files, "pyproject.toml": "", "mutants.toml": TABLE}.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    return tmp_path


def subject(root):
    return mutants.Subject(root, root / "mutants.toml")


def contents(root):
    return {file: file.read_bytes() for file in root.rglob("*") if file.is_file()}


def test_a_planted_survivor_is_found_and_what_a_test_notices_is_killed(root, capsys):
    before = contents(root)
    assert mutants.main(["--only", "a - 1 -> a + 1", "--only", "transpose"], subject(root)) == 1
    printed = capsys.readouterr().out
    assert "slamlib/code.py:8 sign: a - 1 -> a + 1: killed, FAILED slamlib/tests/test_code.py::test_it" in printed
    assert "slamlib/code.py:12 transpose: b.T -> b: SURVIVED" in printed
    assert "survived: slamlib/code.py:12" in printed
    assert "mutants: 2 drawn, 1 killed, 1 survived, of which 0 are known to be equivalent" in printed
    assert contents(root) == before


def test_one_is_shown_by_its_number_or_by_a_part_of_its_name(root, capsys):
    assert mutants.main(["--list"], subject(root)) == 0
    listed = capsys.readouterr().out.splitlines()
    assert mutants.main(["--list", "--only", "2"], subject(root)) == 0
    assert capsys.readouterr().out.splitlines()[-1] == listed[1]
    assert mutants.main(["--list", "--only", "transpose"], subject(root)) == 0
    printed = capsys.readouterr().out
    assert "-    return (a @ b.T  # a comment" in printed
    assert "+    return (a @ b  # a comment" in printed


def test_a_known_equivalent_is_no_failure_wherever_its_line_moves(root, capsys):
    row = '[[equivalent]]\nfile = "slamlib/code.py"\nformula = "unseen"\nreason = "b is symmetric."\n'
    lines = ("return (a @ b.T # a comment with a + and a -", "return (a @ b # a comment with a + and a -")
    row += 'before = "{}"\nafter = "{}"\n'.format(*lines)
    (root / "mutants.toml").write_text(TABLE + row)
    (root / "slamlib/code.py").write_text("\n\n" + CODE)
    assert mutants.main(["--only", "transpose"], subject(root)) == 0
    assert "1 survived, of which 1 are known" in capsys.readouterr().out
    (root / "slamlib/code.py").write_text(CODE.replace("b.T", "b.T * 2"))
    assert mutants.main(["--list"], subject(root)) == 1
    assert "unseen: return (a @ b.T" in capsys.readouterr().out
    (root / "slamlib/code.py").write_text(CODE)
    (root / "mutants.toml").write_text(TABLE + row.replace("b is symmetric.", " "))
    assert mutants.main(["--list"], subject(root)) == 1
    assert "no reason" in capsys.readouterr().out


def test_tests_that_fail_without_an_error_are_said_first(root):
    (root / "slamlib/tests/test_code.py").write_text(TESTS.replace("== 2", "== 3"))
    with pytest.raises(SystemExit, match=r"fail without any error put in(.|\n)*assert 2 == 3"):
        mutants.main(["--only", "transpose"], subject(root))
    (root / "slamlib/tests/test_code.py").write_text("")
    with pytest.raises(SystemExit, match=r"no test is left of slamlib/tests/test_code\.py"):
        mutants.main(["--only", "transpose"], subject(root))


def test_an_endless_loop_is_ended(root):
    (root / "slamlib/tests/test_code.py").write_text("def test_it():\n    while True:\n        pass\n")
    passed, printed = mutants.run_tests(subject(root), root, ["slamlib/tests/test_code.py"], 3)
    assert (passed, printed) == (False, "no result after 3 s")


def test_errors_are_those_of_formulas_not_of_messages_annotations_or_comments(root):
    drawn = mutants.draw(subject(root), "all", 0, 99)
    whole = "a @ b.T # a comment with a + and a - + b"
    assert {m.short for m in drawn} == {
        *("0 -> 1", "not a -> a", "a - 1 -> a + 1", "a - 1 -> (a)", "a - 1 -> -(1)", "1 -> 2"),
        *("a @ b.T -> -a @ b.T", "a @ b.T -> (a)", "a @ b.T -> (b.T)", "b.T -> b"),
        *(f"{whole} -> {whole[:-3]}- b", f"{whole} -> (a @ b.T)", f"{whole} -> (b)"),
    }
    source = CODE.encode()
    for mutant in drawn:
        mutated = mutant.applied(source)
        assert ast.dump(ast.parse(mutated)) != ast.dump(ast.parse(source))
        assert mutated.startswith(source[: mutant.start])
        assert mutated.endswith(source[mutant.stop :])


def test_sampling_repeats_with_the_seed_and_takes_every_formula(root):
    draws = [[str(m) for m in mutants.draw(subject(root), "all", seed, 4)] for seed in (0, 0, *range(1, 9))]
    assert draws[0] == draws[1]
    assert len({tuple(d) for d in draws}) > 4
    formulas = [[m.formula for m in mutants.draw(subject(root), "all", seed, 2)] for seed in range(5)]
    assert all(sorted(f) == ["unseen", "watched"] for f in formulas)


def test_every_module_has_tests_and_every_row_of_the_table_is_true():
    told = mutants.SUBJECT
    folders = ("kalman", "entities", "observation", "slam", "generated")
    areas = {
        "belief": ["slamlib/belief.py"],
        **{name: sorted(_modules(f"slamlib/{name}")) for name in folders},
    }
    assert {area: sorted(files) for area, files in told.areas.items()} == areas
    assert all(tests for tests in told.files.values())
    for test in [*told.left_out, *(test for tests in told.files.values() for test in tests)]:
        file, *names = test.split("::")  # a whole file, or one test of it
        text = (layout.ROOT / file).read_text("utf-8")
        assert all(f"def {name}(" in text for name in names), test
    assert mutants.stale(told) == []


def _modules(folder: str) -> list[str]:
    """All modules of a folder, but for those that only have a docstring or gather imports."""
    files = (f for f in Path(layout.ROOT, folder).rglob("*.py") if f.name != "__init__.py")
    return [f.relative_to(layout.ROOT).as_posix() for f in files]
