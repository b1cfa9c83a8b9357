"""Control loss at random moments: no drone stays in the air unattended, judged by the datagrams."""

import os
from pathlib import Path

import pytest

from dronemap_e2e.control_loss_cases import SortiePlan, draw, quick_plan
from dronemap_e2e.control_loss_judge import Judgement
from dronemap_e2e.control_loss_sortie import Sortie, compile_fault_injector

# Twenty moments each, four flights of five.
SEEDS = os.environ.get("DRONEMAP_TRIAL_SEEDS", "1-1")


def plans() -> list[SortiePlan]:
    first, _, last = SEEDS.partition("-")
    return [plan for seed in range(int(first), int(last or first) + 1) for plan in draw(seed)]


def plan_name(plan: SortiePlan) -> str:
    return f"seed {plan.seed}, flight {plan.number}, {plan.server_event}"


def assert_no_faults(plan: SortiePlan, judgements: list[Judgement]) -> None:
    print(f"{plan_name(plan)} after {plan.server_event_after:.1f} s, down for {plan.down:.1f} s more")
    for one in judgements:
        print(f"  {one.case}: {'; '.join(one.faults) or 'kept'} [{one.summary}]")
    assert not [fault for one in judgements for fault in one.faults]


@pytest.mark.soak
@pytest.mark.parametrize("plan", plans(), ids=plan_name)
def test_control_loss_in_the_air_ends_safely(plan: SortiePlan, tmp_path: Path) -> None:
    faults = compile_fault_injector(tmp_path) if plan.server_event == "heap" else None
    assert_no_faults(plan, Sortie(plan, tmp_path, faults).fly())


@pytest.mark.soak
@pytest.mark.parametrize("on_loss", ["nothing", "hold"])
def test_judge_reports_server_that_leaves_drones_in_the_air(on_loss: str, tmp_path: Path) -> None:
    """The judge is seen to find fault with what a server can be set to, and with nothing else."""
    judgements = Sortie(quick_plan(1), tmp_path, on_loss=on_loss, longest=45).fly()
    found = {one.case.event: " ".join(one.faults) for one in judgements}
    assert not found.pop("pilot"), found
    assert all("never went home" in fault for fault in found.values()), found


def test_four_cases_of_control_loss(tmp_path: Path) -> None:
    """End to end because a process is killed over its database, and the judge sees nothing but the wire."""
    plan = quick_plan(1)
    assert_no_faults(plan, Sortie(plan, tmp_path).fly())
