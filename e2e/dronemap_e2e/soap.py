"""SOAP as zeep speaks it, from the service's own WSDL."""

from typing import Any

import zeep
import zeep.transports
from requests import Session

from .server import Server


def soap(server: Server, key: str, service: str = "MAVLinkControllerService", version: str = "1.1") -> Any:
    """The service proxy; every call carries the access key. A list is `{"item": [...]}`, both ways."""
    session = Session()
    transport: Any = zeep.transports.Transport(session=session)  # type: ignore[no-untyped-call]
    client: Any = zeep.Client(  # type: ignore[no-untyped-call]
        f"{server.address}/services/{service}?wsdl", transport=transport
    )
    session.headers["Authorization"] = f"Bearer {key}"
    port = next(
        name for name in client.wsdl.services[service].ports if name.endswith("12") == (version == "1.2")
    )
    return client.bind(service, port)
