"""Control of a drone that the page of the PHP SOAP proxy flies does not end by mistake or unseen."""

from playwright.sync_api import Route, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.php_page import OpenPage, PhpPage, Pilot
from dronemap_e2e.php_proxy import PhpProxy
from dronemap_e2e.screen import PHONE
from dronemap_e2e.station import Pointer, Touch
from dronemap_e2e.waiting import wait_for


def land(page: PhpPage, api: Api, copter: Json) -> None:
    page.press("Land")
    wait_for("it landed and disarmed", lambda: api.drone(copter["id"])["armed"] is False, 60)


def test_letting_go_of_a_held_button_presses_nothing_else(
    php_proxy: PhpProxy, php_page: OpenPage, php_pilot: Pilot, api: Api, copter: Json
) -> None:
    """End to end because a browser makes a click of a finger's release, wherever it is by then."""
    page = php_page(php_proxy, Touch(), PHONE)
    page.sign_in(php_pilot.name, php_pilot.password)
    page.choose(copter["name"])
    page.hold("Arm")
    page.says("Arm. Succeeded.")
    page.hold("Take off")
    page.says("Take off to 10 m")
    page.tool("Fly to")
    page.tap(page.mark(copter["id"]))
    page.page.evaluate(
        """() => {
             window.pressed = [];
             for (const type of ['mousedown', 'click']) {
               document.addEventListener(type, ({ target }) => pressed.push(`${type} ${target.id}`));
             }
           }"""
    )
    page.hold("Fly there")
    page.says("Fly to")
    assert page.page.evaluate("pressed") == []
    page.button("Hold").press("Enter")
    page.says("Hold. Succeeded.")

    page.press("Give back")
    page.says("Nothing was sent: hold “Give back”")
    assert api.drone(copter["id"])["control"]["holder"] == php_pilot.name
    land(page, api, copter)


def test_control_that_ends_in_the_air_is_said(
    php_proxy: PhpProxy, php_page: OpenPage, php_pilot: Pilot, api: Api, copter: Json
) -> None:
    """End to end because a browser keeps control by a timer of its own, and tells who looks elsewhere."""
    page = php_page(php_proxy, Pointer())
    page.sign_in(php_pilot.name, php_pilot.password)
    page.choose(copter["name"])
    page.hold("Arm")
    page.says("Arm. Succeeded.")
    held = api.drone(copter["id"])["control"]
    assert (held["holder"], held["explicit"]) == (php_pilot.name, True)
    expect(page.page.get_by_text("When you close it, the drone holds, then flies home.")).to_be_visible()
    page.hold("Take off")
    page.says("Take off to 10 m")
    alarm = page.page.get_by_role("contentinfo").get_by_role("alert")
    expect(alarm).to_be_empty()
    expect(page.page.get_by_text("Flying", exact=True).last).to_be_visible()
    page.press("Sign out")
    page.says("is in the air: it is brought home once you sign out")

    control = f"/drones/{copter['id']}/control"
    assert api.call("POST", f"{control}/take-over", {"reason": "test"}).ok
    expect(alarm).to_contain_text(f"Your control of {copter['name']} has ended: admin has control.")
    expect(page.alarm_button).to_be_hidden()
    assert api.call("DELETE", control).ok
    expect(alarm).to_contain_text(
        "Nobody has control of it; it is brought home unless somebody takes control."
    )
    page.picture("lost")
    page.alarm_button.click()
    expect(alarm).to_be_empty()
    assert api.drone(copter["id"])["control"]["holder"] == php_pilot.name
    land(page, api, copter)


def test_late_answer_about_control_that_has_ended_does_not_end_the_new_one(
    php_proxy: PhpProxy, php_page: OpenPage, php_pilot: Pilot, api: Api, copter: Json
) -> None:
    """End to end because answers overtake one another between a browser and a server."""
    page = php_page(php_proxy, Pointer())
    page.sign_in(php_pilot.name, php_pilot.password)
    page.choose(copter["name"])
    page.press("Take control")
    kept = page.page.get_by_text("You have control while this page is open")
    expect(kept).to_be_visible()
    late: list[Route] = []

    def delay_the_first(route: Route) -> None:
        if late:
            route.fallback()
        else:
            late.append(route)

    with page.page.expect_request("**/proxy.php?operation=keepControl"):
        page.page.route("**/proxy.php?operation=keepControl", delay_the_first)
    control = f"/drones/{copter['id']}/control"
    assert api.call("POST", f"{control}/take-over", {"reason": "test"}).ok
    expect(page.page.get_by_text("admin has control.")).to_be_visible()
    assert api.call("DELETE", control).ok
    page.press("Take control")
    expect(kept).to_be_visible()

    with page.page.expect_response("**/proxy.php?operation=keepControl") as answer:
        late[0].continue_()
    assert not answer.value.ok
    with page.page.expect_response("**/proxy.php?operation=keepControl") as answer:
        expect(kept).to_be_visible()
    assert answer.value.ok
