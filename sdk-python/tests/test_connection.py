"""Which server, and which key: what is given, the environment, the file, this machine."""

from pathlib import Path

import pytest

from dronemap import NotConfigured, find_server

AWAY = "https://drones.example:8080"


@pytest.fixture
def file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    config = tmp_path / "config.toml"
    config.write_text(f'[default]\nurl = "{AWAY}"\nkey = "kept"\n[lab]\nurl = "http://lab:1"\nkey = "labs"\n')
    config.chmod(0o600)
    return config


def test_arguments_go_before_the_environment_and_that_before_the_file(file: Path) -> None:
    environment = {"DRONEMAP_CONFIG": str(file)}
    assert find_server(environment=environment).key == "kept"
    assert find_server(environment=environment).url == AWAY
    environment |= {"DRONEMAP_KEY": "named", "DRONEMAP_URL": "http://named:2/"}
    found = find_server(environment=environment)
    assert (found.url, found.key) == ("http://named:2", "named")
    assert find_server("http://given:3", "given", environment=environment).key == "given"


def test_key_of_the_file_is_not_sent_to_another_server(file: Path) -> None:
    with pytest.raises(NotConfigured, match="No access key for http://elsewhere:1"):
        find_server("http://elsewhere:1", environment={"DRONEMAP_CONFIG": str(file)})
    with pytest.raises(NotConfigured, match="No access key for http://elsewhere:1"):
        find_server(environment={"DRONEMAP_CONFIG": str(file), "DRONEMAP_URL": "http://elsewhere:1"})


def test_profiles(file: Path) -> None:
    environment = {"DRONEMAP_CONFIG": str(file)}
    assert find_server(profile="lab", environment=environment).key == "labs"
    assert find_server(environment=environment | {"DRONEMAP_PROFILE": "lab"}).url == "http://lab:1"
    with pytest.raises(NotConfigured, match="no profile 'field'; it has default, lab"):
        find_server(profile="field", environment=environment)


def test_file_that_others_may_read_is_refused(file: Path) -> None:
    file.chmod(0o644)
    with pytest.raises(NotConfigured, match="chmod 600"):
        find_server(environment={"DRONEMAP_CONFIG": str(file)})


def test_server_of_this_machine_has_put_its_key_into_the_checkout(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / ".data").mkdir()
    (tmp_path / ".data" / "local-key").write_text("local\n")
    (tmp_path / "below").mkdir()
    monkeypatch.chdir(tmp_path / "below")
    nothing = {"DRONEMAP_CONFIG": str(tmp_path / "none")}
    assert find_server(environment=nothing).key == "local"
    monkeypatch.chdir("/")
    with pytest.raises(NotConfigured, match="run in the folder of the server's checkout"):
        find_server(environment=nothing)
    assert find_server(environment=nothing | {"DRONEMAP_DATA_DIR": str(tmp_path / ".data")}).key == "local"
    with pytest.raises(NotConfigured, match="No access key"):
        find_server(AWAY, environment=nothing)


@pytest.mark.parametrize("wrong", ["drones.example", "ftp://x", "http://x/api"])
def test_address_that_is_none(wrong: str, file: Path) -> None:
    with pytest.raises(NotConfigured, match="must be like https://"):
        find_server(wrong, "key", environment={"DRONEMAP_CONFIG": str(file)})


def test_key_is_not_shown(file: Path) -> None:
    assert "kept" not in repr(find_server(environment={"DRONEMAP_CONFIG": str(file)}))
