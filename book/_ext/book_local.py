"""Small things that the book needs from Sphinx."""

from typing import Any


def setup(app: Any) -> dict[str, bool]:
    """Jupyter Book sets comments_config even when sphinx_comments, which loads outside scripts, is left out."""
    app.add_config_value("comments_config", {}, "html")
    return {"parallel_read_safe": True, "parallel_write_safe": True}
