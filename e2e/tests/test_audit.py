"""Audit records of calls through every face, refused ones too; search, export and receipts."""

import csv
import io
import json

import requests
from websockets.sync.client import connect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.server import Server
from dronemap_e2e.soap import soap
from dronemap_e2e.waiting import wait_for


def test_every_interface_leaves_one_audit_record_covered_by_receipt(
    server: Server, api: Api, copter: Json
) -> None:
    """End to end because zeep and a WebSocket library call as others do, and PostgreSQL keeps the chain."""
    drone = copter["id"]
    operator = api.new_key("a surveyor's program", "operator")
    viewer = api.new_key("a looker's program", "viewer")
    refused = Api(server.address, viewer).call("POST", f"/drones/{drone}/commands", {"type": "arm"})
    assert refused.status_code == 403
    assert Api(server.address, operator).do(drone, type="readHome")
    assert soap(server, operator).takePicture(droneId=drone).outcome.result
    _send(server, operator, {"type": "command", "drone": drone, "command": {"type": "readParameters"}})
    given_back = Api(server.address, operator).call("DELETE", f"/drones/{drone}/control")
    assert given_back.status_code in (200, 409), given_back.text

    records = wait_for("all have ended", lambda: _ended(api, drone), 60)

    recorded = [(one["face"], one["operation"], one["outcome"] == "refused") for one in reversed(records)]
    assert recorded[:4] == [
        ("rest", "POST /api/v1/drones/{id}/commands", True),
        ("rest", "readHome", False),
        ("soap", "takePicture", False),
        ("stream", "readParameters", False),
    ]
    assert all(one["by"] == "admin" and one["accessKey"] for one in records if one["face"] != "rule")
    assert all(one["latencyMillis"] is not None for one in records if one["command"])
    _check_export(api, drone, len(records))
    _check_receipt(api)
    everything = api.text("/audit/file?form=jsonl")
    assert operator not in everything
    assert viewer not in everything
    assert server.local_key() not in everything


def _send(server: Server, key: str, message: Json) -> None:
    headers = {"Authorization": f"Bearer {key}"}
    with connect(server.stream_address, additional_headers=headers) as stream:
        stream.send(json.dumps(message | {"requestId": "one"}))
        while True:
            answer = json.loads(stream.recv(timeout=30))
            if answer.get("requestId") == "one":
                assert answer["type"] == "commandAccepted", answer
                return


def _ended(api: Api, drone: str) -> list[Json] | None:
    records: list[Json] = api.get(f"/audit?drone={drone}&limit=200")["records"]
    done = len(records) >= 5 and all(one["outcome"] != "underWay" for one in records)
    return records if done else None


def _check_export(api: Api, drone: str, count: int) -> None:
    rows = list(csv.DictReader(io.StringIO(api.text(f"/audit/file?drone={drone}"))))
    assert len(rows) >= count
    assert {row["drone"] for row in rows} == {drone}


def _check_receipt(api: Api) -> None:
    receipt = api.get("/audit/receipt")
    assert api.call("POST", "/audit/verification", receipt).json()["sound"] is True
    forged: requests.Response = api.call(
        "POST", "/audit/verification", receipt | {"sequence": receipt["sequence"] - 1}
    )
    assert forged.json()["sound"] is False
