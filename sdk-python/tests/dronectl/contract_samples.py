"""Objects of the contract as a server sends them."""

from typing import Any

from fake_server import NOW

Members = dict[str, Any]
ITEMS: list[Members] = [
    {"type": "takeOff", "altitude": 10.0},
    {"type": "waypoint", "latitude": 47.1, "longitude": 8.1, "altitude": 15.0, "altitudeReference": "home"},
    {"type": "returnToLaunch"},
]
SAVED: Members = {"id": "m1", "name": "round", "by": "anna", "changedAt": NOW, "items": ITEMS}
ZONE: Members = {
    "type": "Feature",
    "id": "z1",
    "geometry": {"type": "Point", "coordinates": [8.0, 47.0]},
    "properties": {"name": "mast", "kind": "exclusion", "radius": 20.0},
}
ZONES: Members = {"type": "FeatureCollection", "features": [ZONE]}
ROAD: Members = {"at": "features[1]", "name": "road", "code": "value-not-allowed", "why": "A line is no area."}
IMPORTED: Members = {**ZONES, "leftOut": [ROAD], "leftOutTotal": 1}
USER: Members = {
    "name": "tom",
    "role": "viewer",
    "state": "active",
    "mustChangePassword": True,
    "onlyGranted": False,
}
KEY: Members = {"id": "k1", "label": "CI", "role": "viewer", "operations": ["view"], "createdAt": NOW}
RECORDING: Members = {
    "id": "r1",
    "drone": "d1",
    "droneName": "Heron-1",
    "start": NOW,
    "bytes": 7,
    "drops": 0,
    "frames": 3,
    "state": "complete",
}
RECORDINGS: Members = {
    "recordings": [RECORDING],
    "room": {"keepDays": 0, "mostBytes": 9, "usedBytes": 7, "removed": 0},
}
REPLAY: Members = {
    "id": "p1",
    "name": "r1.tlog",
    "drones": [],
    "brokenBytes": 0,
    "brokenRuns": 0,
    "goodMessages": 0,
    "progress": 0.0,
    "records": 0,
    "speed": 1.0,
    "state": "running",
}
PARAMETERS: Members = {
    "readAt": NOW,
    "total": 1,
    "parameters": [{"name": "RTL_ALT", "type": "int32", "value": 1500.0}],
}
DIFFERENCE: Members = {
    "different": [{"name": "RTL_ALT", "type": "int32", "held": 1500.0, "wanted": 1800.0}],
    "same": 3,
    "unfit": [],
    "leftOut": [{"line": 7, "code": "value-not-allowed", "why": "MNT_RATE is of component 154."}],
    "unknown": ["NEW"],
}
LOGS: Members = {"logs": [{"number": 1, "at": NOW, "sizeBytes": 3, "here": True}]}
PLAN: Members = {
    "id": "p1",
    "askedAt": NOW,
    "by": "anna",
    "drones": [{"id": "d1", "name": "Heron-1"}],
    "seconds": 5.0,
    "seed": 1,
    "state": "finished",
    "waypoints": 1,
    "result": {
        "assumed": True,
        "endsSeconds": 60.0,
        "faults": [],
        "unserved": [],
        "tours": [
            {
                "drone": "d1",
                "name": "Heron-1",
                "back": [],
                "batteryShare": 0.1,
                "departsSeconds": 0.0,
                "distance": 100.0,
                "endsSeconds": 60.0,
                "stops": [
                    {
                        "waypoint": "tower",
                        "latitude": 47.1,
                        "longitude": 8.1,
                        "altitudeAmsl": 420.0,
                        "arrivesSeconds": 10.0,
                        "beginsSeconds": 10.0,
                        "leavesSeconds": 10.0,
                        "via": [],
                        "wattHours": 1.0,
                    }
                ],
                "wattHours": 2.0,
            }
        ],
    },
}
RUN: Members = {
    "id": "r1",
    "name": "Tour",
    "barriers": [],
    "beganAt": NOW,
    "counts": {"cancelled": 0, "doubles": 0, "replans": 0, "unserved": 0, "visited": 1, "waypoints": 1},
    "drones": [{"id": "d1", "name": "Heron-1", "next": [], "since": NOW, "stage": "landed", "visited": 1}],
    "end": "The run is over.",
    "endedAt": NOW,
    "explanations": [{"at": NOW, "moved": [], "number": 1, "trigger": "start", "words": "One drone sets off."}],
    "journal": 1,
    "mode": "automatic",
    "onCloudLoss": "continue",
    "owner": "anna",
    "state": "over",
    "waypoints": [],
}
FOLLOW: Members = {
    "id": "f1",
    "name": "Walk",
    "beganAt": NOW,
    "drone": "d1",
    "droneName": "Heron-1",
    "others": [],
    "owner": "anna",
    "patience": 60,
    "place": {"distance": 8.0, "height": 15.0, "side": "behind"},
    "since": NOW,
    "state": "allocated",
    "told": [{"at": NOW, "words": "Heron-1 was chosen."}],
}
DISPATCH: Members = {
    "id": "s1",
    "owner": "ann",
    "beganAt": NOW,
    "endedAt": None,
    "state": "chosen",
    "since": NOW,
    "latitude": -33.5,
    "longitude": -70.5,
    "height": 30.0,
    "note": None,
    "end": None,
    "drone": "d1",
    "droneName": "Heron-1",
    "told": [{"at": NOW, "words": "Heron-1 was chosen."}],
    "others": [],
    "now": None,
}
RECOVERY: Members = {
    "id": "c1",
    "owner": "ann",
    "beganAt": NOW,
    "endedAt": None,
    "manner": "return",
    "state": "stopping",
    "since": NOW,
    "lowest": 20.0,
    "ceiling": 120.0,
    "drones": [
        {
            "drone": "d1",
            "droneName": "Heron-1",
            "step": "aloft",
            "outcome": None,
            "note": None,
            "waitsFor": [],
            "plan": None,
        }
    ],
    "told": [],
    "end": None,
}
RECOVERY_PREVIEW: Members = {
    "manner": "return",
    "lowest": 20.0,
    "ceiling": 120.0,
    "seconds": 90.0,
    "drones": [
        {
            "drone": "d1",
            "droneName": "Heron-1",
            "fromLatitude": 47.1,
            "fromLongitude": 8.1,
            "plan": {"latitude": 47.0, "longitude": 8.0, "height": 30.0, "startSeconds": 0.0, "downSeconds": 90.0},
            "waitsFor": ["Heron-2"],
        }
    ],
    "leftOut": [{"drone": "d2", "droneName": "Kestrel", "code": "not-airborne", "why": "It is not in the air."}],
}
RECEIPT: Members = {"at": NOW, "follow": "f1", "known": 0, "taken": 1, "upTo": 1}
VIRTUAL: Members = {
    "id": "v1",
    "name": "survey",
    "actions": {},
    "items": ITEMS,
    "needs": {},
    "owner": "anna",
    "run": {
        "changedAt": NOW,
        "flown": 1,
        "onCloudLoss": "continue",
        "sentence": "Done: all waypoints are flown.",
        "state": "done",
        "total": 1,
        "unfit": [],
    },
}
EVENTS: Members = {
    "drone": "d1",
    "from": NOW,
    "until": NOW,
    "more": False,
    "events": [{"at": NOW, "kind": "armed", "text": "Armed."}],
}
