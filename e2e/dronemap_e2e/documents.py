"""The code blocks of the documents: what readers run, what is only read, and what cannot run and why."""

import re
from collections.abc import Iterator
from dataclasses import dataclass

from .server import ROOT

# What a test runs. Blocks of a shell or of Python share one session a page; the others are programs.
SESSIONS = {"bash": "bash", "sh": "bash", "python": "python"}
PROGRAMS = {"php": "php", "ts": "ts", "typescript": "ts", "js": "js", "java": "java"}
PARSED = ("json", "xml")
READ_ONLY = ("text", "toml", "yaml", "ini", "sql", "http", "html", "apache", "nginx")
# A block that begins so is a program; one that does not goes on with the program before it.
BEGINNINGS = {
    "php": re.compile(r"^<\?php", re.MULTILINE),
    "ts": re.compile(r"^import ", re.MULTILINE),
    "js": re.compile(r"^import |\brequire\(", re.MULTILINE),
    "java": re.compile(r""),
}
FENCE = re.compile(r"^( *)(`{3,}|~{3,}) *([^\s`{]*)")
NOTE = re.compile(r"^ *<!-- (not run|fails): (.+) -->$")
LEFT_OUT = ("docs/adr/", "docs/benchmarks.md", "docs/moved-tests.md")
BESIDES = (
    "README.md",
    "sdk-python/*.md",
    "sdk-typescript/README.md",
    "php-soap-proxy/README.md",
    "java-example/README.md",
)


@dataclass(frozen=True)
class Block:
    page: str
    line: int  # of its first line of code
    language: str
    text: str
    note: str = ""  # "not run", "fails" or nothing
    reason: str = ""

    @property
    def place(self) -> str:
        return f"{self.page}:{self.line}"

    @property
    def runs(self) -> bool:
        return self.note != "not run" and (self.language in SESSIONS or self.language in PROGRAMS)


@dataclass(frozen=True)
class Run:
    """What is run at once: a block for a session, or the blocks that are one program."""

    kind: str
    blocks: tuple[Block, ...]

    @property
    def first(self) -> Block:
        return self.blocks[0]

    @property
    def fails(self) -> bool:
        return any(block.note == "fails" for block in self.blocks)

    @property
    def source(self) -> str:
        """Each line stands where it stands in the page, so that errors name the page's lines."""
        lines: list[str] = []
        for block in self.blocks:
            lines += [""] * (block.line - 1 - len(lines)) + block.text.splitlines()
        return "\n".join(lines) + "\n"


def pages() -> list[str]:
    """Paths of the documents whose blocks are looked at, from the top of the checkout."""
    found = [path for pattern in BESIDES for path in sorted(ROOT.glob(pattern))]
    found += sorted((ROOT / "docs").rglob("*.md"))
    names = [path.relative_to(ROOT).as_posix() for path in found]
    return [name for name in names if not name.startswith(LEFT_OUT)]


def read_blocks(page: str) -> list[Block]:
    return list(blocks_of(page, (ROOT / page).read_text()))


def blocks_of(page: str, text: str) -> Iterator[Block]:
    lines = text.splitlines()
    number = 0
    while number < len(lines):
        opened = FENCE.match(lines[number])
        number += 1
        if opened is None:
            continue
        indent, fence, language = opened.groups()
        begin = number
        while number < len(lines) and lines[number].strip() != fence:
            number += 1
        # Some formatters put an empty line between the note and the fence.
        before = [line for line in lines[max(0, begin - 3) : begin - 1] if line.strip()]
        noted = NOTE.match(before[-1]) if before else None
        yield Block(
            page,
            begin + 1,
            language,
            "\n".join(line.removeprefix(indent) for line in lines[begin:number]),
            *(noted.groups() if noted else ()),
        )
        number += 1


def runs_of(blocks: list[Block]) -> list[Run]:
    """In the order of the page; a program stands where its first block does."""
    runs: list[Run] = []
    for block in blocks:
        if not block.runs:
            continue
        program = PROGRAMS.get(block.language)
        if program and not BEGINNINGS[program].search(block.text):
            before = [place for place, run in enumerate(runs) if run.kind == program]
            assert before, f"{block.place}: goes on with a program that the page has not begun"
            runs[before[-1]] = Run(program, (*runs[before[-1]].blocks, block))
        else:
            runs.append(Run(program or SESSIONS[block.language], (block,)))
    return runs


def faults_of_form(block: Block) -> str:
    """Why the block is neither run, nor parsed, nor only read; empty: it is one of these."""
    known = (*SESSIONS, *PROGRAMS, *PARSED, *READ_ONLY)
    if block.language not in known:
        named = f"'{block.language}' is none of" if block.language else "It has no language; there are"
        return f"{block.place}: {named} {', '.join(known)}."
    if block.note and block.language not in (*SESSIONS, *PROGRAMS, *PARSED):
        return f"{block.place}: A block of {block.language} is never run and needs no reason."
    if block.note and len(block.reason.split()) < 2:
        return f"{block.place}: '{block.reason}' is no reason why it {block.note}."
    return ""
