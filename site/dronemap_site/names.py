"""Long names of settings and constants may be broken after an underscore, and nowhere else."""

import re

_NAME = re.compile(r"<code>([A-Za-z0-9.]+_[A-Za-z0-9_.]+)</code>")


def breakable(html: str) -> str:
    return _NAME.sub(lambda found: f"<code>{found[1].replace('_', '_<wbr>')}</code>", html)
