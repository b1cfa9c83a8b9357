"""Services that may take long to answer, called one after the other beside what must not wait for them."""

import logging
import queue
import threading
from typing import Any, Callable, Tuple, Type

LOG = logging.getLogger(__name__)
MOST_WAITING = 4

Call = Tuple[str, Callable[[], Any]]


class ServiceCalls:
    """Calls services one after the other; what finds no room is left out, as the cloud asks again."""

    def __init__(self, failures: Tuple[Type[Exception], ...]) -> None:
        self._failures = failures
        self._waiting: "queue.Queue[Call]" = queue.Queue(MOST_WAITING)
        #: What found no room.
        self.dropped = 0
        threading.Thread(target=self._run, name="calls", daemon=True).start()

    def ask(self, what: str, call: Callable[[], Any]) -> None:
        try:
            self._waiting.put_nowait((what, call))
        except queue.Full:
            self.dropped += 1

    def _run(self) -> None:
        while True:
            what, call = self._waiting.get()
            try:
                if not call():
                    LOG.warning("The flight controller refuses %s", what)
            except self._failures as failure:
                LOG.warning("There is no answer about %s: %s", what, failure)
