"""The index of the book's search: the prose of each place of a page, with its heading and its anchor.

Sphinx' own index knows which pages a word is on, code and printouts included. This one takes its place in
searchindex.js, and knows the section; book/_static/search.js ranks what it finds there. Code is left out.
"""

import json
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from posixpath import dirname, join, normpath
from typing import Any

from docutils import nodes
from sphinx import addnodes

CODE = (nodes.literal_block, nodes.doctest_block, nodes.raw, nodes.math_block, addnodes.desc_signature)
UNSEEN = (nodes.comment, nodes.title, nodes.term, nodes.system_message, addnodes.toctree, addnodes.index)
HIDDEN = {"cell_output", "solution"}  # printouts; what a reader opens last, and a summary would give away
INDEX = "searchindex.js"


@dataclass
class Place:
    """A section, an exercise, a term of the glossary or a documented name; `about`: the pages that a term names."""

    kind: str
    anchor: str
    title: str
    words: list[str] = field(default_factory=list)
    about: list[str] = field(default_factory=list)

    def row(self) -> list[Any]:
        """The place as the index has it."""
        row = [self.kind, self.anchor, self.title, spaced("".join(self.words))]
        return [*row, self.about] if self.about else row


def spaced(text: str) -> str:
    """The text with one space between words."""
    return " ".join(text.split())


def places(page: str, document: nodes.document) -> list[Place]:
    """The places of a page in their order; the first one is what stands above its sections."""
    found: list[Place] = []
    for section in document.children:
        if isinstance(section, nodes.section):
            found += below(page, section, Place("page" if not found else "section", "", heading(section)))
    return found


def below(page: str, node: nodes.Node, place: Place) -> Iterator[Place]:
    """A place with the words below a node, and the places that begin there."""
    inner: list[tuple[nodes.Node, Place]] = []
    collect(page, node, place, inner)
    yield place
    for child, begun in inner:
        yield from below(page, child, begun)


def collect(page: str, node: nodes.Node, place: Place, inner: list[tuple[nodes.Node, Place]]) -> None:
    """Give a place the words below a node; what begins a place of its own is put into `inner`."""
    for child in node.children:
        begun = beginning(child)
        if begun:
            inner.append((child, begun))
        elif isinstance(child, nodes.Text):
            place.words.append(child.astext())
        elif isinstance(child, nodes.math):
            place.words.append(symbol(child))
        elif not isinstance(child, CODE + UNSEEN) and HIDDEN.isdisjoint(child.get("classes", ())):
            if place.kind == "term" and child.get("internal") and child.get("refuri"):  # to another page
                place.about.append(normpath(join(dirname(page), child["refuri"].partition("#")[0])))
            collect(page, child, place, inner)
            if not isinstance(child, nodes.Inline):
                place.words.append(" ")


def beginning(node: nodes.Node) -> Place | None:
    """The place that begins with a node; most begin none."""
    if isinstance(node, nodes.section) and node["ids"] and not isinstance(node.parent, nodes.Admonition):
        return Place("section", node["ids"][0], heading(node))
    if isinstance(node, nodes.Admonition) and node["ids"] and "exercise" in node["classes"]:
        return Place("exercise", node["ids"][0], "Exercise")
    if isinstance(node, nodes.definition_list_item | addnodes.desc) and isinstance(node.children[0], nodes.Element):
        first = node.children[0]
        if isinstance(first, nodes.term) and first["ids"]:
            return Place("term", first["ids"][0], spaced(first.astext()))
        if isinstance(first, addnodes.desc_signature) and first["ids"]:
            return Place("name", first["ids"][0], first["ids"][0])
    return None


def heading(section: nodes.Element) -> str:
    """The words of a section's heading."""
    title = Place("", "", "")
    collect("", section.children[section.first_child_matching_class(nodes.title) or 0], title, [])
    return spaced("".join(title.words))


def symbol(formula: nodes.math) -> str:
    """A letter or a number in the text as it is read; of a longer formula, that there is one."""
    text = formula.astext()
    return text if text.isalnum() else "…"


class Index:
    """The rows of all pages, by their addresses; a build writes every page, so it begins with none."""

    def __init__(self) -> None:
        self.rows: dict[str, list[list[Any]]] = {}

    def note(self, app: Any, document: nodes.document, page: str) -> None:
        """Keep the places of a page that is about to be written."""
        if app.builder.format == "html":
            address = app.builder.get_target_uri(page)
            numbers = app.env.toc_fignumbers.get(page, {}).get("exercise", {})
            found = places(address, document)
            if "nosearch" in app.env.metadata[page]:  # Sphinx' own word for a page of which the search has the title
                found = [Place(place.kind, place.anchor, place.title) for place in found[:1]]
            for place in found:
                if place.kind == "exercise":
                    place.title = " ".join(["Exercise", ".".join(map(str, numbers.get(place.anchor, ())))]).strip()
            if found:
                self.rows[address] = [place.row() for place in found]

    def write(self, app: Any, error: Exception | None) -> None:
        """Put the index in the place of Sphinx' own, which the theme's search page loads."""
        file = Path(app.outdir) / INDEX
        if error is None and file.is_file():
            text = json.dumps(dict(sorted(self.rows.items())), ensure_ascii=False, separators=(",", ":"))
            file.write_text(f"Search.setIndex({text})", "utf-8")


def ranking(app: Any, page: str, template: str, context: dict[str, Any], document: Any) -> None:
    """The search page has a script of its own, which runs when Sphinx' scripts are there."""
    if page == "search":
        app.add_js_file("search.js", loading_method="defer")


def setup(app: Any) -> dict[str, bool]:
    """Connect them."""
    index = Index()
    app.connect("doctree-resolved", index.note)
    app.connect("build-finished", index.write)
    app.connect("html-page-context", ranking)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
