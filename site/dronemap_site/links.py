"""Makes the links of a document lead where they lead in the site."""

import posixpath
import re
from dataclasses import dataclass, field

from .sources import Sources

# Code comes first, so that a link within it is none.
LINK = re.compile(
    r"(?P<code>(?P<ticks>`+)(?!`).+?(?<!`)(?P=ticks)(?!`))"
    r"|(?P<image>!?)\[(?P<text>(?:[^\[\]`]|`[^`]*`|\[[^\[\]]*\])*)\]"
    r"\((?P<target>[^()\s]*(?:\([^()\s]*\)[^()\s]*)*)\)",
    re.DOTALL,
)
FENCE = re.compile(r"^ *(`{3,}|~{3,})")
# Says to tests what becomes of a code block; nothing for readers of the site.
NOTE = re.compile(r"^ *<!-- (not run|fails): .* -->$")
ELSEWHERE = re.compile(r"^[a-z][a-z0-9+.-]*:")


@dataclass(frozen=True)
class Place:
    """A line of a document in the checkout."""

    path: str
    line: int

    def __str__(self) -> str:
        return f"{self.path}:{self.line}"


@dataclass(frozen=True)
class AnchorLink:
    """A link to a heading of a page of the site, to be looked up when that page is made."""

    place: Place
    page: str
    anchor: str


@dataclass
class Linked:
    """A document for the site, and what its links ask for."""

    text: str = ""
    faults: list[str] = field(default_factory=list)
    anchors: list[AnchorLink] = field(default_factory=list)
    # Files of the checkout that readers can fetch from the site.
    files: set[str] = field(default_factory=set)


def rewritten(path: str, sources: Sources) -> Linked:
    linked = Linked()
    done: list[str] = []
    for first, lines, code in _parts(sources.text(path).split("\n")):
        part = "\n".join(lines)
        done.append(part if code else _Part(path, first, part, sources, linked).rewritten())
    linked.text = "\n".join(done)
    return linked


def _parts(lines: list[str]) -> list[tuple[int, list[str], bool]]:
    """The document cut at its fences: number of the first line, the lines, whether they are code."""
    parts: list[tuple[int, list[str], bool]] = [(1, [], False)]
    fence = ""
    for number, line in enumerate(lines, 1):
        found = FENCE.match(line)
        if fence:
            parts[-1][1].append(line)
            if line.strip() == fence:
                fence = ""
                parts.append((number + 1, [], False))
        elif found:
            fence = found[1]
            parts.append((number, [line], True))
        else:
            parts[-1][1].append("" if NOTE.match(line) else line)
    return [part for part in parts if part[1]]


@dataclass
class _Part:
    path: str
    first: int
    text: str
    sources: Sources
    linked: Linked

    def rewritten(self) -> str:
        return LINK.sub(self._replace, self.text)

    def _replace(self, found: re.Match[str]) -> str:
        if found["code"] or ELSEWHERE.match(found["target"]):
            return found[0]
        place = Place(self.path, self.first + self.text.count("\n", 0, found.start()))
        way, _, anchor = found["target"].partition("#")
        path = posixpath.normpath(posixpath.join(posixpath.dirname(self.path), way)) if way else self.path
        own = self.sources.pages[self.path]
        uri = self._uri(path, place)
        if uri is None:
            return found["text"]
        if anchor:
            self.linked.anchors.append(AnchorLink(place, uri, anchor))
        target = posixpath.relpath(uri, posixpath.dirname(own) or ".") if way else ""
        return f"{found['image']}[{found['text']}]({target}{'#' + anchor if anchor else ''})"

    def _uri(self, path: str, place: Place) -> str | None:
        """Where it is in the site; None: it is nothing that the site shows."""
        sources = self.sources
        uri = sources.pages.get(path) or sources.folders.get(path)
        if uri:
            return uri
        found = sources.root / path
        if path.startswith("..") or not found.exists():
            self.linked.faults.append(f"{place}: The link leads to {path}, which is not there.")
            return None
        if found.is_dir():
            return None
        if path.endswith(".md"):
            self.linked.faults.append(
                f"{place}: The link leads to {path}, which is no page of the site;"
                " name it in site/dronemap_site/sources.py."
            )
            return None
        if path.startswith("docs/"):
            return path.removeprefix("docs/")
        self.linked.files.add(path)
        return path
