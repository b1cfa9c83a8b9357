"""PHP's own SoapClient reads each WSDL, and calls an operation of each service."""

import json
import subprocess

import pytest

from dronemap_e2e.api import Api
from dronemap_e2e.server import ROOT, Server

SCRIPT = ROOT / "e2e" / "dronemap_e2e" / "every_service.php"
CALLS = {
    "AccountService": "listUsers",
    "ApplicationWS": "getFollowsList",
    "FleetService": "listGroups",
    "FollowerService": "getFollowsList",
    "MAVLinkControllerService": "getDronesList",
    "PlanningService": "listPlans",
    "RecordService": "listRecordings",
    "ServerService": "getHealth",
    "VirtualDroneService": "listVirtualDrones",
}


@pytest.mark.parametrize("version", ["1.1", "1.2"])
def test_php_soap_client_calls_each_service(server: Server, api: Api, version: str) -> None:
    """End to end because PHP makes calls, and reads answers and faults, by the services' own WSDLs."""
    pairs = [f"{service}={operation}" for service, operation in CALLS.items()]
    output = subprocess.run(
        ["php", str(SCRIPT), server.address, server.local_key(), version, *pairs],
        capture_output=True,
        text=True,
        check=True,
        timeout=60,
    ).stdout
    results = [json.loads(line) for line in output.splitlines()]
    *answers, everything, nothing, unknown = results
    assert [one["service"] for one in answers if "answer" in one] == list(CALLS), answers
    assert everything["answer"]["return"].get("drones") is None
    refused = api.call("POST", "/access-keys", {"label": "of no drone", "drones": []})
    assert nothing["fault"] == refused.json()["detail"]
    assert unknown["fault"] == "There is no drone nosuchdrone."
