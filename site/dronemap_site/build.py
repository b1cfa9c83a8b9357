"""The steps of a build that MkDocs calls: pages, their links, their order, and a verdict on what came of it."""

from pathlib import Path
from typing import Any

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File, Files

from . import decisions, links, reference
from .built import BuiltSite
from .names import breakable
from .navigation import navigation
from .sources import Sources

ASSETS = Path(__file__).parent / "assets"


class Build:
    """What one build knows from its first step to its last."""

    def __init__(self) -> None:
        self.sources = Sources.of()
        self.linked = {path: links.rewritten(path, self.sources) for path in self.sources.pages}

    def files(self, config: MkDocsConfig, files: Files) -> None:
        faults = [fault for linked in self.linked.values() for fault in linked.faults]
        written, entries = reference.pages(self.sources)
        texts = {uri: ranked(text, reference.rank(uri)) for uri, text in written.items()}
        texts |= {
            uri: ranked(text, self.sources.rank(f"docs/{uri}")) for uri, text in decisions.pages(self.sources).items()
        }
        for path, uri in self.sources.pages.items():
            texts[uri] = ranked(self.linked[path].text, self.sources.rank(path))
        for uri, text in texts.items():
            found = files.get_file_from_path(uri)
            if found:
                files.remove(found)
            files.append(File.generated(config, uri, content=text))
        for path in sorted({path for linked in self.linked.values() for path in linked.files}):
            files.append(File.generated(config, path, abs_src_path=str(self.sources.root / path)))
        for asset in sorted(ASSETS.iterdir()):
            files.append(File.generated(config, asset.name, abs_src_path=str(asset)))
        nav, missing = navigation(self.sources, {"adr": decisions.NAV, "reference": entries})
        config.nav = nav
        fail_on(faults + missing)

    def judge(self, folder: Path) -> None:
        site = BuiltSite(folder)
        anchors = [link for linked in self.linked.values() for link in linked.anchors]
        fail_on(site.dead_anchors(anchors) or site.faults())


def ranked(text: str, rank: float) -> str:
    """With what the search needs to know of a page, in the form that MkDocs reads."""
    return f"---\nsearch:\n  boost: {rank:g}\n---\n\n{text}"


_build: Build | None = None


def fail_on(faults: list[str]) -> None:
    if faults:
        raise PluginError("\n".join(["The site has faults:", *faults]))


def on_files(files: Files, *, config: MkDocsConfig, **_: Any) -> Files:
    global _build
    _build = Build()
    _build.files(config, files)
    return files


def on_post_page(output: str, **_: Any) -> str:
    """Not before: the search is to know the names as they are."""
    return breakable(output)


def on_post_build(*, config: MkDocsConfig, **_: Any) -> None:
    assert _build is not None
    _build.judge(Path(config.site_dir))
