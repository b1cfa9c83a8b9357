"""Simulated robots on the page: drawn, sent where one points, driven and flown by keys and sticks."""

import math
import os
import secrets
import subprocess
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Locator, Page, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.screen import open_page
from dronemap_e2e.server import QUICK, Server
from dronemap_e2e.simulator import SIMULATOR_JAR
from dronemap_e2e.station import Pointer, Station
from dronemap_e2e.waiting import wait_for

SYSTEM_ID, FLYER_ID = 3107, 3108
# The simulator's room: 8 m by 6 m around its origin, on a canvas of 600 pixels.
PIXELS_A_METER = 75
LEFT, BOTTOM = -4, -3
CANVAS = 600
QUIRKS = "repeats-twist,status-is-heartbeat,counts-each-kind,broken-lines"


@dataclass(frozen=True)
class Colour:
    red: int
    green: int
    blue: int

    @property
    def dark(self) -> bool:
        return max(self.red, self.green, self.blue) < 40

    @property
    def bright(self) -> bool:
        return min(self.red, self.green, self.blue) > 220


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    opened = open_page(browser)
    yield opened
    opened.context.close()


@pytest.fixture
def station(server: Server, api: Api, page: Page) -> Station:
    """An operator's."""
    name, password = f"pilot-{secrets.token_hex(4)}", secrets.token_hex(10)
    made = api.call("POST", "/users", {"name": name, "password": password, "role": "operator"})
    assert made.status_code == 201, made.text
    opened = Station(page, Pointer())
    opened.sign_in(server.address, name, password, secrets.token_hex(10))
    return opened


@contextmanager
def simulated(server: Server, log: Path, *options: str) -> Iterator[None]:
    command = ["java", "-Xmx256m", QUICK, "-jar", str(SIMULATOR_JAR), "--roslink"]
    address = f"udp://127.0.0.1:{server.robot_udp_port}"
    with log.open("wb") as output:
        process = subprocess.Popen(
            [*command, "--connect", address, *options], stdout=output, stderr=subprocess.STDOUT
        )
    try:
        yield
    finally:
        process.kill()
        process.wait()


def listed(api: Api, system_id: int, is_ready: Callable[[Json], object]) -> Json:
    return wait_for(
        f"robot {system_id} is listed and ready",
        lambda: next((d for d in api.drones() if d["link"]["systemId"] == system_id and is_ready(d)), None),
        60,
    )


@pytest.fixture
def robot(server: Server, api: Api, tmp_path: Path) -> Iterator[Json]:
    """With a key that the server issued, as a drone that it made for it."""
    answer = api.call("POST", "/robot-keys", {"label": "Hall robot", "systemId": SYSTEM_ID})
    assert answer.status_code == 201, answer.text
    options = ("--sysid", str(SYSTEM_ID), "--key", answer.json()["key"], "--quirks", QUIRKS)
    with simulated(server, tmp_path / "robot.log", *options):
        yield listed(api, SYSTEM_ID, lambda d: (d["sensed"] or {}).get("scan"))


def map_colour(page: Page, x: float, y: float) -> Colour:
    """The pixel of the drawn map at a place of the room."""
    column = (x - LEFT) * PIXELS_A_METER
    row = CANVAS - (y - BOTTOM) * PIXELS_A_METER
    red, green, blue, _ = page.locator("canvas[aria-label^='Map of']").evaluate(
        "(canvas, [x, y]) => [...canvas.getContext('2d').getImageData(x, y, 1, 1).data]", [column, row]
    )
    return Colour(red, green, blue)


def picture_colour(image: Locator, x: int, y: int) -> Colour:
    """A pixel of the picture as the page shows it."""
    red, green, blue, _ = image.evaluate(
        """async (image, [x, y]) => {
            // A newer one may just be coming, and then there is nothing to draw.
            while (!(await image.decode().then(() => true, () => false))) {}
            const canvas = document.createElement('canvas');
            [canvas.width, canvas.height] = [image.naturalWidth, image.naturalHeight];
            const context = canvas.getContext('2d');
            context.drawImage(image, 0, 0);
            return [...context.getImageData(x, y, 1, 1).data];
        }""",
        [x, y],
    )
    return Colour(red, green, blue)


def is_near(local: Json, x: float, y: float) -> bool:
    return bool(abs(local["x"] - x) < 0.4 and abs(local["y"] - y) < 0.4)


def picture(page: Page, name: str) -> None:
    """Kept where DRONEMAP_E2E_SCREENSHOTS says, for people to look at."""
    folder = os.environ.get("DRONEMAP_E2E_SCREENSHOTS")
    if folder:
        Path(folder).mkdir(parents=True, exist_ok=True)
        page.screenshot(path=Path(folder) / f"{name}.png")


def speed(api: Api, drone: str) -> float:
    return float((api.drone(drone)["motion"] or {}).get("groundSpeed") or 0)


def succeeded(api: Api, drone: str, kind: str) -> bool:
    """True when a command of that kind has succeeded."""
    commands = api.get(f"/drones/{drone}/commands")["commands"]
    return any(c["type"] == kind and c["outcome"] and c["outcome"]["result"] == "succeeded" for c in commands)


def test_robot_map_driving_and_goal_on_page(api: Api, robot: Json, page: Page, station: Station) -> None:
    """End to end because it is about what a page draws, and keys pressed on it."""
    station.choose(robot["name"])
    section = page.get_by_role("region", name="Own map")
    section.get_by_role("button", name="Read its map").click()
    expect(section).to_contain_text("8.0 m wide")

    wait_for("the box in the room is drawn", lambda: map_colour(page, 2, 1).dark)
    assert map_colour(page, 0, 2.95).dark, "the upper wall"
    assert map_colour(page, 0, -1.5).bright
    assert map_colour(page, 2, -1).bright, "no box where there is none, so y is upwards"
    # The wall below it: what is met is drawn in red, on the black of the wall.
    wait_for("what the range finder meets is drawn", lambda: map_colour(page, -2, -2.81).red > 120)
    assert map_colour(page, -2, -2.81).green < 100
    here = map_colour(page, -2, -1)
    assert here.blue > here.red + 60, "the robot itself"
    camera = section.get_by_role("img", name="What the camera")
    wait_for("its picture is shown", lambda: camera.evaluate("image => image.naturalWidth") == 160)
    expect(camera).to_be_visible()
    # From where it stands, looking along x: the far wall ahead under the sky, the box, nearer, at its left.
    assert picture_colour(camera, 80, 10) == Colour(0x30, 0x70, 0xC0), "the sky"
    assert picture_colour(camera, 80, 110) == Colour(0x70, 0x50, 0x30), "the ground"
    wall, corner = picture_colour(camera, 80, 60), picture_colour(camera, 4, 60)
    assert wall.red == wall.green == wall.blue > 60, "the far wall"
    assert corner.red == corner.green == corner.blue > wall.red + 10, "the box is nearer, so brighter"
    assert picture_colour(camera, 4, 52) == corner, "and taller"
    assert picture_colour(camera, 80, 52) == picture_colour(camera, 80, 10)

    canvas = section.locator("canvas")
    box = canvas.bounding_box()
    assert box
    scale = box["width"] / 8
    canvas.click(position={"x": 3 * scale, "y": box["height"] - 1 * box["height"] / 8})
    section.get_by_role("button", name="Go there").click()
    wait_for("it has gone there", lambda: is_near(api.drone(robot["id"])["local"], -1, -2), 60)
    wait_for("the way is said to be done", lambda: succeeded(api, robot["id"], "goToLocal"), 60)
    expect(page.get_by_text("m on its own map: succeeded"), "a long line").to_be_visible()
    assert section.evaluate("section => section.getBoundingClientRect().right <= innerWidth"), "all is seen"

    steer = page.get_by_role("region", name="Steer", exact=True)
    state = steer.get_by_role("status")
    yaw = api.drone(robot["id"])["local"]["yaw"]
    steer.get_by_role("application").focus()
    page.keyboard.down("a")
    expect(state).to_contain_text("Steering: turning left")
    wait_for("it turns to its left", lambda: degrees_turned(yaw, api.drone(robot["id"])["local"]["yaw"]) > 20)
    expect(canvas, "and one sees it").to_be_in_viewport(ratio=0.9)
    picture(page, "robot-steered-wide")
    page.keyboard.up("a")
    expect(state).to_have_text("Not steering")

    before = api.drone(robot["id"])["local"]
    stick = steer.locator("[data-stick=Drive]")
    stick.scroll_into_view_if_needed()
    box = stick.bounding_box()
    assert box
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x, y + 60)
    wait_for("it drives back", lambda: metres_ahead(before, api.drone(robot["id"])["local"]) < -0.2)
    page.mouse.up()
    # It repeats what it heard last for ever, so it was told to stand.
    wait_for("it stands", lambda: speed(api, robot["id"]) == 0)
    page.set_viewport_size({"width": 390, "height": 844})
    check_steering_on_phone(api, robot, page, steer)


def check_steering_on_phone(api: Api, robot: Json, page: Page, steer: Locator) -> None:
    stick, canvas = steer.locator("[data-stick=Drive]"), page.locator("canvas[aria-label^='Map of']")
    # The panel is made anew for a phone; this waits for the new one.
    stick.hover()
    stick.evaluate("stick => stick.scrollIntoView({ block: 'nearest' })")
    x, y = centre(stick)
    yaw = api.drone(robot["id"])["local"]["yaw"]
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 60, y)
    wait_for("it turns to its left", lambda: degrees_turned(yaw, api.drone(robot["id"])["local"]["yaw"]) > 20)
    expect(canvas, "one sees the map and what the range finder meets").to_be_in_viewport(ratio=0.95)
    expect(stick).to_be_in_viewport(ratio=0.95)
    assert is_on_top(page, centre(canvas), "[aria-label^='Map of']"), "nothing lies over it"
    assert is_on_top(page, [x, y - 60], "[data-stick]"), "nor over the stick"
    picture(page, "robot-steered-narrow")
    page.mouse.up()
    expect(steer.get_by_role("status")).to_have_text("Not steering")


def is_on_top(page: Page, place: list[float], selector: str) -> bool:
    return bool(
        page.evaluate(
            "([x, y, selector]) => document.elementFromPoint(x, y)?.closest(selector) !== null",
            [*place, selector],
        )
    )


def centre(of: Locator) -> list[float]:
    box = of.bounding_box()
    assert box
    return [box["x"] + box["width"] / 2, box["y"] + box["height"] / 2]


def metres_ahead(before: Json, now: Json) -> float:
    """In metres, as it looked before."""
    yaw = math.radians(before["yaw"])
    return float((now["x"] - before["x"]) * math.cos(yaw) + (now["y"] - before["y"]) * math.sin(yaw))


def degrees_turned(before: float, after: float) -> float:
    """Degrees to the left, which robots count upwards."""
    return (after - before + 180) % 360 - 180


def test_roslink_drone_is_flown_on_page(
    server: Server, api: Api, page: Page, station: Station, tmp_path: Path
) -> None:
    """End to end because it is about buttons and keys of a page."""
    options = ("--kind", "drone", "--sysid", str(FLYER_ID), "--key", "a flyer")
    with simulated(server, tmp_path / "flyer.log", *options):
        drone = listed(api, FLYER_ID, lambda d: d["actions"]["arm"]["allowed"])
        station.choose(drone["name"])
        station.hold("Arm")
        wait_for("it is armed", lambda: api.drone(drone["id"])["armed"])
        page.get_by_label("Take-off altitude (m)").fill("5")
        station.hold("Take off")
        wait_for("it is up", lambda: height(api, drone["id"]) > 4.5, 60)

        page.get_by_role("button", name="Steer By keys or sticks").click()
        steer = page.get_by_role("region", name="Steer", exact=True)
        before = api.drone(drone["id"])["local"]
        steer.get_by_role("application").focus()
        page.keyboard.down("w")
        wait_for("it flies ahead", lambda: api.drone(drone["id"])["local"]["x"] > before["x"] + 1)
        picture(page, "drone-steered-wide")
        page.keyboard.press("Escape")
        page.keyboard.up("w")
        wait_for("it stands in the air", lambda: speed(api, drone["id"]) == 0)
        assert height(api, drone["id"]) > 4.5
        expect(steer, "and Escape meant nothing else").to_be_visible()

        station.press("Land")
        wait_for("it is down", lambda: height(api, drone["id"]) < 0.1, 60)


def height(api: Api, drone: str) -> float:
    return float((api.drone(drone)["position"] or {}).get("altitudeAboveHome") or 0)
