"""The reference of slamlib and slambook, read from their sources: a page names packages, and this fills it.

In a page of Markdown, a block ```{api} slamlib.geometry``` stands for all public names of a package's modules:
signatures as the source writes them, docstrings, and a link from each chapter, equation and class that they name.
`{exported}` in place of `{api}` takes only the names that the package lists in `__all__`.
"""

import ast
import importlib.util
import inspect
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.util.nodes import make_refnode

BLOCK = re.compile(r"```\{(api|exported)\} ([\w.]+)\n```")
Definition = ast.FunctionDef | ast.ClassDef | ast.Assign


@dataclass(frozen=True)
class Module:
    """A module's name, its file, its syntax tree and its lines."""

    name: str
    file: Path
    tree: ast.Module
    lines: list[str]

    @classmethod
    def of(cls, name: str) -> "Module":
        """Read a module; none of it is run but for the packages that it lies in."""
        file = origin(name)
        text = file.read_text("utf-8")
        return cls(name, file, ast.parse(text), text.splitlines())

    def exported(self) -> dict[str, str]:
        """The names in `__all__`, and the modules that they are from."""
        listed: list[str] = []
        home: dict[str, str] = {}
        for node in self.tree.body:
            if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__":
                listed = ast.literal_eval(node.value)
            elif isinstance(node, ast.ImportFrom):
                home |= {alias.name: str(node.module) for alias in node.names}
        return {name: home.get(name, self.name) for name in listed if not name.startswith("_")}

    def public(self) -> dict[str, Definition]:
        """Its own functions, classes and values, in their order."""
        found: dict[str, Definition] = {}
        for node in self.tree.body:
            if isinstance(node, ast.FunctionDef | ast.ClassDef):
                found[node.name] = node
            elif isinstance(node, ast.Assign) and not ast.unparse(node.value).startswith("TypeVar("):
                found[ast.unparse(node.targets[0])] = node
        return {name: node for name, node in found.items() if name.isidentifier() and not name.startswith("_")}


def origin(name: str) -> Path:
    """The file of a module, or of a package's own; raises ModuleNotFoundError."""
    spec = importlib.util.find_spec(name)
    if spec is None or spec.origin is None:
        raise ModuleNotFoundError(f"there is no module {name}")
    return Path(spec.origin)


def modules(package: str) -> list[Module]:
    """A module, or all of a package; "slamlib" alone stands for its root."""
    file = origin(package)
    if file.name != "__init__.py":
        return [Module.of(package)]
    top = file.parent
    files = top.rglob("*.py") if "." in package else top.glob("*.py")
    names = {".".join([package, *file.relative_to(top).with_suffix("").parts]) for file in files}
    names = {name.removesuffix(".__init__") for name in names if not name.endswith("__main__")}
    return [Module.of(name) for name in sorted(names)]


@dataclass(frozen=True)
class Reference:
    """What fills the pages; `pages`: where each chapter is, by its name; `labels`: those of all equations."""

    pages: dict[str, str]
    labels: set[str]

    def filled(self, text: str) -> str:
        """A page with its blocks replaced."""
        return BLOCK.sub(lambda found: self.exported(found[2]) if found[1] == "exported" else self.all(found[2]), text)

    def all(self, package: str) -> str:
        """All modules, each under a heading of its own."""
        found = modules(package)
        also = {
            f"{home}.{name}": f"{module.name}.{name}" for module in found for name, home in module.exported().items()
        }
        functions = {f"{module.name}.{name}" for module in found for name in module.public()}
        blocks = []
        for module in found:
            described = [line for name in module.public() for line in self.described(module, name, module.name, also)]
            words = self.words(ast.get_docstring(module.tree))
            kind = "currentmodule" if module.name in functions else "module"  # one of the two has the name
            lines = [f".. py:{kind}:: {module.name}", "", *words, *described]
            blocks.append("\n".join([f"## `{module.name}`", "", "```{eval-rst}", *lines, "```", ""]))
        return "\n".join(blocks)

    def exported(self, package: str) -> str:
        """The names that a package exports, under one heading."""
        top = Module.of(package)
        lines = [f".. py:module:: {package}", "", *self.words(ast.get_docstring(top.tree))]
        for name, home in top.exported().items():
            also = {f"{package}.{name}": f"{home}.{name}"} if home != package else {}
            lines += self.described(Module.of(home), name, package, also)
        return "\n".join([f"## `{package}`", "", "```{eval-rst}", *lines, "```", ""])

    def described(self, module: Module, name: str, home: str, also: dict[str, str]) -> list[str]:
        """A name of a module as reStructuredText; `also`: the second names of some."""
        node = module.public().get(name)
        if node is None:  # a module that a package exports, or what its functions make
            return []
        canonical = also.get(f"{home}.{name}", f"{home}.{name}")
        options = [f"   :canonical: {canonical}"] if canonical != f"{home}.{name}" else []
        if isinstance(node, ast.Assign):
            value = ast.unparse(node.value)
            options += [f"   :value: {value}"] if len(value) < 80 else []
            words = self.words(_comment(module.lines, node))
            return [f".. py:data:: {name}", *options, "", *_indented(words)]
        if isinstance(node, ast.FunctionDef):
            return [f".. py:function:: {name}{_signature(node)}", *options, "", *_indented(self.words(_doc(node)))]
        kind = "exception" if any("Error" in ast.unparse(base) for base in node.bases) else "class"
        lines = [f".. py:{kind}:: {name}{_fields(node)}", *options, "", *_indented(self.words(_doc(node)))]
        for inner in node.body:
            if isinstance(inner, ast.FunctionDef) and not inner.name.startswith("_"):
                lines += _indented(self.method(inner))
        return lines

    def method(self, node: ast.FunctionDef) -> list[str]:
        """A method, or a property, of a class."""
        kinds = {ast.unparse(decorator) for decorator in node.decorator_list}
        words = _indented(self.words(_doc(node)))
        if any(kind.endswith("setter") for kind in kinds):
            return []
        if kinds & {"property", "cached_property", "functools.cached_property"}:
            type_ = [f"   :type: {ast.unparse(node.returns)}"] if node.returns else []
            return [f".. py:property:: {node.name}", *type_, "", *words]
        bound = [f"   :{kind}:" for kind in ("classmethod", "staticmethod") if kind in kinds]
        return [f".. py:method:: {node.name}{_signature(node, 'staticmethod' not in kinds)}", *bound, "", *words]

    def words(self, text: str | None) -> list[str]:
        """A docstring as reStructuredText, with links."""
        lines: list[str] = []
        for paragraph in re.split(r"\n(?:[ \t]*\n)+", (text or "").strip("\n")):
            code = inspect.cleandoc(paragraph)
            if paragraph.startswith("    ") or code.startswith(">>> "):
                language = "pycon" if code.startswith(">>> ") else "python"
                lines += [f".. code-block:: {language}", "", *_indented(code.split("\n")), ""]
            elif re.search(r"\n +\S", paragraph):  # a list of names, and what each is
                entries = re.sub(r"\n +", " ", paragraph).split("\n")
                lines += [*(f"- {self.linked(entry)}" for entry in entries), ""]
            else:
                lines += [*self.linked(paragraph).split("\n"), ""]
        return lines

    def linked(self, text: str) -> str:
        """Escaped words, with chapters and equations as links."""
        pieces = re.split(r"`([^`]+)`", text)
        for i in range(0, len(pieces), 2):
            piece = re.sub(r"([\\*|_])", r"\\\1", pieces[i])
            piece = re.sub(r"\(([a-z]+-[a-z-]+)\)", lambda m: f":eq:`{m[1]}`" if m[1] in self.labels else m[0], piece)
            pieces[i] = re.sub(r"(?<=hapter )[a-z]+(?:\\_[a-z]+)*", self._page, piece)
        for i in range(1, len(pieces), 2):  # a letter beside a literal would make it none
            before = "\\ " if pieces[i - 1][-1:].isalnum() else ""
            pieces[i] = f"{before}``{pieces[i]}``" + ("\\ " if pieces[i + 1][:1].isalnum() else "")
        return "".join(pieces)

    def _page(self, found: re.Match[str]) -> str:
        page = self.pages.get(found[0].replace("\\_", "_"))
        return f":doc:`/{page}`" if page else found[0]


def _doc(node: ast.FunctionDef | ast.ClassDef) -> str | None:
    return ast.get_docstring(node)


def _comment(lines: list[str], node: ast.Assign) -> str:
    """What stands behind a value, or else in the lines above it."""
    _, found, behind = lines[node.lineno - 1].partition("  # ")
    above: list[str] = []
    for line in reversed(lines[: node.lineno - 1]):
        if not line.startswith("# "):
            break
        above.insert(0, line[2:])
    text = behind if found else " ".join(above)
    return "" if re.match(r"type:|noqa|--", text) else text


def _signature(node: ast.FunctionDef, method: bool = False) -> str:
    """A function's arguments and result; of a model its arguments with their manifolds, or their shapes."""
    for decorator in node.decorator_list:
        if isinstance(decorator, ast.Call) and ast.unparse(decorator.func) == "model":
            given = {str(word.arg): _shape(word.value) for word in decorator.keywords}
            result = given.pop("returns", "")
            arguments = ", ".join(f"{name}: {spec}" for name, spec in given.items())
            return f"({arguments})" + (f" -> {result}" if result else "")
    arguments_ = node.args
    if method:
        arguments_ = ast.arguments(**{**vars(arguments_), "args": arguments_.args[1:]})
    return f"({ast.unparse(arguments_)})" + (f" -> {ast.unparse(node.returns)}" if node.returns else "")


def _shape(spec: ast.expr) -> str:
    """What stands behind a model's argument: its manifold, or its shape as Sphinx can show it."""
    if isinstance(spec, ast.Tuple):
        return f"array[{', '.join(map(ast.unparse, spec.elts))}]" if spec.elts else "number"
    return f"array[{ast.unparse(spec)}]" if isinstance(spec, ast.Constant) else ast.unparse(spec)


def _fields(node: ast.ClassDef) -> str:
    """What a class is made with: the fields of a dataclass or a named tuple, or what its `__init__` takes."""
    for inner in node.body:
        if isinstance(inner, ast.FunctionDef) and inner.name == "__init__":
            return _signature(inner, method=True).partition(" -> ")[0]
    plain = [*map(ast.unparse, node.decorator_list), *map(ast.unparse, node.bases)]
    if not any("dataclass" in name or name in ("NamedTuple", "Plain") for name in plain):
        return ""
    fields = []
    for inner in node.body:
        if isinstance(inner, ast.AnnAssign) and not ast.unparse(inner.target).startswith("_"):
            value = f" = {ast.unparse(inner.value)}" if inner.value else ""
            if "init=False" not in value and "ClassVar" not in ast.unparse(inner.annotation):
                fields.append(f"{ast.unparse(inner.target)}: {ast.unparse(inner.annotation)}{value}")
    return f"({', '.join(fields)})"


def _indented(lines: list[str]) -> list[str]:
    return [f"   {line}" if line else "" for line in lines]


def _fill(app: Any, page: str, source: list[str]) -> None:
    blocks = BLOCK.findall(source[0])
    if blocks:
        book = Path(app.srcdir) / "book"
        found = [file for folder in ("chapters", "sources") for file in (book / folder).glob("*.*")]
        pages = {file.stem: file.relative_to(app.srcdir).with_suffix("").as_posix() for file in found}
        labels = {label for file in found for label in re.findall(r"\$\$ \(([a-z-]+)\)", file.read_text("utf-8"))}
        source[0] = Reference(pages, labels).filled(source[0])
        for file in [Path(__file__), *(module.file for _, package in blocks for module in modules(package))]:
            app.env.note_dependency(str(file))


def _resolve(app: Any, env: Any, node: Any, shown: Any) -> Any:
    """A link to what has this name anywhere in the packages, if it is one thing; else the name without a link."""
    if node.get("refdomain") != "py":
        return None
    last = "." + node["reftarget"].rsplit(".", 1)[-1]
    objects = env.get_domain("py").objects
    found = {(entry.docname, entry.node_id) for name, entry in objects.items() if name.endswith(last)}
    if len(found) != 1:
        return shown
    ((page, anchor),) = found
    return make_refnode(app.builder, node["refdoc"], page, anchor, shown)


def _link(app: Any, tree: Any, page: str) -> None:
    """Names of the packages that stand in the text as code lead to the reference; a field leads to its class."""
    objects = app.env.get_domain("py").objects
    for literal in list(tree.findall(nodes.literal)):
        text = literal.astext()
        if not re.fullmatch(r"[A-Za-z]\w*(\.\w+)+", text) or isinstance(literal.parent, nodes.reference):
            continue
        for name in (text, text.rpartition(".")[0]):
            found = [entry for full, entry in objects.items() if full == name or full.endswith(f".{name}")]
            places = {(entry.docname, entry.node_id) for entry in found}
            if len(places) == 1 and ("." in name or name[0].isupper()):
                ((target, anchor),) = places
                literal.replace_self(make_refnode(app.builder, page, target, anchor, literal.deepcopy()))
                break


def setup(app: Any) -> dict[str, bool]:
    """Connect the three."""
    app.connect("source-read", _fill)
    app.connect("missing-reference", _resolve)
    app.connect("doctree-resolved", _link)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
