"""Long names break after an underscore on the page, and are whole words for the search."""

from pathlib import Path

import pytest

from dronemap_site.names import breakable

NAME = "DRONEMAP_WATCHDOG_LOST_SECONDS"
BROKEN = "DRONEMAP_<wbr>WATCHDOG_<wbr>LOST_<wbr>SECONDS"


@pytest.mark.parametrize(
    ("html", "broken"),
    [
        (f"<td><code>{NAME}</code></td>", f"<td><code>{BROKEN}</code></td>"),
        ("<code>SafetyTimes.VEHICLE_RETURNS</code>", "<code>SafetyTimes.VEHICLE_<wbr>RETURNS</code>"),
        (f"<pre><code>export {NAME}=5</code></pre>", f"<pre><code>export {NAME}=5</code></pre>"),
        (f'<h2 id="{NAME}">{NAME}</h2>', f'<h2 id="{NAME}">{NAME}</h2>'),
    ],
)
def test_name_is_broken_after_its_underscores(html: str, broken: str) -> None:
    assert breakable(html) == broken


def test_page_breaks_names_and_the_search_does_not(site: Path) -> None:
    assert f"<code>{BROKEN}</code>" in (site / "settings.html").read_text()
    index = (site / "search" / "search_index.json").read_text()
    assert NAME in index
    assert "wbr" not in index
