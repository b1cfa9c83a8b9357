"""The container files: valid by the compose specification, and made of the same steps as any machine."""

import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from .conftest import ROOT

COMPOSE = ROOT / "docker" / "compose.yaml"


def schema_errors(file: Path) -> subprocess.CompletedProcess[str]:
    checker = Path(sys.executable).with_name("check-jsonschema")
    return subprocess.run(
        [checker, "--builtin-schema", "vendor.compose-spec", file],
        text=True,
        capture_output=True,
        check=False,
    )


def test_compose_file_is_valid() -> None:
    outcome = schema_errors(COMPOSE)
    assert outcome.returncode == 0, outcome.stdout + outcome.stderr


@pytest.mark.parametrize("planted", ["  server:\n    ports: 8080\n", "  server:\n    immage: debian\n"])
def test_compose_schema_finds_planted_mistake(tmp_path: Path, planted: str) -> None:
    broken = tmp_path / "compose.yaml"
    broken.write_text("services:\n" + planted)
    assert schema_errors(broken).returncode != 0


def test_compose_file_publishes_on_loopback_only() -> None:
    services = yaml.safe_load(COMPOSE.read_text())["services"]
    assert set(services) == {"server", "php", "postgres", "mongo", "sitl"}
    published = [port for service in services.values() for port in service.get("ports", [])]
    assert published
    assert all(port.startswith("127.0.0.1:") for port in published)


def test_container_is_made_by_the_same_steps() -> None:
    lines = (ROOT / "docker" / "Dockerfile").read_text().splitlines()
    assert [line for line in lines if line.startswith("RUN ")] == ["RUN ./dronemap build \\"]
    assert 'ENTRYPOINT ["./dronemap"]' in lines
    assert 'CMD ["up", "--foreground"]' in lines
