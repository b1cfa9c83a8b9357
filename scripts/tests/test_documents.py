"""Documents are wrapped, so that a change of one sentence can be read as one."""

import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
MOST = 120


def documents() -> list[str]:
    listed = subprocess.run(["git", "ls-files", "*.md"], cwd=ROOT, capture_output=True, text=True, check=True)
    return listed.stdout.split()


def too_long(text: str) -> list[str]:
    """Lines that could be wrapped: no tables, no code, no HTML, and no line that is one piece."""
    found = []
    code = False
    for line in text.splitlines():
        if line.lstrip().startswith(("```", "~~~")):
            code = not code
        begins = line.lstrip()[:1]
        whole = begins in ("|", "<") or line.startswith("    ") or " | " in line
        # A piece of code within a sentence stays in one line.
        words = line if line.count("`") < 2 else "".join(line.split("`")[::2])
        if len(line) > MOST and not code and not whole and len(words) > MOST // 2:
            found.append(line)
    return found


@pytest.mark.parametrize("document", documents())
def test_document_lines_are_wrapped(document: str) -> None:
    assert too_long((ROOT / document).read_text()) == []


def test_long_line_is_found() -> None:
    assert too_long("word " * 30) == ["word " * 30]
    assert too_long("```\n" + "word " * 30 + "\n```\n| " + "word " * 30) == []
