"""Writes the reference of REST, the stream and SOAP from their pinned descriptions."""

from ..navigation import Nav
from ..sources import Sources
from . import overview, rest_pages, soap_pages, stream_pages, type_pages
from .contract import Contract


def rank(uri: str) -> float:
    """
    How much a page counts in the search: less than one that answers questions, and the page of an operation more than a
    list or a type. A word in a title counts a thousand times one in the text.
    """
    return 0.1 if uri.startswith("reference/rest/") else 0.02


def pages(sources: Sources) -> tuple[dict[str, str], Nav]:
    """Texts by the address of their page, and how they are ordered."""
    contract = Contract.read(sources.root)
    texts: dict[str, str] = {}
    nav: Nav = []
    for writer in (overview, rest_pages, stream_pages, soap_pages, type_pages):
        written, entries = writer.pages(contract)
        texts |= written
        nav += entries
    return texts, nav
