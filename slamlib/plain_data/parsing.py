"""Texts as plain data (dictionaries, lists, numbers, words): JSON, TOML, YAML, OpenCV's XML, lists of MATLAB."""

import json
import re
import tomllib
from collections.abc import Iterable
from functools import lru_cache
from typing import Any

from slamlib.errors import SlamlibError, optional

_NUMBER = re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?")
_WORDS: dict[str, Any] = {"": None, "~": None, "null": None, "true": True, "false": False}
_WORDS |= {f"{sign}{dot}inf": float(f"{sign}inf") for sign in ("", "+", "-") for dot in ("", ".")}
_WORDS |= {"nan": float("nan"), ".nan": float("nan")}
# "[section]", or "name = value", whose list in brackets may go over several lines.
_ASSIGNMENT = re.compile(r"^[ \t]*(?:\[([\w .-]+)\][ \t]*$|([\w.-]+)[ \t]*=[ \t]*(\[[^\]]*\]|[^\n]*))", re.M)
_LIST_WITHOUT_COMMAS = re.compile(r"=\s*\[[^\]\"']*[0-9.][ \t]*(?:;|[ \t][-+.0-9])")


@lru_cache(maxsize=8)  # each format looks at the same text; nobody changes what it gets
def parsed(text: str) -> Any:
    """The plain data of a text; its first sign, or its equals signs, tell the language.

    Raises SlamlibError for a text with errors, for a name that is there twice, and for YAML without PyYAML.
    """
    try:
        return _language(text)(text)
    except RecursionError:
        raise SlamlibError("it is nested too deeply") from None


def value_of(word: str) -> Any:
    """The number, True, False or None that a word stands for, or else the word."""
    if _NUMBER.fullmatch(word):
        return int(word) if word.lstrip("+-").isdecimal() and len(word) < 19 else float(word)  # or infinity
    return _WORDS.get(word.lower(), word)


def _language(text: str) -> Any:
    first = text.lstrip()[:1]
    return {"{": _json, "<": _xml}.get(first) or (_assignments if _ASSIGNMENT.search(text) else _yaml)


def named(pairs: Iterable[tuple[Any, Any]]) -> dict[str, Any]:
    """A dictionary. Raises SlamlibError for a name that is there twice: nobody can tell which of them is meant."""
    found: dict[str, Any] = {}
    for name, value in pairs:
        if str(name) in found:
            raise SlamlibError(f"{name} is there twice: delete one of them")
        found[str(name)] = value
    return found


def _json(text: str) -> Any:
    """JSON, or YAML that begins with a brace."""
    try:
        return json.loads(text, object_pairs_hook=named)
    except ValueError as error:
        try:
            return _yaml(text)
        except SlamlibError:
            raise SlamlibError(f"it is no JSON: {error}") from None


def _assignments(text: str) -> Any:
    """TOML, or by its lists without commas, "name = [1 2; 3 4]", a text as MATLAB and MRPT write it."""
    try:
        return tomllib.loads(text)
    except ValueError as error:
        if not _LIST_WITHOUT_COMMAS.search(text):
            raise SlamlibError(f"it is no TOML: {error}") from None
    sections: list[tuple[str | None, list[tuple[str, Any]]]] = [(None, [])]
    for section, name, value in _ASSIGNMENT.findall(re.sub(r"(?://|#|%).*", "", text)):
        if section:
            sections.append((section, []))
        else:
            sections[-1][1].append((name, _matlab(value.strip().rstrip(";").rstrip())))
    (_, outside), *inside = sections
    return named([*outside, *((name, named(pairs)) for name, pairs in inside)])


def _matlab(text: str) -> Any:
    """The value of a word, or of a list in brackets; of rows, which ";" or a new line ends, a list of lists."""
    if not text.startswith("["):
        return value_of(text)
    rows = [[value_of(word) for word in re.split(r"[\s,]+", row.strip())] for row in re.split(r"[;\n]", text[1:-1])]
    rows = [row for row in rows if row != [None]]
    return rows[0] if len(rows) == 1 else rows


def _xml(text: str) -> Any:
    from xml.etree import ElementTree  # here: the book's pages run slamlib on a Python that has no xml

    try:
        return _element(ElementTree.fromstring(text))
    except (ValueError, ElementTree.ParseError) as error:
        raise SlamlibError(f"it is no XML: {error}") from None


def _element(element: Any) -> Any:
    """What an element of OpenCV's XML holds: named values, a list (of "_"), numbers, or a text."""
    if len(element) and all(child.tag == "_" for child in element):
        return [_element(child) for child in element]
    if len(element):
        return named([(child.tag, _element(child)) for child in element])
    words = (element.text or "").split()
    values = [value_of(word) for word in words]
    if len(values) == 1:
        return values[0]
    return values if values and not any(isinstance(value, str) for value in values) else " ".join(words).strip('"')


def _yaml(text: str) -> Any:
    """YAML, with what OpenCV writes and reads beside it: its header, tags, tabs, and a colon without a blank."""
    yaml = optional("yaml", "to read a file of YAML", "images")

    class Loader(yaml.BaseLoader):  # type: ignore[name-defined]
        """Every scalar is a text for it, and no tag means anything: so "1e-3" and "!!opencv-matrix" are no surprise."""

        def construct_scalar(self, node: Any) -> Any:
            word = super().construct_scalar(node)
            return word if node.style in ("'", '"', "|", ">") else value_of(word)

        def construct_mapping(self, node: Any, deep: bool = False) -> Any:
            if not isinstance(node, yaml.MappingNode):
                raise SlamlibError(f"names with values are wanted in line {node.start_mark.line + 1}")
            pairs = [(self.construct_object(k, True), self.construct_object(v, True)) for k, v in node.value]
            merged = [value for name, value in pairs if name == "<<" and isinstance(value, dict)]
            own = named([pair for pair in pairs if not (pair[0] == "<<" and pair[1] in merged)])
            return {name: value for data in (*merged, own) for name, value in data.items()}

    plain = re.sub(r"\A\s*%YAML.*", "", text).replace("\t", "    ")
    plain = re.sub(r"^(\s*[A-Za-z_][\w.]*):(?=[\[\d.+-])", r"\1: ", plain, flags=re.M)
    try:
        documents = [data for data in yaml.load_all(plain, Loader) if data is not None]
    except (yaml.YAMLError, ValueError) as error:
        mark = getattr(error, "problem_mark", None)
        where = f", line {mark.line + 1}" if mark else ""
        why = getattr(error, "problem", None) or getattr(error, "reason", None) or error
        raise SlamlibError(f"it is no YAML{where}: {' '.join(str(why).split())}") from None
    if any(data != documents[0] for data in documents):
        raise SlamlibError("it holds several documents (---) that differ: keep the one that is meant")
    return documents[0] if documents else None
