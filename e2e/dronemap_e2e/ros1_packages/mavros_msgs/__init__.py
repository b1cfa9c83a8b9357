"""The part of mavros_msgs that the bridge uses, which Debian does not package."""

from typing import Any

from genpy.dynamic import generate_dynamic
from geometry_msgs.msg import Point, Vector3
from std_msgs.msg import Header

HEADER = "std_msgs/Header header\n"
PARTS = (Header, Point, Vector3)


def message(name: str, fields: str) -> Any:
    """A class of messages with such fields."""
    text = fields + "".join(f"{'=' * 80}\nMSG: {part._type}\n{part._full_text}\n" for part in PARTS)
    return generate_dynamic(f"mavros_msgs/{name}", text)[f"mavros_msgs/{name}"]


def service(name: str, asked: str, answered: str) -> Any:
    request, response = message(f"{name}Request", asked), message(f"{name}Response", answered)
    body = {
        "_type": f"mavros_msgs/{name}",
        "_md5sum": f"a stand-in for {name}",
        "_request_class": request,
        "_response_class": response,
    }
    return type(name, (), body)
