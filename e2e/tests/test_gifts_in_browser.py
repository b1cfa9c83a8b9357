"""A drone is given to another organisation and taken back on the page; at desk and phone."""

import os
import secrets
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, ViewportSize, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.screen import DESK, PHONE, also_at, open_page
from dronemap_e2e.server import Server
from dronemap_e2e.station import InputMethod, Pointer, Station, Touch

PATIENCE = 30_000


def picture(page: Page, name: str) -> None:
    """Kept where DRONEMAP_E2E_SCREENSHOTS says, for people to look at."""
    folder = os.environ.get("DRONEMAP_E2E_SCREENSHOTS")
    if folder:
        Path(folder).mkdir(parents=True, exist_ok=True)
        page.screenshot(path=Path(folder) / f"{name}.png", full_page=True)


@pytest.mark.parametrize(
    ("viewport", "input_method"), [(DESK, Pointer()), (PHONE, Touch())], ids=["desk", "phone"]
)
def test_drone_gift_and_its_return(
    server: Server,
    api: Api,
    copter: Json,
    browser: Browser,
    viewport: ViewportSize,
    input_method: InputMethod,
) -> None:
    """End to end because the list of what was given follows what the page itself does."""
    chief, password, name = f"chief-{secrets.token_hex(4)}", secrets.token_hex(10), secrets.token_hex(4)
    answer = api.call("POST", "/users", {"name": chief, "password": password, "role": "administrator"})
    assert answer.status_code == 201, answer.text
    answer = api.call("POST", "/organisations", {"name": f"Rescue {name}"})
    assert answer.status_code == 201, answer.text
    station = Station(open_page(browser, viewport, touch=isinstance(input_method, Touch)), input_method)
    page = station.page
    station.sign_in(server.address, chief, password, secrets.token_hex(10))
    input_method.press(page, page.get_by_role("button", name=f"Account of {chief}"))
    station.press("Administration")

    # The card opens by itself, as there is one.
    card = page.get_by_role("region", name="Organisations")
    expect(card.get_by_text(f"Rescue {name}", exact=True).first).to_be_visible(timeout=PATIENCE)

    card.get_by_label("Give away a drone").select_option(label=copter["name"])
    card.get_by_label("To whom").select_option(label=f"Rescue {name}")
    card.get_by_label("Show them what it did before").check()
    give = card.get_by_role("button", name="Give it away")
    also_at(page, PHONE if viewport == DESK else DESK, give)
    picture(page, f"gifts-1-{viewport['width']}")
    input_method.press(page, give)
    given = card.get_by_role("list", name=f"Drones given to Rescue {name}")
    expect(given).to_contain_text(copter["name"], timeout=PATIENCE)
    expect(given).to_contain_text("with what it did before")
    expect(card.get_by_text("without names of people, notes, and who sent what")).to_be_visible()
    assert copter["id"] not in [drone["id"] for drone in api.drones()]
    picture(page, f"gifts-2-{viewport['width']}")

    input_method.hold(page, given.get_by_role("button", name="Reclaim"))
    expect(given).to_have_count(0, timeout=PATIENCE)
    assert copter["id"] in [drone["id"] for drone in api.drones()]
    page.context.close()
