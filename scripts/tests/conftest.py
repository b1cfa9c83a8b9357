"""Checkouts of the project's own in which the one script can be run, and broken, freely."""

import contextlib
import os
import random
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
SOON = "-XX:TieredStopAtLevel=1"
# The files that take longest begin first, or one process is still at them when the others have nothing left.
LONGEST = ("test_life", "test_records", "test_full_disk", "test_public", "test_trouble", "test_trials")
# Below those of the end-to-end tests, and those (from 32768 on) that systems give to whoever asks for any.
LOWEST_PORT, HIGHEST_PORT = 15_600, 20_000
WORKERS = int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", "1"))
WORKER = int(os.environ.get("PYTEST_XDIST_WORKER", "gw0").removeprefix("gw"))

_given: set[int] = set()

needs_root = pytest.mark.skipif(
    os.geteuid() != 0, reason="mounts, namespaces and other users need root rights"
)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    places = {name: place for place, name in enumerate(LONGEST)}
    items.sort(key=lambda item: places.get(item.path.stem, len(LONGEST)))


@pytest.fixture(scope="session", autouse=True)
def interruptible() -> Iterator[None]:
    """A shell lets what it runs in the background ignore interruptions, and children would inherit that."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@contextlib.contextmanager
def small_disk(folder: Path, size: str) -> Iterator[Path]:
    """A disk of its own that is full soon."""
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", folder], check=True)
    try:
        yield folder
    finally:
        subprocess.run(["umount", "--lazy", folder], check=True)


def free_port(kind: int = socket.SOCK_STREAM) -> int:
    """None that a system gives to whoever asks for any: a server started again must find its port free."""
    while True:
        port = random.randrange(LOWEST_PORT + WORKER, HIGHEST_PORT, WORKERS)
        with socket.socket(socket.AF_INET, kind) as probe:
            try:
                probe.bind(("0.0.0.0", port))
            except OSError:
                continue
        if port not in _given:
            _given.add(port)
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
    names = [name for name in listed.stdout.split(b"\0") if name and (ROOT / os.fsdecode(name)).is_file()]
    copy: list[str | Path] = ["xargs", "-0", "cp", "--archive", "--parents", "--target-directory", target]
    target.mkdir(parents=True, exist_ok=True)
    subprocess.run(copy, cwd=ROOT, input=b"\0".join(names), check=True)


def copied(folder: Path, target: Path) -> Path:
    subprocess.run(["cp", "--archive", folder, target], check=True)
    return target


def on_free_ports(path: Path, **settings: str) -> Checkout:
    ports = {
        "DRONEMAP_HTTP_PORT": str(free_port()),
        "DRONEMAP_STREAM_PORT": str(free_port()),
        "DRONEMAP_PHONE_PORT": str(free_port()),
        "DRONEMAP_PHP_PORT": str(free_port()),
        "DRONEMAP_MAVLINK_UDP": str(free_port(socket.SOCK_DGRAM)),
        "DRONEMAP_MAVLINK_TCP": str(free_port()),
    }
    return Checkout(path, ports | settings)


@pytest.fixture(scope="session")
def sources(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Sources only: nothing built, nothing downloaded."""
    path = tmp_path_factory.mktemp("sources") / "checkout"
    copy_tree(path)
    return path


@pytest.fixture(scope="session")
def shared_sources(sources: Path) -> Path:
    return copied(sources, sources.parent / "shared")


@pytest.fixture
def untouched(shared_sources: Path, tmp_path: Path) -> Checkout:
    """Sources that tests share: for what neither builds, nor changes a file, nor starts a server."""
    return on_free_ports(shared_sources, DRONEMAP_DATA_DIR=str(tmp_path / "data"))


@pytest.fixture
def checkout(sources: Path, tmp_path: Path) -> Iterator[Checkout]:
    """Sources of the test's own, to be built and broken."""
    path = copied(sources, tmp_path / "checkout")
    made = on_free_ports(path)
    yield made
    made.run("down")
    shutil.rmtree(path, ignore_errors=True)


@pytest.fixture(scope="session")
def with_jars(sources: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A checkout that tests share, whose jars are the ones that the Java tests were run on."""
    path = copied(sources, tmp_path_factory.mktemp("built") / "checkout")
    app = path / ".tools" / "app"
    app.mkdir(parents=True)
    for jar in JARS:
        assert (ROOT / jar).exists(), f"{jar} is missing: build first (./dronemap test does)"
        shutil.copy2(ROOT / jar, app)
    (app / "jars.stamp").write_text(Checkout(path).inside("hash_of_sources") + "\n")
    return path


@pytest.fixture
def built(with_jars: Path, tmp_path: Path) -> Iterator[Checkout]:
    """Built, with data of the test's own; its servers start soon instead of running fast later."""
    data = tmp_path / "data"
    made = on_free_ports(with_jars, DRONEMAP_DATA_DIR=str(data), DRONEMAP_JAVA_OPTS=SOON)
    yield made
    made.run("down")
    shutil.rmtree(made.data, ignore_errors=True)
    shutil.rmtree(data, ignore_errors=True)
