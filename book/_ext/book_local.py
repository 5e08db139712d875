"""Small things that the book needs from Sphinx."""

from collections.abc import Iterator
from typing import Any

from IPython.lib.lexers import IPython3Lexer
from pygments.lexers.python import PythonLexer
from pygments.token import Name, _TokenType


class ChapterLexer(IPython3Lexer):  # type: ignore[misc]
    """Cells of a notebook; what stands below %%tangle is the Python of a module."""

    def get_tokens_unprocessed(self, text: str) -> Iterator[tuple[int, _TokenType, str]]:
        """Tokens of a cell, with their positions."""
        if not text.startswith("%%tangle "):
            yield from super().get_tokens_unprocessed(text)
            return
        first, _, module = text.partition("\n")
        yield 0, Name.Decorator, first + "\n"
        for place, token, value in PythonLexer().get_tokens_unprocessed(module):
            yield place + len(first) + 1, token, value


def plain_bibliography(app: Any, page: str, template: str, context: dict[str, Any], tree: Any) -> None:
    """Docutils gives the list of works ARIA roles that do not fit together; without them it is read aloud as text."""
    if "citation-list" in context.get("body", ""):
        context["body"] = context["body"].replace(' role="list"', "").replace(' role="doc-biblioentry"', "")


def setup(app: Any) -> dict[str, bool]:
    """Jupyter Book sets comments_config even when sphinx_comments, which loads outside scripts, is left out."""
    app.add_config_value("comments_config", {}, "html")
    for name in ("ipython3", "ipython"):
        app.add_lexer(name, ChapterLexer)
    app.connect("html-page-context", plain_bibliography)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
