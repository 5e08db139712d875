"""Calls that axes and figures do not have."""

from slamlib.errors import UnknownNameError


class UnknownCallError(UnknownNameError, AttributeError):
    """Axes or a figure are asked for something that they do not have."""

    @classmethod
    def of_object(cls, what: str, name: str, known: list[str]) -> "UnknownCallError":
        """The message, with what is possible; names that Python asks for by itself get a short one."""
        text = (
            f"{what} has no {name}"
            if name.startswith("_")
            else str(UnknownNameError.of(f"call of {what}", name, known))
        )
        return cls(text)
