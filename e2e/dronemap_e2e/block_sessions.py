"""Runs the code blocks of a page as a reader would: a shell and a Python that live as long as the page."""

import os
import re
import select
import signal
import subprocess
import sys
import time
from pathlib import Path

from .documents import Run

MOST_SECONDS = 120
ENDED = re.compile(rb"\x1eended (\d+)\n")
# Orders come through a copy of the input: what a block reads is empty. A block that fails ends the shell.
SHELL = r"""
exec 3<&0 </dev/null
trap 'printf "\x1eended %s\n" $?' EXIT
set -eo pipefail
while IFS=$'\t' read -r -u 3 file fails; do
    status=0
    if [[ $fails == True ]]; then
        set +e; (trap - EXIT; set -e; . "$file"); status=$?; set -e
    else
        . "$file"
    fi
    printf '\x1eended %s\n' "$status"
done
"""
PYTHON = r"""
import os, sys, traceback
orders = os.fdopen(os.dup(0))
os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
names = {"__name__": "__main__"}
for order in orders:
    file = order.split("\t")[0]
    status = 0
    try:
        exec(compile(open(file).read(), file, "exec"), names)
    except SystemExit as left:
        status = int(bool(left.code))
        if isinstance(left.code, str):
            print(left.code, file=sys.stderr)
    except BaseException:
        traceback.print_exc()
        status = 1
    sys.stderr.flush()
    print(f"\x1eended {status}", flush=True)
"""


class Session:
    """An interpreter that is given one file after the other and keeps its variables."""

    def __init__(self, command: list[str], folder: Path, environment: dict[str, str]) -> None:
        self._process = subprocess.Popen(
            command,
            cwd=folder,
            env=environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )

    def run(self, file: Path, fails: bool) -> tuple[int, str]:
        """Its status and what it said; -1: it did not end in time."""
        assert self._process.stdin and self._process.stdout
        self._process.stdin.write(f"{file}\t{fails}\n".encode())
        self._process.stdin.flush()
        said = b""
        deadline = time.monotonic() + MOST_SECONDS
        while True:
            left = deadline - time.monotonic()
            if left <= 0 or not select.select([self._process.stdout], [], [], left)[0]:
                self.close()
                return -1, said.decode(errors="replace")
            part = os.read(self._process.stdout.fileno(), 65536)
            said += part
            ended = ENDED.search(said)
            if ended:
                return int(ended[1]), said[: ended.start()].decode(errors="replace")
            if not part:
                return self._process.wait() or 1, said.decode(errors="replace")

    def close(self) -> None:
        """With whatever it started and left behind."""
        end_group(self._process)


def end_group(process: subprocess.Popen[bytes]) -> None:
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        return
    finally:
        process.wait()


class PageSessions:
    """All that a page runs, in one folder and one environment."""

    def __init__(self, folder: Path, scratch: Path, environment: dict[str, str]) -> None:
        """`scratch`: where the files of the blocks lie, which are none of the reader's."""
        self._folder = folder
        self._scratch = scratch
        self._environment = environment
        self._sessions: dict[str, Session] = {}

    def run(self, run: Run, source: str) -> tuple[int, str]:
        suffix = {"bash": "sh", "python": "py"}.get(run.kind, run.kind)
        file = self._scratch / f"{run.first.page.replace('/', '-')}.{run.first.line}.{suffix}"
        if run.kind in ("bash", "python"):
            file.write_text(source)
            return self._session(run.kind).run(file, run.fails)
        if run.kind in ("ts", "js"):
            # Packages are looked for from where the file lies.
            file = self._folder / f"{file.stem}.{'mts' if run.kind == 'ts' else 'mjs'}"
        file.write_text(source)
        return self._run_program(self._command(run.kind, file))

    def close(self) -> None:
        for session in self._sessions.values():
            session.close()

    def _session(self, kind: str) -> Session:
        if kind not in self._sessions:
            command = ["bash", "-c", SHELL] if kind == "bash" else [sys.executable, "-u", "-c", PYTHON]
            self._sessions[kind] = Session(command, self._folder, self._environment)
        return self._sessions[kind]

    def _command(self, kind: str, file: Path) -> list[str]:
        if kind == "php":
            return ["php", "-d", "soap.wsdl_cache_enabled=0", str(file)]
        if kind == "java":
            return ["java", "-cp", "java-example/target/*", str(file)]
        if kind == "ts":
            return ["node_modules/.bin/tsx", str(file)]
        return ["node", str(file)]

    def _run_program(self, command: list[str]) -> tuple[int, str]:
        process = subprocess.Popen(
            command,
            cwd=self._folder,
            env=self._environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        try:
            said, _ = process.communicate(timeout=MOST_SECONDS)
            return process.returncode, said.decode(errors="replace")
        except subprocess.TimeoutExpired as late:
            return -1, (late.output or b"").decode(errors="replace")
        finally:
            end_group(process)
