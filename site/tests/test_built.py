"""The judge of a built site finds links that lead nowhere and whatever is loaded from elsewhere."""

from pathlib import Path

import pytest

from dronemap_site.built import BuiltSite
from dronemap_site.links import AnchorLink, Place


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "how").mkdir()
    (tmp_path / "how" / "index.html").write_text('<h2 id="to">To</h2><a href="../index.html#there">front</a>')
    (tmp_path / "index.html").write_text('<h1 id="there">There</h1>')
    return tmp_path


@pytest.mark.parametrize(
    ("html", "sentence"),
    [
        ('<a href="how/">how</a><a href="how/index.html#to">to</a><a href="https://example.org">far</a>', ""),
        ('<a href="gone.html">gone</a>', "The link leads to gone.html, which the site does not have."),
        ('<a href="#nowhere">gone</a>', "The link leads to #nowhere, and that page has no such heading."),
        ('<a href="how/#fro">fro</a>', "The link leads to how/#fro, and that page has no such heading."),
        ('<img src="no.png">', "The link leads to no.png, which the site does not have."),
        ('<script src="https://x.example/a.js"></script>', "The page loads https://x.example/a.js from elsewhere."),
        ('<link rel="stylesheet" href="//x.example/a.css">', "The page loads //x.example/a.css from elsewhere."),
        ('<link rel="preconnect" href="https://x.example">', "The page loads https://x.example from elsewhere."),
    ],
)
def test_fault_is_told_with_page_and_line(folder: Path, html: str, sentence: str) -> None:
    (folder / "page.html").write_text(f"<p>\n{html}")
    assert BuiltSite(folder).faults() == ([f"page.html:2: {sentence}"] if sentence else [])


@pytest.mark.parametrize("style", ['@import "x.css";', "a { background: url(https://x.example/a.png) }"])
def test_style_that_loads_is_a_fault(folder: Path, style: str) -> None:
    (folder / "a.css").write_text(style)
    assert BuiltSite(folder).faults() == ["a.css: The style loads something from elsewhere."]


def test_dead_anchor_is_told_where_its_document_has_it(folder: Path) -> None:
    links = [
        AnchorLink(Place("docs/a.md", 7), "how/README.md", "fro"),
        AnchorLink(Place("docs/a.md", 8), "index.md", "there"),
    ]
    assert BuiltSite(folder).dead_anchors(links) == ["docs/a.md:7: The page how/README.md has no heading #fro."]
