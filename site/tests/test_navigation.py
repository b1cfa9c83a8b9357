"""Pages come into the navigation by their folder; one that is nowhere in it is a fault."""

from dronemap_site.navigation import navigation

from .conftest import Checkout


def test_new_page_of_a_folder_comes_after_those_with_a_place(checkout: Checkout) -> None:
    guides = {f"docs/guides/{name}.md": "# Guide\n" for name in ("another", "rest", "python")}
    nav, faults = navigation(checkout(guides), {})
    assert nav == [
        {"Start": [{"Dronemap": "index.md"}]},
        {"Languages": ["guides/python.md", "guides/rest.md", "guides/another.md"]},
    ]
    assert faults == []


def test_page_with_a_place_of_its_own_does_not_come_again_with_its_folder(checkout: Checkout) -> None:
    jobs = {f"docs/jobs/{name}.md": "# Job\n" for name in ("first-flight", "another")}
    nav, faults = navigation(checkout(jobs), {})
    assert nav[1] == {"Jobs": [{"Fly": ["jobs/first-flight.md"]}, "jobs/another.md"]}
    assert faults == []


def test_page_in_no_section_is_a_fault(checkout: Checkout) -> None:
    _, faults = navigation(checkout({"docs/lost.md": "# Lost\n"}), {})
    assert faults == [
        "docs/lost.md:1: The page is in no section; name it or its folder in site/dronemap_site/navigation.py."
    ]


def test_pages_without_document_stand_where_the_sections_say(checkout: Checkout) -> None:
    nav, _ = navigation(checkout({"docs/times.md": "# Times\n"}), {"reference": [{"REST": ["reference/a.md"]}]})
    assert nav[1] == {"Reference": [{"REST": ["reference/a.md"]}, "times.md"]}
