"""Screens of the sizes that pages are made for, on a machine that draws maps by software."""

import os
from typing import Any

from playwright.sync_api import Browser, Locator, Page, ViewportSize

DESK: ViewportSize = {"width": 1440, "height": 900}
PHONE: ViewportSize = {"width": 390, "height": 844}

# Software takes a third of a second of a core for each picture of a map that fills a desk's screen, and a
# drone that flies wants sixty a second. Nobody looks at it here: five pictures a second, and a sixteenth of
# the points. Layout, texts and everything else have all of theirs.
SPARING = """(() => {
  const draw = window.requestAnimationFrame.bind(window);
  const waiting = new Map();
  let last = -Infinity, number = 0, asked = false;
  const all = (now) => {
    last = performance.now();
    asked = false;
    for (const [one, action] of [...waiting]) {
      if (waiting.delete(one)) {
        try { action(now); } catch (error) { reportError(error); }
      }
    }
  };
  window.requestAnimationFrame = (action) => {
    if (!asked) setTimeout(() => draw(all), Math.max(0, last + 200 - performance.now()));
    asked = true;
    waiting.set(++number, action);
    return number;
  };
  window.cancelAnimationFrame = (cancelled) => { waiting.delete(cancelled); };
  Object.defineProperty(window, 'devicePixelRatio', { get: () => 0.25 });
})()"""


def also_at(page: Page, size: ViewportSize, *targets: Locator) -> None:
    """Can be pressed at this size, too: it is in sight, at rest, with nothing over it."""
    before = page.viewport_size
    assert before
    page.set_viewport_size(size)
    for target in targets:
        target.click(trial=True)
    page.set_viewport_size(before)


def open_page(
    browser: Browser, size: ViewportSize = DESK, touch: bool = False, dark: bool = False, **options: Any
) -> Page:
    """In a context of its own, which shares nothing with others; `options` as Playwright's for contexts."""
    context = browser.new_context(
        viewport=size,
        has_touch=touch,
        is_mobile=touch,
        color_scheme="dark" if dark else "light",
        **options,
    )
    # Pictures for people are drawn as a person's screen draws them.
    if "DRONEMAP_E2E_SCREENSHOTS" not in os.environ:
        context.add_init_script(SPARING)
    return context.new_page()
