"""Which server to ask, and with which key: from arguments, the environment or a file."""

import os
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

from dronemap.errors import NotConfigured

_LOCAL = "http://127.0.0.1:8080"
_LOCAL_KEY = "local-key"
_OTHERS_MAY_READ = 0o077


@dataclass(frozen=True)
class Server:
    """A server: its address without a path, an access key, and the file of an authority to trust in addition.

    A server makes a new key for its own machine at each start: `key_file` is where the newest one is.
    """

    url: str
    key: str | None
    certificate: str | None = None
    key_file: Path | None = None

    def __repr__(self) -> str:
        return f"Server(url={self.url!r})"


def find_server(
    url: str | None = None,
    key: str | None = None,
    *,
    certificate: str | None = None,
    profile: str | None = None,
    environment: Mapping[str, str] | None = None,
) -> Server:
    """What is given first, then DRONEMAP_URL, DRONEMAP_KEY and DRONEMAP_CERTIFICATE, then the file.

    The file is ~/.config/dronemap/config.toml (or DRONEMAP_CONFIG), with `url`, `key` and `certificate` below the name
    of a profile: `default`, or what `profile` or DRONEMAP_PROFILE say. With none of them it is the server on this
    machine, and the key that it has put into its data folder: DRONEMAP_DATA_DIR, or `.data` in the folder where the
    program runs or one above it.
    """
    environment = os.environ if environment is None else environment
    kept = _profile(profile or environment.get("DRONEMAP_PROFILE"), environment)
    address = url or environment.get("DRONEMAP_URL") or kept.get("url") or _LOCAL
    host = _host(address)
    found = key or environment.get("DRONEMAP_KEY")
    if found is None and address == kept.get("url", address):
        found = kept.get("key")
    file = None
    is_local = host in ("127.0.0.1", "localhost", "::1")
    if found is None and is_local:
        file = _local_key_file(environment)
        found = None if file is None else read_key(file)
    if found is None:
        local = " Or run in the folder of the server's checkout, or name its DRONEMAP_DATA_DIR." if is_local else ""
        raise NotConfigured(
            f"No access key for {address}. Make one on the page (Account, Access keys) and give it as DRONEMAP_KEY, "
            f"or as key in {_file(environment)}.{local}"
        )
    trusted = certificate or environment.get("DRONEMAP_CERTIFICATE") or kept.get("certificate")
    return Server(address.rstrip("/"), found, trusted, file)


def _host(address: str) -> str:
    parts = urlsplit(address)
    if parts.scheme not in ("http", "https") or parts.hostname is None or parts.path.strip("/"):
        raise NotConfigured(f"'{address}' is no address of a server; it must be like https://drones.example:8080.")
    return parts.hostname


def _file(environment: Mapping[str, str]) -> Path:
    if "DRONEMAP_CONFIG" in environment:
        return Path(environment["DRONEMAP_CONFIG"])
    folder = environment.get("XDG_CONFIG_HOME") or Path.home() / ".config"
    return Path(folder) / "dronemap" / "config.toml"


def _profile(name: str | None, environment: Mapping[str, str]) -> dict[str, str]:
    file = _file(environment)
    if not file.exists():
        if name is not None:
            raise NotConfigured(f"There is no profile '{name}': {file} does not exist.")
        return {}
    try:
        profiles: dict[str, Any] = tomllib.loads(file.read_text())
    except tomllib.TOMLDecodeError as e:
        raise NotConfigured(f"{file} cannot be read: {e}") from e
    found = profiles.get(name or "default")
    if not isinstance(found, dict):
        if name is None:
            return {}
        raise NotConfigured(f"{file} has no profile '{name}'; it has {', '.join(profiles) or 'none'}.")
    if "key" in found and file.stat().st_mode & _OTHERS_MAY_READ:
        raise NotConfigured(f"Others may read {file}, which holds an access key: chmod 600 {file}")
    return {str(k): str(v) for k, v in found.items()}


def read_key(file: Path) -> str:
    return file.read_text().strip()


def _local_key_file(environment: Mapping[str, str]) -> Path | None:
    named = environment.get("DRONEMAP_DATA_DIR")
    folders = [Path(named)] if named else [folder / ".data" for folder in (Path.cwd(), *Path.cwd().parents)]
    files = [folder / _LOCAL_KEY for folder in folders]
    return next((file for file in files if file.is_file() and os.access(file, os.R_OK)), None)
