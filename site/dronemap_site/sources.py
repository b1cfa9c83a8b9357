"""Which documents of the checkout are pages of the site, and where there."""

import posixpath
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FRONT_PAGE = "README.md"
# Documents outside docs/ that are pages, where they exist. A link to any other one is a fault.
BESIDES = (
    "CHANGELOG.md",
    "CONTRIBUTING.md",
    "bench/README.md",
    "dronemap-proxy/src/test/resources/org/dronemap/proxy/outlet/what-reaches-vehicles.md",
    "dronemap-sim/exchanges/README.md",
    "dronemap-sim/exchanges/planes.md",
    "java-example/README.md",
    "php-soap-proxy/README.md",
    "ros-bridge/README.md",
    "sdk-python/README.md",
    "sdk-python/dronectl.md",
    "sdk-typescript/README.md",
    "signing-relay/README.md",
    "web-client/README.md",
)
# Long and seldom meant: the search shows other pages first.
SELDOM_MEANT = (
    "CHANGELOG.md",
    "docs/adr/",
    "docs/benchmarks.md",
    "docs/moved-tests.md",
    "dronemap-proxy/",
    "dronemap-sim/",
    "bench/",
)

# Written for questions as people ask them: before the reference, which has every word.
ANSWERS = (
    "README.md",
    "docs/follow.md",
    "docs/guides/",
    "docs/jobs/",
    "docs/operations/",
    "docs/outlet.md",
    "docs/recipes/",
    "docs/settings.md",
    "docs/times.md",
    "docs/troubleshooting.md",
    "docs/vehicles.md",
    "docs/what-it-is.md",
)


@dataclass
class Sources:
    """Pages by their path in the checkout, each with its address in the site as MkDocs has it (`a/b.md`)."""

    root: Path = ROOT
    pages: dict[str, str] = field(default_factory=dict)
    # Folders that have a page of their own.
    folders: dict[str, str] = field(default_factory=dict)

    @classmethod
    def of(cls, root: Path = ROOT) -> "Sources":
        pages = {FRONT_PAGE: "index.md"}
        pages |= {path: path for path in BESIDES if (root / path).exists()}
        for path in sorted((root / "docs").rglob("*.md")):
            pages[path.relative_to(root).as_posix()] = path.relative_to(root / "docs").as_posix()
        folders = {
            posixpath.dirname(path): uri
            for path, uri in pages.items()
            if posixpath.basename(path) == "README.md" and path != FRONT_PAGE
        }
        folders["docs/adr"] = "adr/index.md"
        return cls(root, pages, folders)

    def rank(self, path: str) -> float:
        """How much a page counts in the search."""
        # A word in a title counts a thousand times one in the text, so that less would not be behind.
        if path.startswith(SELDOM_MEANT):
            return 0.002
        return 4 if path.startswith(ANSWERS) else 1

    def text(self, path: str) -> str:
        return (self.root / path).read_text(encoding="utf-8")
