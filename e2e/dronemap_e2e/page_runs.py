"""One page of the documents as its reader runs it, before the demo fleet."""

import time
from pathlib import Path

import pytest

from .block_sessions import MOST_SECONDS, PageSessions
from .demo_fleet import DemoFleet
from .documents import Run, pages, read_blocks, runs_of


def pages_to_run(*begin: str, but: tuple[str, ...] = ()) -> list[str]:
    """Those below some folders, or of some names, that have a block to run."""
    chosen = [page for page in pages() if page.startswith(begin) and not page.startswith(but or ("\0",))]
    return [page for page in chosen if any(block.runs for block in read_blocks(page))]


def run_page(page: str, fleet: DemoFleet, folder: Path) -> None:
    """Fails with the place of the block that did not end as it should, and with what it said."""
    scratch = folder / "blocks"
    scratch.mkdir()
    sessions = PageSessions(
        fleet.reader_folder(folder / "checkout"), scratch, fleet.environment(folder / "home")
    )
    try:
        for run in runs_of(read_blocks(page)):
            begun = time.monotonic()
            status, said = sessions.run(run, fleet.mapped(run.source))
            print(f"{run.first.place} took {time.monotonic() - begun:.1f} s")
            fault = _fault(run, status)
            if fault:
                pytest.fail(f"{run.first.place}: {fault} It said:\n{said}", pytrace=False)
    finally:
        sessions.close()
        fleet.tidy_up()


def _fault(run: Run, status: int) -> str:
    if status == -1:
        return f"The block did not end within {MOST_SECONDS} s."
    if run.fails and status == 0:
        return f"The block ended well, though it is said to fail: {run.first.reason}."
    if not run.fails and status != 0:
        return f"The block failed (status {status})."
    return ""
