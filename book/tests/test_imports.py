"""The book takes each thing from one place: from `import slamlib as sl`, or else from one module."""

import ast
from collections import defaultdict
from importlib import import_module

import nbformat

import slamlib
from book.tools import layout

OWN = {"own-landmark", "own-sensor"}  # what a reader writes into the package


def imported():
    """Of each name of slamlib that a cell imports: the object, the module, and where."""
    for file in layout.notebooks():
        for cell in nbformat.read(file, as_version=4).cells:
            tags = set(cell.metadata.get("tags", []))
            if cell.cell_type != "code" or cell.source.startswith("%%tangle") or tags & OWN:
                continue
            lines = ["pass" if line.startswith(("%", "!")) else line for line in cell.source.split("\n")]
            for node in ast.walk(ast.parse("\n".join(lines))):
                if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "slamlib":
                    for alias in node.names:
                        home = import_module(node.module)
                        if not hasattr(home, alias.name):
                            import_module(f"{node.module}.{alias.name}")
                        yield getattr(home, alias.name), node.module, f"{file.stem} {cell.id}: {alias.name}"


def test_each_thing_is_imported_from_one_place_and_from_the_door_where_it_is_there():
    door = {id(getattr(slamlib, name)): name for name in slamlib.HOMES}
    places = defaultdict(lambda: defaultdict(list))
    for found, module, where in imported():
        places[id(found)][module].append(where)
    assert len(places) > 100
    twice = [dict(modules) for modules in places.values() if len(modules) > 1]
    assert twice == []
    assert [modules for thing, modules in places.items() if thing in door and "slamlib" not in modules] == []
