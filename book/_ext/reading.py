"""Reading mode: what a fold of code hides is said by its name, a result stands before the code that is folded, and an
output that only confirms is one line."""

import re
from typing import Any

from docutils import nodes
from myst_nb.sphinx_ import HideCodeCellNode
from sphinx.transforms.post_transforms import SphinxPostTransform

FIGURES = ('class="picture"', 'class="sweep', 'class="player')
TABLE = '<table class="results">'
SAME = re.compile(
    r"\bsame(?: on unit vectors)?: (\d+) of (\d+) entries by symbolic difference(, \d+ zero to 50 digits)?"
)
HOLDS = re.compile(
    r"^this cell is slamlib/|\bagrees? with the complex step|is the complex step's at"
    r"|: +True(?: True)*$|^proved: |proved$"
)
UNNAMED = '<summary aria-label="Toggle hidden content">'  # hides from a screen reader the name that is shown


class NamedFolds(SphinxPostTransform):
    """After MyST-NB has made the folds of a page: `Setup, 12 lines` instead of `Show code cell source`."""

    default_priority = 200
    formats = ("html",)

    def run(self, **kwargs: Any) -> None:
        """Name each fold; move the one of a cell's code below what the code shows."""
        for fold in list(self.document.findall(HideCodeCellNode)):
            cell = fold.parent
            fold["prompt_show"] = fold["prompt_hide"] = f"{what(fold, cell)}, {length(fold)}"
            if "above-input" in fold["classes"] and cell.children[-1] is not fold:
                cell.remove(fold)
                cell.append(fold)


def length(fold: nodes.Element) -> str:
    """How many lines it has, or a table rows."""
    lines, rows = len(fold.astext().strip().splitlines()), fold.astext().count("<tr>") - 1  # but for the heads
    return f"{rows} rows" if rows > 0 else f"{lines} line{'s' * (lines != 1)}"


def what(fold: nodes.Element, cell: nodes.Element) -> str:
    """What is folded, in a word or two."""
    if "below-input" in fold["classes"]:
        return "Table" if TABLE in fold.astext() else "Output"
    if "tag_setup" in cell["classes"]:
        return "Setup"
    shown = "".join(raw.astext() for raw in cell.findall(nodes.raw))
    return "Code of this figure" if any(mark in shown for mark in FIGURES) else "Code"


class Confirmations(SphinxPostTransform):
    """An output that only confirms is a line with a tick; where it has more lines, they are folded behind their sum.
    Behind it is the code, too, of a proof whose code is folded."""

    default_priority = 201
    formats = ("html",)

    def run(self, **kwargs: Any) -> None:
        """Mark each such output."""
        for output in self.document.findall(
            lambda node: "cell_output" in getattr(node, "attributes", {}).get("classes", ())
        ):
            if not all(isinstance(block, nodes.literal_block) for block in output.children):
                continue
            said = output.astext().strip().splitlines()
            told = confirmation(said)
            if told is None:
                continue
            output["classes"].append("confirmed")
            fold = next(iter(output.parent.findall(HideCodeCellNode)), None)
            if fold is not None and all(map(SAME.search, said)):
                fold["classes"].append("confirmed")
                fold["prompt_show"] = fold["prompt_hide"] = told
                output.parent.remove(output)
                fold.append(output)
            elif len(said) > 1:
                output.insert(0, nodes.raw("", f"<details><summary>{told}</summary>", format="html"))
                output.append(nodes.raw("", "</details>", format="html"))


def confirmation(said: list[str]) -> str | None:
    """What lines that only confirm come to; None if one of them says anything else."""
    if not said or any("False" in line or not (SAME.search(line) or HOLDS.search(line)) for line in said):
        return None
    found = [SAME.search(line) for line in said]
    if not all(found):
        return f"{len(said)} checks hold"
    entries = sum(int(match[2]) for match in found if match)
    how = "equal to 50 digits" if any(match[3] for match in found if match) else "proved by computer algebra"
    return f"{how}, {entries} {'entry' if entries == 1 else 'entries'}"


def named_aloud(app: Any, page: str, template: str, context: dict[str, Any], tree: Any) -> None:
    """A screen reader hears the name of a fold; that it can be opened, it knows by itself."""
    if UNNAMED in context.get("body", ""):
        context["body"] = context["body"].replace(UNNAMED, "<summary>")


def setup(app: Any) -> dict[str, bool]:
    """Connect them."""
    app.add_post_transform(NamedFolds)
    app.add_post_transform(Confirmations)
    app.connect("html-page-context", named_aloud)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
