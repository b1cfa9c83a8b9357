"""Faults of real machines: each gets its exit code and a sentence that says what to do."""

import contextlib
import os
import select
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path
from typing import IO

import pytest

from .conftest import Checkout, copy_tree, needs_root, small_disk
from .waiting import until

USAGE, RIGHTS, PORT, DISK, NETWORK, START = 2, 3, 4, 5, 6, 8
INTERRUPTED = 130
NOBODY = 65534


def read_until(output: IO[bytes], text: str, seconds: float) -> str:
    """Reads a program's output up to that text, as soon as it is there."""
    deadline = time.monotonic() + seconds
    printed = ""
    while text not in printed:
        left = max(0.0, deadline - time.monotonic())
        assert select.select([output], [], [], left)[0], f"no '{text}' within {seconds} s: {printed}"
        piece = os.read(output.fileno(), 65_536).decode(errors="replace")
        assert piece, f"it ended without '{text}': {printed}"
        printed += piece
    return printed


def processes_of(folder: Path) -> list[str]:
    """Command lines of all processes that work in a folder or name it."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            line = (process / "cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace")
            if str(folder) in line or (process / "cwd").readlink().is_relative_to(folder):
                found.append(line)
    return found


@pytest.mark.parametrize(
    ("setting", "kind", "use"),
    [
        ("DRONEMAP_HTTP_PORT", socket.SOCK_STREAM, "the page"),
        ("DRONEMAP_STREAM_PORT", socket.SOCK_STREAM, "the stream"),
        ("DRONEMAP_MAVLINK_UDP", socket.SOCK_DGRAM, "vehicles (udp)"),
        ("DRONEMAP_MAVLINK_TCP", socket.SOCK_STREAM, "vehicles (tcp)"),
    ],
)
def test_port_in_use_is_reported_with_its_process(
    untouched: Checkout, setting: str, kind: int, use: str
) -> None:
    port = untouched.settings[setting]
    with socket.socket(socket.AF_INET, kind) as holder:
        holder.bind(("127.0.0.1", int(port)))
        if kind == socket.SOCK_STREAM:
            holder.listen()
        outcome = untouched.run("up", "--no-demo")
    assert outcome.returncode == PORT, outcome.stderr
    assert f"Port {port}" in outcome.stderr
    assert f"needed for {use}" in outcome.stderr
    assert f"(process {os.getpid()})" in outcome.stderr
    assert f"{setting}=" in outcome.stderr


def allow_reading(path: Path) -> None:
    for folder in (path, *path.parents):
        if folder.stat().st_mode & 0o755 != 0o755:
            folder.chmod(0o755)


@needs_root
def test_missing_packages_are_named_without_sudo(checkout: Checkout) -> None:
    allow_reading(checkout.path)
    subprocess.run(["chown", "-R", str(NOBODY), checkout.path], check=True)
    # A machine without Java, as an ordinary user: the folder of JDKs is hidden, nothing may gain rights.
    script = (
        "mount -t tmpfs tmpfs /usr/lib/jvm && "
        f'exec setpriv --reuid {NOBODY} --clear-groups --no-new-privs "$@"'
    )
    outcome = checkout.run(
        "up",
        before=("unshare", "--mount", "bash", "-c", script, "as-nobody"),
        PATH="/usr/bin:/bin",
        JAVA_HOME="",
        HOME="/nonexistent",
    )
    assert outcome.returncode == RIGHTS, outcome.stderr
    assert "may not install them" in outcome.stderr
    assert "apt-get install -y" in outcome.stderr
    assert "openjdk-17-jdk-headless" in outcome.stderr or "default-jdk-headless" in outcome.stderr


@needs_root
def test_checkout_of_another_user_is_reported(checkout: Checkout) -> None:
    allow_reading(checkout.path)
    outcome = checkout.run("up", before=("setpriv", "--reuid", str(NOBODY), "--clear-groups"))
    assert outcome.returncode == RIGHTS, outcome.stderr
    assert "may not write to" in outcome.stderr
    assert "owner (root)" in outcome.stderr


@needs_root
def test_build_does_not_start_on_nearly_full_disk(tmp_path: Path) -> None:
    with small_disk(tmp_path / "disk", "300m") as disk:
        copy_tree(disk)
        outcome = Checkout(disk).run("build")
    assert outcome.returncode == DISK, outcome.stderr
    assert "building needs 2048 MB" in outcome.stderr
    assert "Make room" in outcome.stderr


@pytest.mark.parametrize(
    ("output", "code"),
    [
        ("The disk that holds /data/postgres is full: the database needs 300 MB to start with.", DISK),
        ("The disk of the database is full; free some space, nothing was lost.", DISK),
        ("FATAL: could not write lock file: No space left on device", DISK),
        ("java.net.BindException: Address already in use", PORT),
        ("java.lang.OutOfMemoryError: Java heap space", START),
    ],
)
def test_server_start_failure_is_explained_from_its_log(
    untouched: Checkout, tmp_path: Path, output: str, code: int
) -> None:
    log = tmp_path / "server.log"
    log.write_text(f"What an earlier run said: Disk quota exceeded\n{output}\n")
    earlier = len(log.read_bytes().splitlines(keepends=True)[0])
    status = untouched.inside(
        f". {untouched.path}/scripts/lib/ready.sh",
        f"LOGS={tmp_path} DATA={tmp_path} LOG_START={earlier}",
        "stop_everything() { :; }",
        "(fail_from_server_log 'It ended.') >/dev/null 2>&1 || echo $?",
    )
    assert int(status) == code


def test_late_start_is_not_reported_as_end(untouched: Checkout, tmp_path: Path) -> None:
    """Until it begins, which a busy machine has it do late, its process is a copy of the script."""
    waits = f"{sys.executable} -c 'import signal; signal.pause()' -Ddronemap.checkout=$DATA -jar"
    states = untouched.inside(
        f". {untouched.path}/scripts/lib/server.sh",
        f"exec {{LOCK}}>/dev/null; DATA={tmp_path}",
        "pid_of() { touch $DATA/looked; cat $DATA/$1.pid; }",
        "umask() { until [[ -e $DATA/looked ]]; do sleep 0.01; done; }",
        f"start_daemon server $DATA/log {waits}",
        "is_running server && echo runs",
        "kill $(pid_of server)",
        "start_daemon sim $DATA/log $DATA/no-such-program",
        "is_running sim || echo ended",
    )
    assert states.split() == ["runs", "ended"]


def mark_web_client_built(checkout: Checkout) -> None:
    """For what ends before its page matters."""
    checkout.inside(
        "mkdir -p $APP $ROOT/web-client/dist $ROOT/web-client/node_modules",
        "hash_of web-client/package-lock.json >$ROOT/web-client/node_modules/.dronemap-lock",
        "touch $ROOT/web-client/dist/index.html",
        "hash_of_page >$APP/web.stamp",
    )


@needs_root
def test_missing_network_for_web_packages_is_reported(checkout: Checkout, tmp_path: Path) -> None:
    # Once for each package: npm's own tries again cost half a minute of a core, and find the same.
    outcome = checkout.run(
        "build", before=("unshare", "--net"), HOME=str(tmp_path / "home"), npm_config_fetch_retries="0"
    )
    assert outcome.returncode == NETWORK, outcome.stderr
    assert "no network" in outcome.stderr
    assert "run the same command again" in outcome.stderr


@needs_root
def test_missing_network_for_server_libraries_is_reported(checkout: Checkout, tmp_path: Path) -> None:
    mark_web_client_built(checkout)
    repository = f"-Dmaven.repo.local={tmp_path / 'empty'}"
    outcome = checkout.run("build", before=("unshare", "--net"), MAVEN_OPTS=repository)
    assert outcome.returncode == NETWORK, outcome.stderr
    assert "no network" in outcome.stderr


def interrupted_build(checkout: Checkout) -> None:
    # In a session of its own, where the interrupt key reaches the whole foreground group.
    with subprocess.Popen(
        [checkout.path / "dronemap", "build"],
        env=checkout.environment(),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        bufsize=0,
        start_new_session=True,
    ) as build:
        assert build.stdout is not None
        output = read_until(build.stdout, "(2 of ", 300)
        os.killpg(build.pid, signal.SIGINT)
        output += build.communicate(timeout=30)[0].decode()
    assert build.returncode == INTERRUPTED
    assert "Interrupted while building the server" in output
    assert "run the same command again" in output
    assert processes_of(checkout.path) == []


def test_interrupted_build_ends_cleanly(checkout: Checkout) -> None:
    mark_web_client_built(checkout)
    interrupted_build(checkout)
    assert not (checkout.path / ".tools/app/dronemap.jar").exists()


@pytest.mark.soak
def test_interrupted_build_continues_when_run_again(
    checkout: Checkout,
) -> None:
    interrupted_build(checkout)
    again = checkout.run("build", seconds=600)
    assert again.returncode == 0, again.stderr
    assert (checkout.path / ".tools/app/dronemap.jar").exists()
    unchanged = checkout.run("build")
    assert unchanged.returncode == 0
    assert "Building" not in unchanged.stdout


def test_second_command_in_one_checkout_is_refused(untouched: Checkout) -> None:
    tools = untouched.path / ".tools"
    tools.mkdir(exist_ok=True)
    with subprocess.Popen(["flock", tools / "lock", "cat"], stdin=subprocess.PIPE) as holder:
        free = ["flock", "-n", str(tools / "lock"), "true"]
        until("it is taken", lambda: subprocess.run(free, check=False).returncode != 0)
        outcome = untouched.run("up")
        assert holder.stdin is not None
        holder.stdin.close()
    assert outcome.returncode == 1
    assert "Another ./dronemap is at work" in outcome.stderr


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("fly",), "There is no command 'fly'"),
        (("up", "--loud"), "up does not know '--loud'"),
        (("up", "--cert", "x.pem"), "there is no readable file 'x.pem'"),
        (("backup",), "backup needs the file to write"),
        (("restore", "missing.zip"), "There is no readable file 'missing.zip'"),
        (("replay", "missing.tlog"), "There is no readable file 'missing.tlog'"),
        (("replay", "x.tlog", "--speed", "fast"), "it must be a number from 1 to 100"),
        (("replay", "x.tlog", "--speed", "0.5"), "it must be a number from 1 to 100"),
        (("replay", "x.tlog", "--speed", "101"), "it must be a number from 1 to 100"),
    ],
)
def test_wrong_use_is_answered_with_a_sentence(
    untouched: Checkout, arguments: tuple[str, ...], sentence: str
) -> None:
    outcome = untouched.run(*arguments)
    assert outcome.returncode == USAGE
    assert sentence in outcome.stderr


def test_invalid_port_is_refused(untouched: Checkout) -> None:
    outcome = untouched.run("up", DRONEMAP_HTTP_PORT="70000")
    assert outcome.returncode == USAGE
    assert "DRONEMAP_HTTP_PORT is '70000'; it must be a port from 1 to 65535" in outcome.stderr


def test_bind_beyond_loopback_needs_public(untouched: Checkout) -> None:
    outcome = untouched.run("up", DRONEMAP_BIND="0.0.0.0", container="")
    assert outcome.returncode == USAGE
    assert "use ./dronemap up --public" in outcome.stderr


def test_commands_without_server_explain_how_to_start_it(untouched: Checkout, tmp_path: Path) -> None:
    for arguments in (("backup", str(tmp_path / "b.zip")), ("replay", __file__), ("password",)):
        outcome = untouched.run(*arguments)
        assert outcome.returncode == 1
        assert "Start it with ./dronemap up" in outcome.stderr
    assert untouched.run("status").returncode == 1
    assert untouched.run("down").returncode == 0


def test_help_names_every_command_and_exit_code(untouched: Checkout) -> None:
    text = untouched.run("help").stdout
    for word in (
        "up",
        "down",
        "status",
        "logs",
        "test",
        "soak",
        "trials",
        "backup",
        "restore",
        "replay",
        "help",
    ):
        assert f"\n  {word}" in text
    options = ("--no-demo", "--public", "--cert", "--key", "--speed", "--yes")
    for option in (*options, "--only", "--repeat", "--minutes", "--again"):
        assert option in text
    for code in (*range(10), INTERRUPTED):
        assert f"{code}  " in text
