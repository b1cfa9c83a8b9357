"""The order of the pages: sections, and folders whose pages come by themselves."""

import posixpath
from collections.abc import Iterator
from dataclasses import dataclass

from .sources import Sources

# As MkDocs has it: a page, or a title with pages below it.
Nav = list[str | dict[str, "str | Nav"]]


@dataclass(frozen=True)
class Named:
    """A page that is called otherwise here than in its first heading."""

    title: str
    path: str


@dataclass(frozen=True)
class Folder:
    """All pages of a folder that stand nowhere before: those that are named here first, then the others."""

    path: str
    first: tuple[str, ...] = ()


@dataclass(frozen=True)
class Generated:
    """Pages that have no document, below an address of the site."""

    below: str


@dataclass(frozen=True)
class Section:
    title: str
    entries: "tuple[str | Named | Folder | Section | Generated, ...]"


SECTIONS = (
    Section(
        "Start",
        (
            Named("Dronemap", "README.md"),
            "docs/what-it-is.md",
            "docs/user-guide.md",
            "docs/vehicles.md",
            "docs/follow.md",
            "docs/outlet.md",
            "docs/troubleshooting.md",
        ),
    ),
    Section(
        "Languages",
        (
            Folder(
                "docs/guides",
                ("python", "typescript", "java", "php", "rest", "soap", "stream", "command-line"),
            ),
            Section(
                "Clients and examples",
                (
                    Named("Client for Python", "sdk-python/README.md"),
                    Named("Command line dronectl", "sdk-python/dronectl.md"),
                    Named("Client for TypeScript", "sdk-typescript/README.md"),
                    Named("Example in Java", "java-example/README.md"),
                    Named("Proxy and page in PHP", "php-soap-proxy/README.md"),
                ),
            ),
        ),
    ),
    Section(
        "Jobs",
        (
            Section(
                "Fly",
                (
                    "docs/jobs/first-flight.md",
                    "docs/jobs/see-the-fleet.md",
                    "docs/jobs/fly-a-drone.md",
                    "docs/jobs/control.md",
                    "docs/jobs/team.md",
                    "docs/jobs/missions.md",
                    "docs/jobs/cloud-loss.md",
                    "docs/jobs/zones.md",
                    "docs/jobs/follow-a-phone.md",
                    "docs/jobs/send-a-drone.md",
                    "docs/jobs/return-all.md",
                ),
            ),
            Section(
                "Several drones",
                (
                    "docs/jobs/several-drones.md",
                    "docs/jobs/mission-runs.md",
                    "docs/jobs/virtual-drones.md",
                ),
            ),
            Section(
                "Connect",
                (
                    "docs/jobs/connect-a-drone.md",
                    "docs/jobs/connect-a-robot.md",
                    "docs/jobs/simulated-drones.md",
                    "docs/jobs/secure-links.md",
                    "docs/jobs/ground-stations.md",
                    "docs/jobs/parameters-and-logs.md",
                ),
            ),
            Section(
                "Who may do what",
                (
                    "docs/jobs/users-and-roles.md",
                    "docs/jobs/grants.md",
                    "docs/jobs/access-keys.md",
                ),
            ),
            Section(
                "What happened",
                (
                    "docs/jobs/flights.md",
                    "docs/jobs/recordings.md",
                    "docs/jobs/activity-log.md",
                ),
            ),
            Folder("docs/jobs"),
        ),
    ),
    Section("Recipes", (Folder("docs/recipes", ("fly", "several-drones", "return-all", "flights", "events")),)),
    Section(
        "Reference",
        (
            Generated("reference"),
            "docs/problems.md",
            "docs/settings.md",
            "docs/times.md",
            "docs/events.md",
            "docs/stream.md",
            "docs/glossary.md",
        ),
    ),
    Section(
        "Operations",
        (
            Folder("docs/operations", ("install", "tls", "backup", "upgrade", "monitoring", "sizing")),
            "docs/archive.md",
            "signing-relay/README.md",
            "ros-bridge/README.md",
        ),
    ),
    Section("Security", ("docs/security.md",)),
    Section(
        "Architecture",
        (
            "docs/architecture.md",
            "docs/following.md",
            Section("How to add …", (Folder("docs/how-to-add", ("README",)),)),
            Section("Decisions", (Generated("adr"), Folder("docs/adr"))),
        ),
    ),
    Section(
        "Project",
        (
            "docs/testing.md",
            "docs/benchmarks.md",
            "docs/shortfalls.md",
            Named("Changes", "CHANGELOG.md"),
            "CONTRIBUTING.md",
            "bench/README.md",
            "web-client/README.md",
            "dronemap-sim/exchanges/README.md",
            "dronemap-sim/exchanges/planes.md",
            "docs/moved-tests.md",
            "dronemap-proxy/src/test/resources/org/dronemap/proxy/outlet/what-reaches-vehicles.md",
        ),
    ),
)


def navigation(sources: Sources, generated: dict[str, Nav]) -> tuple[Nav, list[str]]:
    """The navigation, and a fault for each page in no section; `generated`: by the address they lie below."""
    shown: set[str] = set()
    nav: Nav = []
    for section in SECTIONS:
        inner = list(_entries(section, sources, generated, shown))
        if inner:
            nav.append({section.title: inner})
    faults = [
        f"{path}:1: The page is in no section; name it or its folder in site/dronemap_site/navigation.py."
        for path in sources.pages
        if path not in shown
    ]
    return nav, faults


def _entries(
    section: Section, sources: Sources, generated: dict[str, Nav], shown: set[str]
) -> Iterator[str | dict[str, "str | Nav"]]:
    for entry in section.entries:
        match entry:
            case Section():
                inner = list(_entries(entry, sources, generated, shown))
                if inner:
                    yield {entry.title: inner}
            case Generated():
                yield from generated.get(entry.below, [])
            case Folder():
                paths = [path for path in _of_folder(entry, sources) if path not in shown]
                shown.update(paths)
                yield from (sources.pages[path] for path in paths)
            case Named() if entry.path in sources.pages:
                shown.add(entry.path)
                yield {entry.title: sources.pages[entry.path]}
            case str() if entry in sources.pages:
                shown.add(entry)
                yield sources.pages[entry]


def _of_folder(folder: Folder, sources: Sources) -> list[str]:
    paths = [path for path in sources.pages if path.startswith(f"{folder.path}/")]

    def place(path: str) -> tuple[int, str]:
        name = posixpath.splitext(posixpath.basename(path))[0]
        return (folder.first.index(name) if name in folder.first else len(folder.first), path)

    return sorted(paths, key=place)
