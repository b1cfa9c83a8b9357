"""Messages of the stream, either way, with their members."""

from ..navigation import Nav
from .contract import SCHEMA, Contract, Json
from .wording import Wording, plain

HEARD = "reference/stream/messages.md"
SAID = "reference/stream/requests.md"
# What a client does, as the description has it: it describes the server.
PAGES = {HEARD: ("send", "Messages"), SAID: ("receive", "Requests")}


def pages(contract: Contract) -> tuple[dict[str, str], Nav]:
    texts = {uri: _page(contract, uri, action, title) for uri, (action, title) in PAGES.items()}
    return texts, [{"Stream": [{title: uri} for uri, (_, title) in PAGES.items()]}]


def _page(contract: Contract, uri: str, action: str, title: str) -> str:
    wording = Wording(contract, uri)
    begin = "What the server says" if action == "send" else "What a client may say"
    lines = [
        f"# {title} of the stream",
        "",
        f"{begin}, each a JSON object with a `type`. [The stream]({wording.to('stream.md')}) tells when.",
        "",
    ]
    answers = {
        message: operation
        for operation in contract.stream["operations"].values()
        if operation["action"] == "receive"
        for message in _messages(operation)
    }
    for name, message in contract.stream["components"]["messages"].items():
        heard = name in answers
        if heard == (action == "receive"):
            lines += _message(contract, wording, name, message, answers.get(name, {}))
    return "\n".join(lines) + "\n"


def _message(contract: Contract, wording: Wording, name: str, message: Json, operation: Json) -> list[str]:
    lines = [f"## {message['name']} {{ #{name} }}", "", plain(message.get("summary", "")), ""]
    if operation.get("summary"):
        lines += [plain(operation["summary"]), ""]
    replies = [_link(contract, wording, reply) for reply in _messages(operation.get("reply", {}))]
    if replies:
        lines += [f"Answered by {' or '.join(replies)}.", ""]
    schema = contract.schemas[str(message["payload"]["$ref"]).removeprefix(SCHEMA)]
    return [*lines, *wording.members(schema), ""]


def _messages(operation: Json) -> list[str]:
    return [str(message["$ref"]).rsplit("/", 1)[1] for message in operation.get("messages", [])]


def _link(contract: Contract, wording: Wording, name: str) -> str:
    message = contract.stream["components"]["messages"][name]
    return f"[{message['name']}]({wording.to(HEARD)}#{name})"
