"""Which flights are left alone at which moment: drawn by a seed, so that a judgement can be had again."""

import random
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

# A person leads it; an operation has the drone itself, and ends in its own way.
LED = ("guided", "velocity", "sticks")
OPERATIONS = ("run", "follow", "virtual")
KINDS = (*LED, "mission", *OPERATIONS)

# To one drone alone.
PRIVATE = ("vanish", "hand over", "revoke", "sign out", "pilot", "pilot while away")
# To all that the server has.
OF_SERVER = ("kill", "standstill", "heap")

REVOCATIONS = ("grant", "key", "user")
# Of whom a drone that is in the warehouse was bound there may be one at a time.
ALONE = frozenset({"virtual"})


@dataclass(frozen=True)
class LossCase:
    """A drone, how it flies, what becomes of whoever has it, and how long after all fly."""

    number: int
    kind: str
    event: str
    after: float
    # Control was taken, and is kept by signs; else it came with a command.
    explicit: bool
    # Of a revocation: what is taken away. Of a pilot: with what.
    how: str
    # The client goes on as if nothing had been.
    insists: bool

    def __str__(self) -> str:
        having = "explicit" if self.explicit else "implicit"
        more = f" ({self.how})" if self.how else ""
        return f"{self.number} {self.kind}, {self.event}{more}, {having}, after {self.after:.1f} s"


@dataclass(frozen=True)
class Plan:
    """What flies at the same time at one server, and what that server suffers in the end."""

    seed: int
    number: int
    suffers: str
    suffers_after: float
    # How long nobody starts it again; its supervisor would at once.
    down: float
    # The vehicles' own fail-safe for a lost ground station: 1 flies home.
    failsafe: int
    moments: tuple[LossCase, ...]


def _is_free(taken: set[str], kind: str) -> bool:
    return kind not in taken


def fits(kind: str, suffers: str, event: str) -> bool:
    """Operations hand nothing over; nobody is away of a server that goes on."""
    if event == "hand over":
        return kind not in OPERATIONS
    return event != "pilot while away" or suffers in ("kill", "standstill")


def draw(seed: int, sorties: int = 4, each: int = 5) -> list[Plan]:
    """Each kind and each event comes about as often as any other; all is decided by the seed."""
    chance = random.Random(seed)
    kinds, events = EvenChoice(chance, KINDS), EvenChoice(chance, PRIVATE)
    suffers = EvenChoice(chance, OF_SERVER)
    plans = []
    for number in range(sorties):
        suffered = suffers.next(lambda _: True)
        moments: list[LossCase] = []
        for place in range(each):
            taken = {one.kind for one in moments} & ALONE
            kind = kinds.next(partial(_is_free, taken))
            # Two of five are left to what the server suffers.
            event = suffered if place < each * 2 // 5 else events.next(partial(fits, kind, suffered))
            moments.append(_moment(chance, number * each + place + 1, kind, event))
        plans.append(
            Plan(
                seed,
                number + 1,
                suffered,
                suffers_after=chance.uniform(5, 9),
                down=chance.uniform(0, 4),
                failsafe=chance.choice((0, 0, 1)),
                moments=tuple(moments),
            )
        )
    return plans


def share(seed: int) -> Plan:
    """Four moments that take less than a minute together."""
    chance = random.Random(seed)
    chosen = [("guided", "revoke"), ("velocity", "vanish"), ("sticks", "pilot"), ("guided", "kill")]
    moments = [_moment(chance, n + 1, kind, event) for n, (kind, event) in enumerate(chosen)]
    # Who took control has a quarter of a minute to come back after a restart.
    moments = [replace(one, after=one.after / 3, explicit=False) for one in moments]
    return Plan(seed, 1, "kill", 3.0, chance.uniform(0, 1), 0, tuple(moments))


def _moment(chance: random.Random, number: int, kind: str, event: str) -> LossCase:
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
        insists=event in ("revoke", "hand over", "pilot", "sign out") and chance.random() < 0.7,
    )


class EvenChoice:
    """Deals each card once before any comes again, as far as the wish lets it."""

    def __init__(self, chance: random.Random, cards: tuple[str, ...]) -> None:
        self._chance = chance
        self._cards = cards
        self._left: list[str] = []

    def next(self, wish: Callable[[str], bool]) -> str:
        fit = [card for card in self._left if wish(card)]
        if not fit:
            more = list(self._cards)
            self._chance.shuffle(more)
            self._left += more
            fit = [card for card in self._left if wish(card)]
        self._left.remove(fit[0])
        return fit[0]
