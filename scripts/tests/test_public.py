"""A server that is opened to the network, and closed again."""

import re
import ssl
import subprocess
import urllib.request
from pathlib import Path

from .conftest import Checkout
from .running import NEW_PASSWORD, descendants, get, listeners

WRONG_USE = 2
PASSWORD_MUST_CHANGE = 9


def make_certificates(folder: Path, *names: str) -> None:
    for name in names:
        subprocess.run(
            f"openssl req -x509 -newkey rsa:2048 -nodes -days 2 -subj /CN={name} "
            f"-keyout {name}.key -out {name}.pem",
            shell=True,
            cwd=folder,
            check=True,
            capture_output=True,
        )


def check_phone_page(built: Checkout, output: str) -> None:
    """It hands out who signed the certificate, by the fingerprint that the terminal shows."""
    port = built.settings["DRONEMAP_PHONE_PORT"]
    shown = re.search(rf"For phones: http://\S+:{port}/ \(fingerprint there: ([0-9A-F:]+)\)", output)
    assert shown, output
    status, page = get(f"http://127.0.0.1:{port}/")
    assert status == 200
    assert shown[1] in page
    tls = built.data / "tls"
    assert all(file.stat().st_mode & 0o077 == 0 for file in [tls, *tls.iterdir()])
    trusting = ssl.create_default_context(cafile=str(tls / "authority.pem"))
    url = f"https://localhost:{built.http_port}/api/v1/health"
    with urllib.request.urlopen(url, timeout=5, context=trusting) as answer:
        assert answer.status == 200


def check_own_certificate(built: Checkout, folder: Path) -> None:
    make_certificates(folder, "one", "two")
    own = ("up", "--no-demo", "--public", "--cert", str(folder / "one.pem"), "--key")
    mixed = built.run(*own, str(folder / "two.key"))
    assert mixed.returncode == WRONG_USE
    assert "do not belong together" in mixed.stderr
    matching = built.run(*own, str(folder / "one.key"))
    assert matching.returncode == 0, matching.stderr
    shown = ssl.get_server_certificate(("127.0.0.1", built.http_port))
    assert shown.strip() == (folder / "one.pem").read_text().strip()


def test_public_server_stays_closed_until_first_password_is_changed(built: Checkout, tmp_path: Path) -> None:
    never_started = built.run("up", "--public", "--no-demo")
    assert never_started.returncode == PASSWORD_MUST_CHANGE
    assert "Run ./dronemap up" in never_started.stderr

    assert built.run("up", "--no-demo").returncode == 0
    refused = built.run("up", "--public", "--no-demo")
    assert refused.returncode == PASSWORD_MUST_CHANGE
    assert "one-time password" in refused.stderr
    assert "./dronemap password" in refused.stderr

    too_short = built.run("password", text="short\n")
    assert too_short.returncode == 1
    assert "10" in too_short.stderr
    changed = built.run("password", text=NEW_PASSWORD + "\n")
    assert changed.returncode == 0, changed.stderr
    assert not (built.data / "first-password.txt").exists()

    public = built.run("up", "--public", "--no-demo")
    assert public.returncode == 0, public.stderr
    assert "Certificate (SHA-256)" in public.stdout
    status, page = get(f"https://127.0.0.1:{built.http_port}/")
    assert status == 200
    assert "<html" in page.lower()
    check_phone_page(built, public.stdout)
    addresses = listeners(descendants(built.data))
    assert any(re.match(rf"(0\.0\.0\.0|\*|\[::\]):{built.http_port}$", a) for a in addresses), addresses

    check_own_certificate(built, tmp_path)
    closed_again = built.run("up", "--no-demo")
    assert closed_again.returncode == 0, closed_again.stderr
    assert all("127." in a or "[::1]" in a for a in listeners(descendants(built.data)))
