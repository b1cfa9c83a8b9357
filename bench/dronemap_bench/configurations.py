"""Configurations that are measured: vehicles, rates, networks, floods and clients."""

from dataclasses import dataclass, replace


@dataclass(frozen=True)
class Impairment:
    """A bad network between vehicles and server; times in ms, probabilities 0 to 1."""

    delay: float = 0
    jitter: float = 0
    loss: float = 0
    duplicate: float = 0
    reorder: float = 0
    rebind_seconds: float = 0
    seed: int = 1

    def arguments(self) -> list[str]:
        values = {
            "--delay": self.delay,
            "--jitter": self.jitter,
            "--loss": self.loss,
            "--duplicate": self.duplicate,
            "--reorder": self.reorder,
            "--rebind": self.rebind_seconds,
            "--seed": self.seed,
        }
        return [word for name, value in values.items() for word in (name, str(value))]


@dataclass(frozen=True)
class Flood:
    """Nonsense from one address, that of half of the vehicles, for the second half of the time."""

    kind: str
    rate: int = 50_000
    seed: int = 1

    def arguments(self) -> list[str]:
        return ["--kind", self.kind, "--rate", str(self.rate), "--seed", str(self.seed)]


@dataclass(frozen=True)
class Clients:
    """Ground stations at the outlet that watch all vehicles for the second half of the time."""

    count: int = 50
    stuck: int = 1
    """Beside them, attached by TCP and never reading."""
    settle_seconds: int = 10
    """Between their coming and the measurement."""

    def arguments(self) -> list[str]:
        return ["--clients", str(self.count), "--stuck", str(self.stuck)]


@dataclass(frozen=True)
class Configuration:
    """So many vehicles, each with so many messages a second."""

    name: str
    what: str
    vehicles: int
    rate: int
    seconds: int = 60
    warm_up: int = 15
    only_positions: bool = False
    impairment: Impairment | None = None
    flood: Flood | None = None
    clients: Clients | None = None
    recorded: bool = True

    @property
    def hosts(self) -> int:
        """Vehicles are spread over so many addresses; a flood comes from the first of them."""
        return 2 if self.flood else 1

    @property
    def halved(self) -> bool:
        """True when its disturbance is in the second half; the first half is measured by itself."""
        return self.flood is not None or self.clients is not None

    @property
    def settle_seconds(self) -> int:
        return self.clients.settle_seconds if self.clients else 0

    def steps(self) -> int:
        return self.rate * (self.warm_up + self.seconds + self.settle_seconds)

    def short(self, seconds: int) -> "Configuration":
        return replace(self, seconds=seconds, warm_up=min(self.warm_up, max(4, seconds // 2)))


# A router's delay and loss as in the study that the five configurations come from (docs: bench/README.md).
UNSTABLE = Impairment(delay=500, jitter=200, loss=0.1)
SPOILT = Impairment(delay=60, jitter=40, loss=0.05, duplicate=0.05, reorder=0.05)
MOVING = Impairment(delay=5, jitter=2, rebind_seconds=10)

CONFIGURATIONS = [
    Configuration("fleet-100", "250 vehicles, 100 messages/s each", 250, 100),
    Configuration("fleet-200", "250 vehicles, 200 messages/s each", 250, 200),
    Configuration(
        "forwarding", "250 vehicles, 100 messages/s each, nothing recorded", 250, 100, recorded=False
    ),
    Configuration("latency", "8 vehicles, 24 positions/s each", 8, 24, only_positions=True),
    Configuration("many", "2,000 vehicles, 10 messages/s each", 2000, 10, warm_up=30),
    Configuration("imatisse-1", "minimal fleet: 2 x 4 vehicles, 4 Hz", 8, 4, only_positions=True),
    Configuration("imatisse-2", "medium rate: 2 x 4 vehicles, 10 Hz", 8, 10, only_positions=True),
    Configuration("imatisse-3", "high rate: 2 x 4 vehicles, 24 Hz", 8, 24, only_positions=True),
    Configuration(
        "imatisse-1b",
        "minimal, unstable network: 500 +- 200 ms, 10 % loss",
        8,
        4,
        only_positions=True,
        impairment=UNSTABLE,
    ),
    Configuration(
        "imatisse-3b",
        "high rate, unstable network: 500 +- 200 ms, 10 % loss",
        8,
        24,
        only_positions=True,
        impairment=UNSTABLE,
    ),
    Configuration(
        "spoilt",
        "60 +- 40 ms, 5 % lost, 5 % doubled, 5 % held back",
        8,
        24,
        only_positions=True,
        impairment=SPOILT,
    ),
    Configuration(
        "moving",
        "each vehicle gets a new address every 10 s",
        8,
        24,
        only_positions=True,
        impairment=MOVING,
    ),
    Configuration(
        "flood-broken",
        "50,000 broken datagrams/s from one address in the second half",
        8,
        24,
        only_positions=True,
        flood=Flood("broken"),
    ),
    Configuration(
        "flood-hostile",
        "50,000 good frames/s that mean no good from one address in the second half",
        8,
        24,
        only_positions=True,
        flood=Flood("hostile"),
    ),
    Configuration(
        "attached",
        "50 vehicles, 20 messages/s each; then 50 ground stations at the outlet, and a stuck one",
        50,
        20,
        clients=Clients(),
        # Both halves are compared, so the first one may not be that of a young server.
        warm_up=45,
    ),
]


def named(names: list[str]) -> list[Configuration]:
    """The configurations with these names, in their order; all when none is named."""
    known = {c.name: c for c in CONFIGURATIONS}
    unknown = [name for name in names if name not in known]
    if unknown:
        raise SystemExit(f"There is no configuration {unknown[0]}; there are {', '.join(known)}.")
    return [known[name] for name in names] if names else CONFIGURATIONS
