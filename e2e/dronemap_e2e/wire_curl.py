"""Requests to REST as a person makes them with curl: of each kind, valid and invalid."""

from .api import Json
from .waiting import wait_for
from .wire_clients import FAR, NEAR, NEXT_PASSWORD, PASSWORD, SQUARE, Curl
from .wire_relay import RecordingRelay

NOBODY = "nosuchthing"


def look(curl: Curl) -> tuple[str, str]:
    """The drones; and all ways of not getting at them."""
    curl("GET", "/health", key=None)
    curl("GET", "/drones", key=None)
    curl("GET", "/drones", key="wrong")
    drones = curl("GET", "/drones")["drones"]
    first, second = str(drones[0]["id"]), str(drones[1]["id"])
    curl("GET", f"/drones/{first}")
    curl("GET", f"/drones/{NOBODY}")
    curl("GET", f"/{NOBODY}")
    curl("PUT", "/drones", {})
    curl("PATCH", f"/drones/{first}", {"name": "Ann's copter"})
    curl("PATCH", f"/drones/{first}", {"name": ""})
    curl("GET", "/settings")
    curl("GET", "/health/parts")
    curl("GET", "/endpoints")
    curl("POST", "/endpoints", {"url": "http://127.0.0.1"})
    return first, second


def command(curl: Curl, drone: str) -> None:
    orders = f"/drones/{drone}/commands"
    curl("POST", orders, "takeoff", kind="text/plain")
    curl("POST", orders, '{"type":')
    curl("POST", orders, {})
    curl("POST", orders, {"type": "fly"})
    curl("POST", orders, {"type": "takeOff", "altitude": -5})
    curl("POST", orders, {"type": "takeOff", "altitud": 5})
    curl("POST", orders, {"type": "takeOff", "altitude": "high"})
    curl("POST", orders, {"type": "goTo", "latitude": 95, "longitude": 8.5, "altitude": 20})
    curl("POST", orders, {"type": "goTo"} | NEAR)
    curl("POST", orders + "?wait=100", {"type": "readHome"})
    curl("POST", f"/drones/{NOBODY}/commands", {"type": "arm"})
    record = curl("POST", orders + "?wait=60", {"type": "arm"})
    curl("GET", f"/commands/{record['id']}")
    curl("GET", f"/commands/{NOBODY}")
    curl("POST", orders + "?wait=60", {"type": "takeOff", "altitude": 8})
    curl("POST", orders + "?wait=60", {"type": "goTo"} | NEAR)
    curl("POST", orders + "?wait=60", {"type": "hold"})
    curl("POST", orders + "?wait=60", {"type": "disarm"})
    curl("POST", "/commands?wait=60", {"drones": [drone, NOBODY], "command": {"type": "readHome"}})
    curl("POST", "/commands?wait=60", {"drones": [drone], "command": {"type": "land"}})
    curl("GET", orders + "?limit=2")


def _wait_until_landed(curl: Curl, relay: RecordingRelay, drone: str) -> None:
    """Nothing of it is kept."""
    before = len(relay.exchanges)
    wait_for("it is down", lambda: curl("GET", f"/drones/{drone}").get("armed") is False, 90)
    del relay.exchanges[before:]


def control(curl: Curl, relay: RecordingRelay, drone: str) -> None:
    _wait_until_landed(curl, relay, drone)
    at = f"/drones/{drone}/control"
    curl("POST", at + "/take")
    curl("POST", at + "/heartbeat", {})
    curl("POST", at + "/heartbeat", {"epoch": 1})
    curl("POST", at + "/hand-over", {"user": NOBODY})
    curl("POST", at + "/request", {"reason": "a survey"})
    curl("GET", at)
    curl("DELETE", at)


def people(curl: Curl, drone: str) -> None:
    curl("POST", "/users", {"name": "ann", "role": "operator", "password": PASSWORD})
    curl("POST", "/users", {"name": "ann", "role": "operator", "password": PASSWORD})
    curl("POST", "/users", {"name": "bob", "role": "operator", "password": "short"})
    curl("POST", "/users", {"name": "bob", "role": "captain", "password": PASSWORD})
    curl("GET", "/users")
    curl("PUT", "/users/ann/only-granted", {"onlyGranted": True})
    grant = curl("POST", "/grants", {"user": "ann", "drones": [drone], "operations": ["view", "command"]})
    curl("POST", "/grants", {"user": NOBODY, "all": True, "operations": ["view"]})
    curl("GET", "/grants")
    curl("DELETE", f"/grants/{grant.get('id', NOBODY)}")
    curl("DELETE", f"/grants/{grant.get('id', NOBODY)}")
    group = curl("POST", "/groups", {"name": "Firefighters", "members": ["ann"]})
    curl("PUT", f"/groups/{group.get('id')}", {"name": "Fire brigade", "members": []})
    curl("DELETE", f"/groups/{group.get('id')}")
    invitation = curl("POST", "/invitations", {"label": "Carol", "role": "viewer"})
    curl("GET", "/invitations")
    curl("DELETE", f"/invitations/{invitation.get('id')}")
    curl("PATCH", "/users/ann", {"role": "viewer"})
    curl("PATCH", f"/users/{NOBODY}", {"role": "viewer"})


def keys(curl: Curl, drone: str) -> None:
    viewer = curl("POST", "/access-keys", {"label": "a screen", "role": "viewer", "days": 30})
    curl("POST", "/access-keys", {"label": "", "role": "viewer"})
    curl("GET", "/access-keys")
    curl("GET", f"/drones/{drone}", key=viewer["key"])
    curl("POST", f"/drones/{drone}/commands", {"type": "arm"}, key=viewer["key"])
    curl("GET", "/users", key=viewer["key"])
    curl("DELETE", f"/access-keys/{viewer['id']}")
    curl("GET", f"/drones/{drone}", key=viewer["key"])


def missions(curl: Curl) -> None:
    items: list[Json] = [{"type": "takeOff", "altitude": 20}, {"type": "waypoint"} | NEAR]
    mission = curl("POST", "/missions", {"name": "Roofs", "items": items})
    curl("POST", "/missions", {"name": "Roofs", "items": [{"type": "waypoint", "latitude": 47}]})
    curl("GET", f"/missions/{mission['id']}")
    curl("PUT", f"/missions/{mission['id']}", {"name": "Roofs again", "items": items})
    curl("GET", "/missions")
    curl("DELETE", f"/missions/{mission['id']}")
    curl("GET", f"/missions/{mission['id']}")
    curl("POST", "/missions", '{"name":"' + "x" * 1_100_000 + '"}')


def zones(curl: Curl, drone: str) -> None:
    zone: Json = {
        "type": "Feature",
        "geometry": {"type": "Polygon", "coordinates": [SQUARE]},
        "properties": {"name": "Park", "kind": "exclusion", "ceiling": 80, "altitudeReference": "home"},
    }
    made = curl("POST", "/zones", zone)
    curl("POST", "/zones", zone | {"geometry": {"type": "Polygon", "coordinates": [SQUARE[:2]]}})
    curl("PUT", f"/zones/{made['id']}", zone | {"properties": {"name": "Lake", "kind": "exclusion"}})
    curl("GET", "/zones")
    curl("DELETE", f"/zones/{made['id']}")
    circle = {"type": "circle", "inside": True, "center": {"latitude": 47.3977, "longitude": 8.5456}}
    curl("PUT", f"/drones/{drone}/fence", {"zones": [circle | {"radius": 500}]})
    curl("PUT", f"/drones/{drone}/fence", {"zones": [circle | {"radius": -1}]})
    curl("DELETE", f"/drones/{drone}/fence")


def virtual_drones(curl: Curl) -> None:
    made = curl("POST", "/virtual-drones", {"name": "Errand", "items": [{"type": "waypoint"} | NEAR]})
    curl("POST", "/virtual-drones", {"name": ""})
    curl("GET", f"/virtual-drones/{made.get('id', NOBODY)}")
    curl("DELETE", f"/virtual-drones/{made.get('id', NOBODY)}")


def plans_and_runs(curl: Curl, drone: str) -> None:
    order: Json = {"drones": [drone], "waypoints": [NEAR, FAR], "seconds": 0.1}
    plan = curl("POST", "/plans", order)
    curl("POST", "/plans", order | {"drones": []})
    curl("POST", "/plans", order | {"drones": [NOBODY]})
    curl.until(f"/plans/{plan['id']}", "state", "finished")
    curl("POST", "/tours", {"drone": drone, "waypoints": [NEAR, FAR], "seconds": 0.1})
    run = curl("POST", "/runs", {"plan": plan["id"], "mode": "automatic", "name": "Roofs"})
    curl("POST", "/runs", {"plan": NOBODY, "mode": "automatic"})
    curl("GET", f"/runs/{run.get('id')}")
    curl("POST", f"/runs/{run.get('id')}/waypoints", {"waypoints": [{"latitude": 95}]})
    curl("POST", f"/runs/{run.get('id')}/pause")
    curl("POST", f"/runs/{run.get('id')}/stop")
    curl.until(f"/runs/{run.get('id')}", "state", "over")
    curl("GET", f"/runs/{NOBODY}")
    curl("DELETE", f"/plans/{plan['id']}")


def follows(curl: Curl, relay: RecordingRelay, drone: str) -> None:
    _wait_until_landed(curl, relay, drone)
    here = {"latitude": 47.398, "longitude": 8.5456, "drone": drone}
    follow = curl("POST", "/follows", here | {"name": "Ann", "place": {"side": "behind", "distance": 8}})
    curl("POST", "/follows", here | {"minutes": 600})
    curl("GET", f"/follows/{follow.get('id')}")
    request_headers = {
        "id": 1,
        "at": "2026-01-31T12:00:00Z",
        "latitude": 47.398,
        "longitude": 8.5456,
        "accuracy": 5,
    }
    curl(
        "POST",
        f"/follows/{follow.get('id')}/positions",
        {"sent": request_headers["at"], "positions": [request_headers]},
    )
    curl("POST", f"/follows/{follow.get('id')}/cancel")
    curl("POST", f"/follows/{follow.get('id')}/start")


def history(curl: Curl, drone: str) -> None:
    curl("GET", f"/drones/{NOBODY}/telemetry")
    curl("GET", f"/drones/{drone}/telemetry?fields=nothing")
    curl("GET", "/history")
    curl("GET", "/flights?limit=0")
    curl("GET", "/recordings?from=yesterday")
    curl("GET", f"/flights/{NOBODY}")
    curl("GET", "/organisations")
    curl("GET", "/robot-keys")


def guess(curl: Curl) -> None:
    """Until the server has had enough of it, so this comes last."""
    for _ in range(6):
        curl("POST", "/session", {"name": "ann", "password": "wrong"}, key=None)


def sign_in(curl: Curl, relay: RecordingRelay) -> None:
    curl("POST", "/session", {"name": "ann", "password": PASSWORD}, key=None)
    cookie = "Cookie: " + relay.exchanges[-1].response_headers["Set-Cookie"].split(";")[0]
    own = "X-Dronemap: 1"
    curl("GET", "/session", None, cookie, key=None)
    curl("DELETE", "/session", None, cookie, key=None)
    change = {"current": PASSWORD, "next": NEXT_PASSWORD}
    curl("POST", "/session/password", change | {"next": "short"}, cookie, own, key=None)
    curl("POST", "/session/password", change, cookie, own, key=None)
    curl("POST", "/stream-tickets", None, cookie, own, key=None)
    curl("DELETE", "/session", None, cookie, own, key=None)
    curl("GET", "/session", None, cookie, key=None)
