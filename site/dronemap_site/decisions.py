"""The page that lists the decisions, which have a folder but no document of its own."""

import posixpath

from .navigation import Nav
from .sources import Sources

URI = "adr/index.md"
NAV: Nav = [URI]


def pages(sources: Sources) -> dict[str, str]:
    lines = [
        "# Decisions",
        "",
        "What was decided, why, and what follows from it; a later one may replace an earlier.",
        "",
    ]
    for path, uri in sources.pages.items():
        if path.startswith("docs/adr/"):
            title = sources.text(path).split("\n", 1)[0].removeprefix("# ")
            lines.append(f"- [{title}]({posixpath.basename(uri)})")
    return {URI: "\n".join(lines) + "\n"}
