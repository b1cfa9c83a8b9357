"""Checkouts of the project's own in which the one script can be run, and broken, freely."""

import os
import shutil
import signal
import socket
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
JARS = ("dronemap-ws/target/dronemap.jar", "dronemap-sim/target/dronemap-sim.jar")

needs_root = pytest.mark.skipif(
    os.geteuid() != 0, reason="mounts, namespaces and other users need root rights"
)


@pytest.fixture(scope="session", autouse=True)
def interruptible() -> Iterator[None]:
    """A shell lets what it runs in the background ignore interruptions, and children would inherit that."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def free_port(kind: int = socket.SOCK_STREAM) -> int:
    with socket.socket(socket.AF_INET, kind) as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


@dataclass
class Checkout:
    """One checkout with ports and data of its own."""

    path: Path
    settings: dict[str, str] = field(default_factory=dict)

    @property
    def data(self) -> Path:
        return Path(self.settings.get("DRONEMAP_DATA_DIR", str(self.path / ".data")))

    @property
    def http_port(self) -> int:
        return int(self.settings["DRONEMAP_HTTP_PORT"])

    def environment(self, **more: str) -> dict[str, str]:
        inherited = {name: value for name, value in os.environ.items() if not name.startswith("DRONEMAP_")}
        return inherited | self.settings | more

    def run(
        self,
        *arguments: str,
        before: tuple[str, ...] = (),
        seconds: float = 300,
        text: str = "",
        **more: str,
    ) -> subprocess.CompletedProcess[str]:
        """Runs ./dronemap; `before` are words in front of it, such as those of unshare."""
        return subprocess.run(
            [*before, str(self.path / "dronemap"), *arguments],
            env=self.environment(**more),
            input=text,
            text=True,
            capture_output=True,
            timeout=seconds,
            check=False,
        )

    def inside(self, *commands: str) -> str:
        """Runs shell lines with the script's own functions at hand."""
        parts = " ".join(f". {self.path}/scripts/lib/{part}.sh;" for part in ("say", "settings", "build"))
        return subprocess.run(
            ["bash", "-c", f"ROOT={self.path}; {parts} {'; '.join(commands)}"],
            text=True,
            capture_output=True,
            check=True,
        ).stdout.strip()


def copy_tree(target: Path) -> None:
    """The files of this checkout that belong to the project, changed ones as they are."""
    listed = subprocess.run(
        ["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=ROOT, capture_output=True, check=True
    )
    for name in listed.stdout.decode().split("\0"):
        source = ROOT / name
        if name and source.is_file():
            copied = target / name
            copied.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(source, copied)


@pytest.fixture
def checkout(tmp_path: Path) -> Iterator[Checkout]:
    """Sources only: nothing built, nothing downloaded."""
    path = tmp_path / "checkout"
    copy_tree(path)
    made = Checkout(
        path,
        {
            "DRONEMAP_HTTP_PORT": str(free_port()),
            "DRONEMAP_STREAM_PORT": str(free_port()),
            "DRONEMAP_PHONE_PORT": str(free_port()),
            "DRONEMAP_MAVLINK_UDP": str(free_port(socket.SOCK_DGRAM)),
            "DRONEMAP_MAVLINK_TCP": str(free_port()),
        },
    )
    yield made
    made.run("down")
    shutil.rmtree(path, ignore_errors=True)


@pytest.fixture
def built(checkout: Checkout) -> Checkout:
    """A checkout whose jars are the ones that the Java tests were run on."""
    app = checkout.path / ".tools" / "app"
    app.mkdir(parents=True)
    for jar in JARS:
        assert (ROOT / jar).exists(), f"{jar} is missing: build first (./dronemap test does)"
        shutil.copy2(ROOT / jar, app)
    (app / "jars.stamp").write_text(checkout.inside("hash_of_sources") + "\n")
    return checkout
