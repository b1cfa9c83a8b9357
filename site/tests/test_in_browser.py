"""The site as a reader has it: in a browser, wide and narrow, with its search, and nothing from elsewhere."""

import functools
import os
import shutil
import threading
from collections.abc import Iterator
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect, sync_playwright

PHONE = {"width": 390, "height": 844}
PATIENCE_MILLISECONDS = 30_000


class Quiet(SimpleHTTPRequestHandler):
    def log_message(self, format: str, *args: object) -> None:
        """Requests of a test are no news."""


@pytest.fixture(scope="module")
def address(site: Path) -> Iterator[str]:
    server = ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=str(site)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_port}"
    server.shutdown()
    server.server_close()


@pytest.fixture
def page(address: str) -> Iterator[Page]:
    """Fails when anything is asked of another place than the site, or an error is told in the console."""
    chromium = os.environ.get("DRONEMAP_CHROMIUM") or shutil.which("chromium")
    assert chromium, "chromium is missing: ./dronemap test installs it"
    expect.set_options(timeout=PATIENCE_MILLISECONDS)
    wrong: list[str] = []
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox", "--disable-gpu"])
        opened = browser.new_page()
        opened.on("request", lambda asked: wrong.append(asked.url) if not asked.url.startswith(address) else None)
        opened.on("console", lambda told: wrong.append(told.text) if told.type == "error" else None)
        yield opened
        browser.close()
    assert wrong == []


@pytest.mark.parametrize(
    ("words", "place"),
    [
        ("takeoff", "reference/rest/commands.html#command-takeOff"),
        ("uploadMission", "reference/rest/commands.html#command-uploadMission"),
        ("listDrones", "reference/rest/drones.html#listDrones"),
    ],
)
def test_search_leads_to_the_reference_first(page: Page, address: str, words: str, place: str) -> None:
    page.goto(f"{address}/index.html")
    page.get_by_role("textbox", name="Search").fill(words)
    first = page.locator(".md-search-result__item").first.locator("a[href*='#']").first
    expect(first).to_be_visible()
    path, _, anchor = place.partition("#")
    found = (first.get_attribute("href") or "").replace(address, "").lstrip("/")
    assert found.partition("?")[0] == path
    assert found.endswith(f"#{anchor}")


@pytest.mark.parametrize(
    ("words", "page_found"),
    [
        ("which port telemetry radio", "jobs/connect-a-drone.html"),
        ("two vehicles with the same system id", "jobs/connect-a-drone.html"),
        ("out of contact", "jobs/see-the-fleet.html"),
        ("command timeout", "jobs/fly-a-drone.html"),
        ("python take off", "guides/python.html"),
        ("robot laser scan", "jobs/connect-a-robot.html"),
        ("first administrator", "jobs/users-and-roles.html"),
        ("disable user while flying", "jobs/users-and-roles.html"),
        ("schedule", "what-it-is.html"),
        ("backup database", "operations/backup.html"),
        ("wsdl", "guides/soap.html"),
        ("send command twice", "guides/rest.html"),
        ("live feed positions", "guides/stream.html"),
        ("raw mavlink", "what-it-is.html"),
        ("one drone goes down", "jobs/mission-runs.html"),
        ("battery reserve", "what-it-is.html"),
        ("follow me", "follow.html"),
        ("plugin", "what-it-is.html"),
        ("no-fly zone in flight", "jobs/zones.html"),
        ("encrypt and sign", "jobs/secure-links.html"),
        ("photogrammetry", "what-it-is.html"),
    ],
)
def test_words_of_people_lead_to_the_page_that_answers(page: Page, address: str, words: str, page_found: str) -> None:
    page.goto(f"{address}/index.html")
    page.get_by_role("textbox", name="Search").fill(words)
    found = page.locator(".md-search-result__item")
    expect(found.first).to_be_visible()
    links = [item.locator("a").first.get_attribute("href") or "" for item in found.all()[:3]]
    pages = [link.replace(address, "").lstrip("/").partition("?")[0].partition("#")[0] for link in links]
    assert page_found in pages


@pytest.mark.parametrize(("word", "first"), [("hadoop", "archive.html"), ("unsigned", "jobs/secure-links.html")])
def test_text_of_a_page_that_answers_comes_before_a_title_of_a_decision(
    page: Page, address: str, word: str, first: str
) -> None:
    page.goto(f"{address}/index.html")
    page.get_by_role("textbox", name="Search").fill(word)
    found = page.locator(".md-search-result__item")
    expect(found.first).to_be_visible()
    link = found.first.locator("a").first.get_attribute("href") or ""
    assert link.replace(address, "").lstrip("/").partition("?")[0].partition("#")[0] == first


@pytest.mark.parametrize("path", ["index.html", "reference/rest/commands.html", "security.html"])
def test_page_fits_a_phone(page: Page, address: str, path: str) -> None:
    page.set_viewport_size({"width": PHONE["width"], "height": PHONE["height"]})
    page.goto(f"{address}/{path}")
    expect(page.get_by_role("heading", level=1)).to_be_visible()
    assert page.evaluate("document.documentElement.scrollWidth") <= PHONE["width"]


def test_dark_readers_get_a_dark_page(page: Page, address: str) -> None:
    page.emulate_media(color_scheme="dark")
    page.goto(f"{address}/index.html")
    expect(page.locator("body")).to_have_attribute("data-md-color-scheme", "slate")
