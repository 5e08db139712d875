"""Reading mode: what a fold of code hides is said by its name, and a result stands before the code that is folded."""

from typing import Any

from docutils import nodes
from myst_nb.sphinx_ import HideCodeCellNode
from sphinx.transforms.post_transforms import SphinxPostTransform

FIGURES = ('class="picture"', 'class="sweep', 'class="player')
UNNAMED = '<summary aria-label="Toggle hidden content">'  # hides from a screen reader the name that is shown


class NamedFolds(SphinxPostTransform):
    """After MyST-NB has made the folds of a page: `Setup, 12 lines` instead of `Show code cell source`."""

    default_priority = 200
    formats = ("html",)

    def run(self, **kwargs: Any) -> None:
        """Name each fold; move the one of a cell's code below what the code shows."""
        for fold in list(self.document.findall(HideCodeCellNode)):
            cell = fold.parent
            lines = len(fold.astext().strip().splitlines())
            fold["prompt_show"] = fold["prompt_hide"] = f"{what(fold, cell)}, {lines} line{'s' * (lines != 1)}"
            if "above-input" in fold["classes"] and cell.children[-1] is not fold:
                cell.remove(fold)
                cell.append(fold)


def what(fold: nodes.Element, cell: nodes.Element) -> str:
    """What is folded, in a word or two."""
    if "below-input" in fold["classes"]:
        return "Output"
    if "tag_setup" in cell["classes"]:
        return "Setup"
    shown = "".join(raw.astext() for raw in cell.findall(nodes.raw))
    return "Code of this figure" if any(mark in shown for mark in FIGURES) else "Code"


def named_aloud(app: Any, page: str, template: str, context: dict[str, Any], tree: Any) -> None:
    """A screen reader hears the name of a fold; that it can be opened, it knows by itself."""
    if UNNAMED in context.get("body", ""):
        context["body"] = context["body"].replace(UNNAMED, "<summary>")


def setup(app: Any) -> dict[str, bool]:
    """Connect both."""
    app.add_post_transform(NamedFolds)
    app.connect("html-page-context", named_aloud)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
