"""Links of documents lead to pages of the site, to files that it has, or are plain text; anything else is a fault."""

import pytest

from dronemap_site.links import rewritten
from dronemap_site.sources import BESIDES, ROOT

from .conftest import Checkout

FILES = {
    "docs/stream.md": "# Stream\n",
    "docs/images/map.png": "",
    "docs/how-to-add/README.md": "# How\n",
    "docs/adr/0001-lanes.md": "# 1. Lanes\n",
    "sdk-python/README.md": "# Python\n",
    "sdk-python/examples/goto.py": "",
}


@pytest.mark.parametrize(
    ("path", "text", "expected"),
    [
        ("README.md", "[s](docs/stream.md#rate)", "[s](stream.md#rate)"),
        ("README.md", "![m](docs/images/map.png)", "![m](images/map.png)"),
        ("README.md", "[d](docs/adr/)", "[d](adr/index.md)"),
        ("README.md", "[h](docs/how-to-add/)", "[h](how-to-add/README.md)"),
        ("README.md", "[of `code`](docs/stream.md)", "[of `code`](stream.md)"),
        ("README.md", "[over two\nlines](docs/stream.md)", "[over two\nlines](stream.md)"),
        ("README.md", "[x](https://example.org/a_(b))", "[x](https://example.org/a_(b))"),
        ("README.md", "[the modules](sdk-python/examples)", "the modules"),
        ("README.md", "`[s](docs/nowhere.md)`", "`[s](docs/nowhere.md)`"),
        ("README.md", "```text\n[s](docs/nowhere.md)\n```", "```text\n[s](docs/nowhere.md)\n```"),
        ("docs/page.md", "[front](../README.md)", "[front](index.md)"),
        ("docs/page.md", "[p](../sdk-python/README.md)", "[p](sdk-python/README.md)"),
        ("docs/page.md", "[here](#below)", "[here](#below)"),
        ("docs/jobs/page.md", "[s](../stream.md)", "[s](../stream.md)"),
        ("sdk-python/dronectl.md", "[s](../docs/stream.md)", "[s](../stream.md)"),
        ("sdk-python/dronectl.md", "[goto](examples/goto.py)", "[goto](examples/goto.py)"),
        ("README.md", "a\n<!-- not run: a reason is here -->\nb", "a\n\nb"),
    ],
)
def test_link_leads_where_the_page_is(checkout: Checkout, path: str, text: str, expected: str) -> None:
    linked = rewritten(path, checkout(FILES | {path: text}))
    assert linked.text == expected
    assert linked.faults == []


def test_file_that_a_page_names_comes_along(checkout: Checkout) -> None:
    sources = checkout(FILES | {"sdk-python/dronectl.md": "[goto](examples/goto.py)"})
    assert rewritten("sdk-python/dronectl.md", sources).files == {"sdk-python/examples/goto.py"}


def test_dead_link_is_told_with_its_line(checkout: Checkout) -> None:
    text = "# Page\n\n```text\ncode\n```\n\nSee [this](gone.md),\n[that](../../outside.md) and [more](../notes.md).\n"
    linked = rewritten("docs/page.md", checkout({"docs/page.md": text, "notes.md": "# Notes\n"}))
    assert linked.faults == [
        "docs/page.md:7: The link leads to docs/gone.md, which is not there.",
        "docs/page.md:8: The link leads to ../outside.md, which is not there.",
        "docs/page.md:8: The link leads to notes.md, which is no page of the site;"
        " name it in site/dronemap_site/sources.py.",
    ]


def test_anchor_is_looked_up_later(checkout: Checkout) -> None:
    linked = rewritten("docs/page.md", checkout(FILES | {"docs/page.md": "\n[s](stream.md#rate) [h](#page)\n"}))
    assert [(str(link.place), link.page, link.anchor) for link in linked.anchors] == [
        ("docs/page.md:2", "stream.md", "rate"),
        ("docs/page.md:2", "page.md", "page"),
    ]


def test_pages_outside_docs_are_there() -> None:
    """Those of parts that are not in every checkout yet may be missing."""
    missing = [path for path in BESIDES if not (ROOT / path).exists()]
    assert all(not (ROOT / path).parent.exists() for path in missing), missing
