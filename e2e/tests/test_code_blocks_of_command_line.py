"""The code blocks of dronectl, which starts many times, run as they stand (docs/testing.md, Code blocks)."""

from pathlib import Path

import pytest

from dronemap_e2e.demo_fleet import DemoFleet
from dronemap_e2e.page_runs import pages_to_run, run_page


@pytest.mark.parametrize("page", pages_to_run("sdk-python/dronectl.md"))
def test_blocks_of_a_page_run_one_after_the_other(page: str, demo_fleet: DemoFleet, tmp_path: Path) -> None:
    """End to end because a reader runs them before a server with copters, in many languages."""
    run_page(page, demo_fleet, tmp_path)
