"""The records of a server: kept in a backup, brought back, and verified."""

import hashlib
import json
import re
import stat
import zipfile
from pathlib import Path

from .conftest import Checkout
from .running import NEW_PASSWORD, call_rest

WRONG_USE = 2
RECORDS_CHANGED = 10
DEED = "a deed to be found"


def test_restore_brings_back_backup(built: Checkout, tmp_path: Path) -> None:
    assert built.run("up", "--no-demo").returncode == 0
    assert built.run("password", text=NEW_PASSWORD + "\n").returncode == 0
    receipt = download_receipt(built, tmp_path)
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
    check_changed_receipt_is_found(built, receipt)
    assert built.run("down").returncode == 0
    check_records(built, receipt)
    unsure = built.run("restore", str(backup))
    assert unsure.returncode == WRONG_USE
    assert "--yes" in unsure.stderr

    records_key = (built.data / "audit-key").read_bytes()
    built.settings["DRONEMAP_DATA_DIR"] = str(tmp_path / "other")
    built.data.mkdir(mode=0o700)
    (built.data / "audit-key").write_bytes(records_key)
    restored = built.run("restore", str(backup))
    assert restored.returncode == 0, restored.stderr
    check_records(built, receipt)
    check_changed_record_is_found(built, backup, receipt)
    check_broken_backup_changes_nothing(built, backup)
    assert built.run("up", "--no-demo").returncode == 0
    assert not (built.data / "first-password.txt").exists(), "the restored administrator has a password"
    still_known = built.run("password", text=f"{NEW_PASSWORD}\nanother long phrase\n")
    assert still_known.returncode == 0, still_known.stderr


def download_receipt(built: Checkout, folder: Path) -> Path:
    """For all that was done up to now, a deed of a known name among it."""
    call_rest(built, "/invitations", {"label": DEED, "role": "viewer"})
    receipt = folder / "receipt.json"
    receipt.write_text(call_rest(built, "/audit/receipt"))
    check_records(built, receipt)
    return receipt


def check_records(built: Checkout, receipt: Path) -> None:
    for given in ((), ("--receipt", str(receipt))):
        sound = built.run("verify-audit", *given)
        assert sound.returncode == 0, sound.stderr
        assert re.search(r"\d+ records", sound.stdout + sound.stderr), sound


def check_changed_receipt_is_found(built: Checkout, receipt: Path) -> None:
    receipt_json = json.loads(receipt.read_text())
    forged = receipt.with_name("forged.json")
    forged.write_text(json.dumps(receipt_json | {"hash": receipt_json["hash"][:-1] + "x"}))
    outcome = built.run("verify-audit", "--receipt", str(forged))
    assert outcome.returncode == RECORDS_CHANGED, outcome.stderr


def check_changed_record_is_found(built: Checkout, backup: Path, receipt: Path) -> None:
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
    check_records(built, receipt)


def check_broken_backup_changes_nothing(built: Checkout, backup: Path) -> None:
    cut = backup.with_name("cut.zip")
    cut.write_bytes(backup.read_bytes()[: backup.stat().st_size // 2])
    outcome = built.run("restore", str(cut), "--yes")
    assert outcome.returncode == 1, outcome.stderr
    assert "not restored" in outcome.stderr
    assert "INFO" not in outcome.stderr, "it says why, not what Java noted on its way"
