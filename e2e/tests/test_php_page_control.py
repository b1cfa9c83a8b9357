"""Control of a drone that the page of the PHP SOAP proxy flies does not end by mistake or unseen."""

from dronemap_e2e.api import Api, Json
from dronemap_e2e.php_page import OpenPage, Pilot
from dronemap_e2e.php_proxy import PhpProxy
from dronemap_e2e.screen import PHONE
from dronemap_e2e.station import Touch


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

    page.press("Take control")
    page.press("Give back")
    page.says("Nothing was sent: hold “Give back”")
    assert api.drone(copter["id"])["control"]["holder"] == php_pilot.name
    page.press("Land")
