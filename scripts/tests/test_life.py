"""The life of a server under the one script: start, start again, public, crash, backup, stop."""

import hashlib
import json
import os
import re
import signal
import ssl
import stat
import subprocess
import time
import urllib.request
import zipfile
from pathlib import Path

import pytest

from .conftest import Checkout

WRONG_USE = 2
RECORDS_CHANGED = 10
PASSWORD_MUST_CHANGE = 9
SECOND_UP_SECONDS = 30
MOST_MEGABYTES = 600
DEED = "a deed to be found"
NEW_PASSWORD = 'a "new" \\ pass phrase'


def listeners(pids: set[int]) -> list[str]:
    """Local addresses on which processes listen or receive."""
    lines = subprocess.run(["ss", "-Hltnup"], text=True, capture_output=True, check=True).stdout.splitlines()
    return [line.split()[4] for line in lines if pids & {int(pid) for pid in re.findall(r"pid=(\d+)", line)}]


def descendants(data: Path) -> set[int]:
    """The server, the demo fleet and everything that they started, by the data folder that they work in."""
    found = set()
    for process in Path("/proc").glob("[0-9]*"):
        try:
            in_data = (process / "cwd").readlink().is_relative_to(data)
        except OSError:
            continue
        if in_data:
            found.add(int(process.name))
    return found


def get(url: str) -> tuple[int, str]:
    own_certificate = ssl.create_default_context()
    own_certificate.check_hostname = False
    own_certificate.verify_mode = ssl.CERT_NONE
    with urllib.request.urlopen(url, timeout=5, context=own_certificate) as answer:
        return answer.status, answer.read().decode()


def pid_of(checkout: Checkout, name: str) -> int:
    return int((checkout.data / f"{name}.pid").read_text())


def test_up_ends_with_a_page_and_a_drone_that_can_be_armed(built: Checkout) -> None:
    outcome = built.run("up")
    assert outcome.returncode == 0, outcome.stderr
    address = f"http://127.0.0.1:{built.http_port}"
    assert f"Dronemap is ready: {address}" in outcome.stdout
    assert "one-time password" in outcome.stdout
    assert "<html" in get(address)[1].lower()
    health = json.loads(get(f"{address}/api/v1/health")[1])
    assert health["status"] == "up"
    assert health["drones"]["ready"] >= 1
    check_that_a_demo_drone_can_be_armed(built)
    assert resident_megabytes(pid_of(built, "server")) < MOST_MEGABYTES

    check_secrets(built.data)
    own = descendants(built.data)
    assert {pid_of(built, "server"), pid_of(built, "sim")} <= own
    addresses = listeners(own)
    assert any(address.endswith(f":{built.http_port}") for address in addresses)
    off_loopback = [a for a in addresses if not re.match(r"(127\.|\[::1\]|\[::ffff:127\.)", a)]
    assert off_loopback == []

    server = pid_of(built, "server")
    started = time.monotonic()
    again = built.run("up")
    assert again.returncode == 0
    assert time.monotonic() - started < SECOND_UP_SECONDS
    assert pid_of(built, "server") == server, "a second up must leave the running server alone"

    status = built.run("status")
    assert status.returncode == 0
    assert address in status.stdout
    assert built.run("logs").returncode == 0
    # The first one has disarmed itself by now, or has not.
    check_that_a_demo_drone_can_be_armed(built)
    down = built.run("down")
    assert down.returncode == 0
    assert re.search(r"Armed when last heard: [12]\.", down.stderr)
    assert descendants(built.data) == set()
    assert built.run("status").returncode == 1


def check_that_a_demo_drone_can_be_armed(built: Checkout) -> None:
    """At once, for that is what "ready" promises: by the drone's own word and by its deed."""
    drones = json.loads(ask(built, "/drones"))["drones"]
    may = [drone for drone in drones if drone["readyToArm"] and drone["actions"]["arm"]["allowed"]]
    assert may, [(drone["name"], drone["readyToArm"], drone["messages"]) for drone in drones]
    command = json.loads(ask(built, f"/drones/{may[0]['id']}/commands?wait=20", {"type": "arm"}))
    assert command["outcome"]["result"] == "succeeded", command


def ask(built: Checkout, path: str, body: dict[str, str] | None = None) -> str:
    """An answer of REST to this machine's own key; with a body it is a POST."""
    key = (built.data / "local-key").read_text().strip()
    request = urllib.request.Request(
        f"http://127.0.0.1:{built.http_port}/api/v1{path}",
        data=None if body is None else json.dumps(body).encode(),
        headers={"Authorization": f"Bearer {key}", "Content-Type": "application/json"},
    )
    with urllib.request.urlopen(request, timeout=30) as answer:
        text: str = answer.read().decode()
    return text


def resident_megabytes(pid: int) -> float:
    status = Path(f"/proc/{pid}/status").read_text()
    return int(re.findall(r"VmRSS:\s+(\d+)", status)[0]) / 1024


def check_secrets(data: Path) -> None:
    for name in ("first-password.txt", "local-key"):
        mode = stat.S_IMODE((data / name).stat().st_mode)
        assert mode == 0o600, f"{name} has mode {mode:o}"
    assert stat.S_IMODE(data.stat().st_mode) & 0o077 == 0


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


def check_page_for_phones(built: Checkout, told: str) -> None:
    """It hands out who signed the certificate, by the fingerprint that the terminal shows."""
    port = built.settings["DRONEMAP_PHONE_PORT"]
    shown = re.search(rf"For phones: http://\S+:{port}/ \(fingerprint there: ([0-9A-F:]+)\)", told)
    assert shown, told
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


def test_stays_closed_to_the_network_until_the_first_password_is_changed(
    built: Checkout, tmp_path: Path
) -> None:
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
    check_page_for_phones(built, public.stdout)
    addresses = listeners(descendants(built.data))
    assert any(re.match(rf"(0\.0\.0\.0|\*|\[::\]):{built.http_port}$", a) for a in addresses), addresses

    check_own_certificate(built, tmp_path)
    closed_again = built.run("up", "--no-demo")
    assert closed_again.returncode == 0, closed_again.stderr
    assert all("127." in a or "[::1]" in a for a in listeners(descendants(built.data)))


def test_a_killed_server_leaves_nothing_that_hinders_the_next_start(built: Checkout) -> None:
    begun = time.monotonic()
    assert built.run("up").returncode == 0
    first = time.monotonic() - begun
    os.kill(pid_of(built, "server"), signal.SIGKILL)
    started = time.monotonic()
    again = built.run("up")
    assert again.returncode == 0, again.stderr
    # A busy machine starts nothing in half a minute; what hinders would show beside the first start on it.
    assert time.monotonic() - started < max(SECOND_UP_SECONDS, first)
    os.kill(pid_of(built, "server"), signal.SIGKILL)
    assert built.run("down").returncode == 0
    assert descendants(built.data) == set()


def test_what_was_backed_up_is_there_after_a_restore(built: Checkout, tmp_path: Path) -> None:
    assert built.run("up", "--no-demo").returncode == 0
    assert built.run("password", text=NEW_PASSWORD + "\n").returncode == 0
    receipt = take_a_receipt(built, tmp_path)
    backup = tmp_path / "backup.zip"
    made = built.run("backup", str(backup))
    assert made.returncode == 0, made.stderr
    assert stat.S_IMODE(backup.stat().st_mode) == 0o600
    again = built.run("backup", str(backup))
    assert again.returncode == 1
    assert "exists already" in again.stderr
    running = built.run("restore", str(backup), "--yes")
    assert running.returncode == 1
    assert "Stop it with ./dronemap down" in running.stderr
    check_that_a_changed_receipt_shows(built, receipt)
    assert built.run("down").returncode == 0
    check_the_records(built, receipt)
    unsure = built.run("restore", str(backup))
    assert unsure.returncode == WRONG_USE
    assert "--yes" in unsure.stderr

    records_key = (built.data / "audit-key").read_bytes()
    built.settings["DRONEMAP_DATA_DIR"] = str(tmp_path / "other")
    built.data.mkdir(mode=0o700)
    (built.data / "audit-key").write_bytes(records_key)
    restored = built.run("restore", str(backup))
    assert restored.returncode == 0, restored.stderr
    check_the_records(built, receipt)
    check_that_a_changed_record_shows(built, backup, receipt)
    check_that_a_broken_backup_changes_nothing(built, backup)
    assert built.run("up", "--no-demo").returncode == 0
    assert not (built.data / "first-password.txt").exists(), "the restored administrator has a password"
    still_known = built.run("password", text=f"{NEW_PASSWORD}\nanother long phrase\n")
    assert still_known.returncode == 0, still_known.stderr


def take_a_receipt(built: Checkout, folder: Path) -> Path:
    """For all that was done up to now, a deed of a known name among it."""
    ask(built, "/invitations", {"label": DEED, "role": "viewer"})
    receipt = folder / "receipt.json"
    receipt.write_text(ask(built, "/audit/receipt"))
    check_the_records(built, receipt)
    return receipt


def check_the_records(built: Checkout, receipt: Path) -> None:
    for given in ((), ("--receipt", str(receipt))):
        sound = built.run("verify-audit", *given)
        assert sound.returncode == 0, sound.stderr
        assert re.search(r"\d+ records", sound.stdout + sound.stderr), sound


def check_that_a_changed_receipt_shows(built: Checkout, receipt: Path) -> None:
    said = json.loads(receipt.read_text())
    forged = receipt.with_name("forged.json")
    forged.write_text(json.dumps(said | {"hash": said["hash"][:-1] + "x"}))
    outcome = built.run("verify-audit", "--receipt", str(forged))
    assert outcome.returncode == RECORDS_CHANGED, outcome.stderr


def check_that_a_changed_record_shows(built: Checkout, backup: Path, receipt: Path) -> None:
    """One word of it, by somebody who can make a backup look whole."""
    changed = backup.with_name("changed.zip")
    with zipfile.ZipFile(backup) as before, zipfile.ZipFile(changed, "w") as after:
        records = before.read("audit.csv").replace(DEED.encode(), DEED.upper().encode())
        assert records != before.read("audit.csv")
        manifest = json.loads(before.read("manifest.json"))
        for table in manifest["tables"]:
            if table["name"] == "audit":
                table["sha256"] = hashlib.sha256(records).hexdigest()
        for name in before.namelist():
            now = {"audit.csv": records, "manifest.json": json.dumps(manifest).encode()}
            after.writestr(name, now.get(name, before.read(name)))
    assert built.run("restore", str(changed), "--yes").returncode == 0
    outcome = built.run("verify-audit", "--receipt", str(receipt))
    assert outcome.returncode == RECORDS_CHANGED, outcome.stderr
    assert re.search(r"Record \d+ was changed", outcome.stderr), outcome.stderr
    assert built.run("restore", str(backup), "--yes").returncode == 0
    check_the_records(built, receipt)


def check_that_a_broken_backup_changes_nothing(built: Checkout, backup: Path) -> None:
    cut = backup.with_name("cut.zip")
    cut.write_bytes(backup.read_bytes()[: backup.stat().st_size // 2])
    outcome = built.run("restore", str(cut), "--yes")
    assert outcome.returncode == 1, outcome.stderr
    assert "not restored" in outcome.stderr
    assert "INFO" not in outcome.stderr, "it says why, not what Java noted on its way"


@pytest.mark.skipif("DRONEMAP_TEST_DATA" not in os.environ, reason="DRONEMAP_TEST_DATA is not set")
def test_replays_a_recording_and_cancels_it_on_interruption(built: Checkout) -> None:
    recordings = sorted(
        Path(os.environ["DRONEMAP_TEST_DATA"]).glob("tlogs/*.tlog"), key=lambda f: f.stat().st_size
    )
    assert built.run("up", "--no-demo").returncode == 0
    finished = built.run("replay", str(recordings[0]), "--speed", "100")
    assert finished.returncode == 0, finished.stderr
    assert "good messages" in finished.stdout

    replay = subprocess.Popen(
        [built.path / "dronemap", "replay", recordings[-1], "--speed", "1"],
        env=built.environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert replay.stdout is not None
    while "drones:" not in replay.stdout.readline():
        assert replay.poll() is None
    replay.send_signal(signal.SIGINT)
    replay.communicate(timeout=20)
    assert replay.returncode == 130
    states = [replay["state"] for replay in json.loads(ask(built, "/replays"))["replays"]]
    assert sorted(states) == ["cancelled", "finished"]
