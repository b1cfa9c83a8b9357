"""Whoever is in the air is somebody's, at random moments: judged by what went between vehicles and server."""

import os
from pathlib import Path

import pytest

from dronemap_e2e.control_loss_judge import Judgement
from dronemap_e2e.control_loss_sortie import Sortie, compile_fault_injector
from dronemap_e2e.control_loss_cases import Plan, draw, share

# Twenty moments each, four flights of five.
SEEDS = os.environ.get("DRONEMAP_TRIAL_SEEDS", "1-1")


def plans() -> list[Plan]:
    first, _, last = SEEDS.partition("-")
    return [plan for seed in range(int(first), int(last or first) + 1) for plan in draw(seed)]


def named(plan: Plan) -> str:
    return f"seed {plan.seed}, flight {plan.number}, {plan.suffers}"


def judged(plan: Plan, judgements: list[Judgement]) -> None:
    print(f"{named(plan)} after {plan.suffers_after:.1f} s, down for {plan.down:.1f} s more")
    for one in judgements:
        print(f"  {one.moment}: {'; '.join(one.faults) or 'kept'} [{one.told}]")
    assert not [fault for one in judgements for fault in one.faults]


@pytest.mark.soak
@pytest.mark.parametrize("plan", plans(), ids=named)
def test_whoever_is_in_the_air_is_somebodys(plan: Plan, tmp_path: Path) -> None:
    faults = compile_fault_injector(tmp_path) if plan.suffers == "heap" else None
    judged(plan, Sortie(plan, tmp_path, faults).fly())


@pytest.mark.soak
@pytest.mark.parametrize("on_loss", ["nothing", "hold"])
def test_a_server_that_leaves_them_in_the_air_is_found(on_loss: str, tmp_path: Path) -> None:
    """The judge is seen to find fault with what a server can be set to, and with nothing else."""
    judgements = Sortie(share(1), tmp_path, on_loss=on_loss, longest=45).fly()
    found = {one.moment.event: " ".join(one.faults) for one in judgements}
    assert not found.pop("pilot"), found
    assert all("never went home" in fault for fault in found.values()), found


def test_four_moments(tmp_path: Path) -> None:
    """End to end because a process is killed over its database, and the judge sees nothing but the wire."""
    plan = share(1)
    judged(plan, Sortie(plan, tmp_path).fly())
