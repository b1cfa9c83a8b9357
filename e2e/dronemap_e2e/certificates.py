"""Makes the server's certificate, and has a browser trust it, as the guide describes."""

import subprocess
from pathlib import Path

from .server import ROOT

NAME = "drones.test"
# As the one script sets them up before it makes certificates.
SIGN = """
set -euo pipefail
source "$1/scripts/lib/say.sh"
source "$1/scripts/lib/tls.sh"
DATA=$2 TOOLS=$2 LOOPBACK=127.0.0.1
generate_certificate
"""


def make_certificate(folder: Path) -> dict[str, str]:
    """Makes certificates as `./dronemap up --public` does; returns the server's settings."""
    (folder / "logs").mkdir(parents=True)
    subprocess.run(
        ["bash", "-c", SIGN, "bash", str(ROOT), str(folder)],
        check=True,
        env={"PATH": "/usr/bin:/bin:/usr/sbin:/sbin", "DRONEMAP_NAMES": NAME},
        stdout=subprocess.DEVNULL,
    )
    tls = folder / "tls"
    return {
        "DRONEMAP_TLS_CERT": str(tls / "certificate.pem"),
        "DRONEMAP_TLS_KEY": str(tls / "key.pem"),
        "DRONEMAP_TLS_AUTHORITY": str(tls / "authority.pem"),
    }


def trust_certificate(home: Path, certificate: Path) -> None:
    """Adds a certificate to a browser's authorities, as a person does in its settings."""
    store = home / ".pki" / "nssdb"
    store.mkdir(parents=True, exist_ok=True)
    database = ["-d", f"sql:{store}"]
    subprocess.run(["certutil", "-N", "--empty-password", *database], check=True)
    subprocess.run(
        ["certutil", "-A", *database, "-n", "Dronemap", "-t", "C,,", "-i", str(certificate)], check=True
    )
