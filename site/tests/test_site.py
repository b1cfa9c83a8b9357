"""The site of this checkout: whole, without anything from elsewhere, and with all that the interfaces have."""

import json
from pathlib import Path

import pytest

from dronemap_site.built import BuiltSite
from dronemap_site.reference.contract import Contract
from dronemap_site.sources import ROOT


@pytest.fixture(scope="session")
def contract() -> Contract:
    return Contract.read(ROOT)


@pytest.fixture(scope="session")
def searched(site: Path) -> dict[str, str]:
    """Text and title by the address that the search leads to."""
    entries = json.loads((site / "search" / "search_index.json").read_text())["docs"]
    return {entry["location"]: f"{entry['title']} {entry['text']}" for entry in entries}


def test_no_link_is_dead_and_nothing_is_loaded_from_elsewhere(site: Path) -> None:
    built = BuiltSite(site)
    assert len(built.pages) > 100
    assert built.faults() == []


def test_front_page_is_the_readme(site: Path) -> None:
    text = (site / "index.html").read_text()
    assert "Try it without a drone" in text
    assert 'src="images/ground-station.png"' in text


def test_each_operation_has_its_place_with_who_may_and_its_names(contract: Contract, searched: dict[str, str]) -> None:
    assert len(contract.operations) == 209
    for operation in contract.operations:
        tag = operation.tag.lower().replace(" ", "-")
        text = searched[f"reference/rest/{tag}.html#{operation.id}"]
        assert f"{operation.method} {operation.path}" in text
        assert "Who may" in text
        assert f"dronemap.rest.{operation.id}(" in text
        assert "server.rest." in text
        assert ("SOAP" in text) and ("Service." in text or "WS." in text or "none:" in text or "below" in text), text


def test_each_type_message_and_operation_of_soap_has_its_place(contract: Contract, searched: dict[str, str]) -> None:
    anchors = {address.partition("#")[2] for address in searched}
    assert anchors >= set(contract.schemas)
    assert anchors >= set(contract.stream["components"]["messages"])
    for service in contract.faces.services:
        for name in service.operations:
            assert f"reference/soap/{service.name}.html#{name}" in searched


@pytest.mark.parametrize(
    ("command", "soap", "python"),
    [("takeOff", "takeoff", "drone.take_off("), ("uploadMission", "uploadMission", "drone.upload_mission(")],
)
def test_commands_are_found_by_their_name(searched: dict[str, str], command: str, soap: str, python: str) -> None:
    text = searched[f"reference/rest/commands.html#command-{command}"]
    assert f"MAVLinkControllerService.{soap}" in text
    assert python in text
    assert text.startswith(command)
