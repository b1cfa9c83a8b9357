"""Drones that run low are replaced, and nobody who is followed is lost: end to end."""

import os
from collections.abc import Iterator
from pathlib import Path

import pytest

from dronemap_e2e.relay import Relay

SEEDS = os.environ.get("DRONEMAP_TRIAL_SEEDS", "1-1")
PHONES = 10
LONGEST_SECONDS = 400
AFTER_SECONDS = 45
# From who is followed to the nearest of the drones of that follow, on the ground: up to 12 m are asked for,
# who runs ahead of somebody that turns round has as much to make up, and ten cross each other's ways.
KEPT_METRES = 50


def seeds() -> range:
    first, _, last = SEEDS.partition("-")
    return range(int(first), int(last or first) + 1)


@pytest.fixture
def relay(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[Relay]:
    seed: int = request.param
    opened = Relay(tmp_path, seed, PHONES)
    yield opened
    opened.close()


@pytest.mark.soak
@pytest.mark.parametrize("relay", seeds(), indirect=True)
def test_ten_drones_that_run_low_are_replaced_without_losing_anybody(relay: Relay) -> None:
    found = relay.fly(LONGEST_SECONDS, AFTER_SECONDS)
    print(found)
    assert found["vehicles"] == 2 * PHONES, found
    for seen in relay.seen:
        assert seen.states == {"tracking"}, seen
        assert any("comes to replace it" in words for words in seen.told), seen
        assert any("has taken over" in words for words in seen.told), seen
    assert max(found["farthest"]) < KEPT_METRES, found
    assert found["apart"]["left"] > 0, found
