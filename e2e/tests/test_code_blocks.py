"""Every code block of the documents has a language, and those that can run do (docs/testing.md, Code blocks).

Pages in folders are run by tests of their own, so that they run beside these.
"""

import json
from pathlib import Path
from xml.etree import ElementTree

import pytest

from dronemap_e2e.demo_fleet import DemoFleet
from dronemap_e2e.documents import Block, blocks_of, faults_of_form, pages, read_blocks, runs_of
from dronemap_e2e.page_runs import pages_to_run, run_page

ELSEWHERE = ("sdk-", "php-", "java-", "docs/guides/", "docs/jobs/", "docs/recipes/", "docs/operations/")


@pytest.mark.parametrize("page", pages_to_run("", but=ELSEWHERE))
def test_blocks_of_a_page_run_one_after_the_other(page: str, demo_fleet: DemoFleet, tmp_path: Path) -> None:
    """End to end because a reader runs them before a server with copters, in many languages."""
    run_page(page, demo_fleet, tmp_path)


@pytest.mark.parametrize("page", pages())
def test_blocks_have_language_and_reason(page: str) -> None:
    """Of the judge alone: what is not run says why, and what is data can be read as such."""
    blocks = read_blocks(page)
    faults = [fault for block in blocks if (fault := faults_of_form(block))]
    faults += [fault for block in blocks if (fault := fault_of_data(block))]
    assert runs_of(blocks) is not None
    for block in blocks:
        if block.note:
            print(f"{block.place} ({block.language}) {block.note}: {block.reason}")
    assert faults == []


def fault_of_data(block: Block) -> str:
    if block.note == "not run":
        return ""
    try:
        if block.language == "json":
            json.loads(block.text)
        elif block.language == "xml":
            ElementTree.fromstring(block.text)
    except (ValueError, ElementTree.ParseError) as why:
        return f"{block.place}: The {block.language} cannot be read: {why}."
    return ""


PAGE = """
```
what
```
<!-- not run: needs a vehicle of your own -->
```bash
fly
```
- In a list:
  <!-- fails: the server refuses it -->
  ```ts
  import { a } from 'b';
  ```

```ts
a();
```
```cobol
```
<!-- not run: no -->

```python
```
"""


def test_forms_of_blocks_are_told_apart() -> None:
    """Of the judge alone: a page with each kind of block and fault."""
    blocks = list(blocks_of("page.md", PAGE))
    assert [block.line for block in blocks] == [3, 7, 12, 16, 19, 23]
    assert [bool(faults_of_form(block)) for block in blocks] == [True, False, False, False, True, True]
    (program,) = runs_of(blocks)
    assert program.kind == "ts"
    assert program.fails
    lines = program.source.splitlines()
    assert (lines[11], lines[15]) == ("import { a } from 'b';", "a();")


def test_data_that_cannot_be_read_is_a_fault() -> None:
    """Of the judge alone: JSON and XML with a piece missing."""
    broken = blocks_of("page.md", '```json\n{"a": 1\n```\n```xml\n<a>\n```\n```json\n{}\n```\n')
    assert [bool(fault_of_data(block)) for block in broken] == [True, True, False]
