"""Judges a built site: whether each link within it leads somewhere, and whether it loads nothing from elsewhere."""

import posixpath
import re
from collections.abc import Iterable
from functools import cached_property
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

from .links import AnchorLink

# What a browser fetches without being asked, and what people follow.
LOADED = {"img": "src", "script": "src", "source": "src", "iframe": "src", "video": "src", "audio": "src"}
LINKS_THAT_LOAD = ("stylesheet", "icon", "preload", "preconnect", "modulepreload", "manifest", "dns-prefetch")
STYLE_THAT_LOADS = re.compile(r"url\([\"']?(https?:)?//|@import")


class PageParser(HTMLParser):
    """The ids of one page, and each address in it with whether it is loaded."""

    def __init__(self) -> None:
        super().__init__()
        self.ids: set[str] = set()
        self.addresses: list[tuple[int, str, bool]] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        values = {name: value or "" for name, value in attrs}
        for name in ("id", "name") if tag == "a" else ("id",):
            if values.get(name):
                self.ids.add(values[name])
        line = self.getpos()[0]
        if tag in LOADED and values.get(LOADED[tag]):
            self.addresses.append((line, values[LOADED[tag]], True))
        elif tag == "link" and values.get("href"):
            loads = any(word in LINKS_THAT_LOAD for word in values.get("rel", "").split())
            self.addresses.append((line, values["href"], loads))
        elif tag == "a" and values.get("href"):
            self.addresses.append((line, values["href"], False))


class BuiltSite:
    def __init__(self, folder: Path) -> None:
        self.folder = folder

    @cached_property
    def pages(self) -> dict[str, PageParser]:
        parsed = {}
        for file in sorted(self.folder.rglob("*.html")):
            page = PageParser()
            page.feed(file.read_text(encoding="utf-8"))
            parsed[file.relative_to(self.folder).as_posix()] = page
        return parsed

    def dead_anchors(self, links: Iterable[AnchorLink]) -> list[str]:
        """Of documents, so that their own lines are named."""
        return [
            f"{link.place}: The page {link.page} has no heading #{link.anchor}."
            for link in links
            if link.anchor not in self.pages[_built_name(link.page)].ids
        ]

    def faults(self) -> list[str]:
        """Of all that was built, whoever wrote it."""
        return [
            fault
            for name, page in self.pages.items()
            for line, address, loaded in page.addresses
            if (fault := self._fault(name, line, address, loaded))
        ] + self._style_faults()

    def _fault(self, name: str, line: int, address: str, loaded: bool) -> str:
        parts = urlsplit(address)
        if parts.scheme == "data":
            return ""
        if parts.scheme or parts.netloc:
            return f"{name}:{line}: The page loads {address} from elsewhere." if loaded else ""
        path = unquote(parts.path)
        if not path:
            target = name
        elif path.startswith("/"):
            # The page for what is not found is served anywhere, so its addresses begin at the top.
            target = path.lstrip("/")
        else:
            target = posixpath.normpath(posixpath.join(posixpath.dirname(name), path))
        if target in (".", "") or (self.folder / target).is_dir():
            target = posixpath.normpath(posixpath.join(target, "index.html"))
        if not (self.folder / target).is_file():
            return f"{name}:{line}: The link leads to {address}, which the site does not have."
        if parts.fragment and target in self.pages and not self._has_anchor(target, parts.fragment):
            return f"{name}:{line}: The link leads to {address}, and that page has no such heading."
        return ""

    def _has_anchor(self, target: str, anchor: str) -> bool:
        # The switch to the top and the state of the navigation are no headings.
        return unquote(anchor) in self.pages[target].ids or anchor.startswith("__")

    def _style_faults(self) -> list[str]:
        return [
            f"{file.relative_to(self.folder)}: The style loads something from elsewhere."
            for file in sorted(self.folder.rglob("*.css"))
            if STYLE_THAT_LOADS.search(file.read_text(encoding="utf-8"))
        ]


def _built_name(uri: str) -> str:
    folder, name = posixpath.split(uri)
    stem = posixpath.splitext(name)[0]
    return posixpath.join(folder, "index.html" if stem in ("README", "index") else f"{stem}.html")
