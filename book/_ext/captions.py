"""Captions: a Markdown cell `**Figure: Title.** What is seen.` below a figure's cell becomes its numbered caption.

So a notebook reads the same everywhere. The label comes from the title: `fig-` and its words, joined by hyphens.
A link to it, `[words](#fig-title)` or `[words](page.ipynb#fig-title)`, is shown as the number, "Fig. 11.1".
"""

from typing import Any

from docutils import nodes
from sphinx.addnodes import pending_xref
from sphinx.transforms import SphinxTransform
from sphinx.util import logging

MARK = "Figure: "
LABEL = "fig-"
logger = logging.getLogger(__name__)


class Captions(SphinxTransform):
    """Before MyST resolves links to places in a page, Sphinx collects what has a number, and quotes become round."""

    default_priority = 700

    def apply(self, **kwargs: Any) -> None:
        """Move each caption into its figure's cell; make links to figures references by number."""
        for paragraph in list(self.document.findall(nodes.paragraph)):
            first = next((child for child in paragraph.children if child.astext()), None)  # MyST begins with no text
            if isinstance(first, nodes.strong) and first.astext().startswith(MARK):
                self.caption(paragraph, first)
        for link in list(self.document.findall(lambda node: isinstance(node, nodes.reference | pending_xref))):
            label = target(link)
            if label.startswith(LABEL):
                words = nodes.inline("", link.astext(), classes=["xref", "std", "std-numref"])
                options = {"refdoc": self.env.docname, "refdomain": "std", "reftype": "numref", "reftarget": label}
                link.replace_self(pending_xref("", words, **options, refexplicit=False, refwarn=True))

    def caption(self, paragraph: nodes.paragraph, heading: nodes.strong) -> None:
        """The caption of the cell before it; where there is none, the build says so."""
        siblings = paragraph.parent.children
        place = siblings.index(paragraph)
        cell = siblings[place - 1] if place else None
        if not isinstance(cell, nodes.container) or "cell" not in cell["classes"]:
            logger.warning("a caption stands below no cell: %s", heading.astext(), location=paragraph)
            return
        title = heading.astext().removeprefix(MARK)
        heading.clear()
        heading += nodes.Text(title)
        name = LABEL + nodes.make_id(title)
        figure = nodes.figure(
            "", nodes.caption("", "", *paragraph.children), names=[name], ids=[name], classes=["of-cell"]
        )
        paragraph.parent.remove(paragraph)
        cell.append(figure)
        self.document.note_explicit_target(figure)


def target(link: nodes.Element) -> str:
    """The place that a link of MyST leads to, in this page or in another one."""
    if link.get("id_link"):
        return str(link["refuri"][1:])
    return str(link.get("reftargetid") or "")


def setup(app: Any) -> dict[str, bool]:
    """Connect the transform."""
    app.add_transform(Captions)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
