"""Cases of control loss, drawn by a seed: which client loses its drone, how and when."""

import random
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

# A person steers it; an operation has the drone itself, and ends in its own way.
STEERED = ("guided", "velocity", "sticks")
OPERATIONS = ("run", "follow", "virtual")
KINDS = (*STEERED, "mission", *OPERATIONS)

# To one drone alone.
DRONE_EVENTS = ("vanish", "hand over", "revoke", "sign out", "pilot", "pilot while away")
# To all that the server has.
SERVER_EVENTS = ("kill", "standstill", "heap")

REVOCATIONS = ("grant", "key", "user")
# Of whom a drone that is in the warehouse was bound there may be one at a time.
ONE_AT_A_TIME = frozenset({"virtual"})


@dataclass(frozen=True)
class LossCase:
    """One drone: how it is flown, how its controller is lost, and how many seconds after all fly."""

    number: int
    kind: str
    event: str
    after: float
    # Control was taken, and is kept by signs; else it came with a command.
    explicit: bool
    # Of a revocation: what is taken away. Of a pilot: with what.
    how: str
    # The client goes on as if nothing had been.
    keeps_sending: bool

    def __str__(self) -> str:
        having = "explicit" if self.explicit else "implicit"
        more = f" ({self.how})" if self.how else ""
        return f"{self.number} {self.kind}, {self.event}{more}, {having}, after {self.after:.1f} s"


@dataclass(frozen=True)
class SortiePlan:
    """Cases that fly at the same time at one server, and the fault of that server in the end."""

    seed: int
    number: int
    server_event: str
    server_event_after: float
    # How long nobody starts it again; its supervisor would at once.
    down: float
    # The vehicles' own fail-safe for a lost ground station: 1 flies home.
    failsafe: int
    cases: tuple[LossCase, ...]


def _is_free(taken: set[str], kind: str) -> bool:
    return kind not in taken


def fits(kind: str, server_event: str, event: str) -> bool:
    """Operations hand nothing over; nobody is away of a server that goes on."""
    if event == "hand over":
        return kind not in OPERATIONS
    return event != "pilot while away" or server_event in ("kill", "standstill")


def draw(seed: int, sorties: int = 4, each: int = 5) -> list[SortiePlan]:
    """Each kind and each event comes about as often as any other; all is decided by the seed."""
    chance = random.Random(seed)
    kinds, events = EvenChoice(chance, KINDS), EvenChoice(chance, DRONE_EVENTS)
    server_events = EvenChoice(chance, SERVER_EVENTS)
    plans = []
    for number in range(sorties):
        server_event = server_events.next(lambda _: True)
        cases: list[LossCase] = []
        for index in range(each):
            taken = {one.kind for one in cases} & ONE_AT_A_TIME
            kind = kinds.next(partial(_is_free, taken))
            # Two of five are left to what the server suffers.
            event = server_event if index < each * 2 // 5 else events.next(partial(fits, kind, server_event))
            cases.append(_case(chance, number * each + index + 1, kind, event))
        plans.append(
            SortiePlan(
                seed,
                number + 1,
                server_event,
                server_event_after=chance.uniform(5, 9),
                down=chance.uniform(0, 4),
                failsafe=chance.choice((0, 0, 1)),
                cases=tuple(cases),
            )
        )
    return plans


def quick_plan(seed: int) -> SortiePlan:
    """Four cases that take less than a minute together."""
    chance = random.Random(seed)
    chosen = [("guided", "revoke"), ("velocity", "vanish"), ("sticks", "pilot"), ("guided", "kill")]
    cases = [_case(chance, n + 1, kind, event) for n, (kind, event) in enumerate(chosen)]
    # Who took control has a quarter of a minute to come back after a restart.
    cases = [replace(one, after=one.after / 3, explicit=False) for one in cases]
    return SortiePlan(seed, 1, "kill", 3.0, chance.uniform(0, 1), 0, tuple(cases))


def _case(chance: random.Random, number: int, kind: str, event: str) -> LossCase:
    how = ""
    if event == "revoke":
        how = chance.choice(REVOCATIONS if kind not in OPERATIONS else REVOCATIONS[1:])
    elif event.startswith("pilot"):
        how = chance.choice(("by switch", "by station"))
    return LossCase(
        number,
        kind,
        event,
        after=chance.uniform(0.5, 4.5),
        # What was not taken cannot be handed over before it is used again.
        explicit=kind not in OPERATIONS and (event == "hand over" or chance.random() < 0.5),
        how=how,
        keeps_sending=event in ("revoke", "hand over", "pilot", "sign out") and chance.random() < 0.7,
    )


class EvenChoice:
    """Draws each option once before any comes again, as far as the caller allows it."""

    def __init__(self, chance: random.Random, options: tuple[str, ...]) -> None:
        self._random = chance
        self._options = options
        self._left: list[str] = []

    def next(self, is_allowed: Callable[[str], bool]) -> str:
        fit = [option for option in self._left if is_allowed(option)]
        if not fit:
            more = list(self._options)
            self._random.shuffle(more)
            self._left += more
            fit = [option for option in self._left if is_allowed(option)]
        self._left.remove(fit[0])
        return fit[0]
