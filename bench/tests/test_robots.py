"""Half a thousand robots lose nothing, and the server grows no fatter by them (soak)."""

import pytest

from dronemap_bench.robots import measure

ROBOTS, RATE, SECONDS = 500, 10, 300


@pytest.mark.soak
def test_many_robots_lose_no_message_and_memory_stays_flat() -> None:
    result = measure(ROBOTS, RATE, SECONDS)
    sent = result["sent"]
    assert sent["refused"] == 0, result
    assert result["received"] == {"udpserver": sent["byUdp"], "wsserver": sent["byWeb"]}, result
    assert (result["dropped"], result["broken"], result["kernelDrops"]) == (0, 0, 0), result
    # By two links they come in another order than they were numbered: what is missing is told, not known.
    assert result["missingNumbers"] < (sent["byUdp"] + sent["byWeb"]) / 1000, result
    assert result["arrived"] == ROBOTS, result
    assert result["lateMegabytes"] <= result["warmMegabytes"] + 15, result
