"""MAVProxy as people type at it."""

import subprocess
import sys
import threading
from pathlib import Path

from .waiting import wait_for


class Mavproxy:
    """One session at a terminal; what was waited for is not found again."""

    def __init__(self, program: str, master: str, folder: Path) -> None:
        interpreter = Path(program).with_name("python")
        self._process = subprocess.Popen(
            [
                *(str(interpreter) if interpreter.exists() else sys.executable, "-u", program),
                *("--mav20", f"--master={master}", "--source-system=254", f"--state-basedir={folder}"),
            ],
            cwd=folder,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        self._output = ""
        self._searched = 0
        threading.Thread(target=self._read_output, daemon=True).start()
        self.wait("MAV>", 60)

    def _read_output(self) -> None:
        assert self._process.stdout is not None
        while piece := self._process.stdout.read(1):
            self._output += piece

    def enter(self, line: str) -> None:
        assert self._process.stdin is not None
        self._process.stdin.write(line + "\n")
        self._process.stdin.flush()

    def wait(self, words: str, seconds: float = 30) -> None:
        def found() -> bool:
            return self._output.find(words, self._searched) >= 0

        try:
            wait_for(f"MAVProxy says {words}", found, seconds)
        except AssertionError as e:
            raise AssertionError(f"{e}; it said: {self._output[-2000:]}") from e
        self._searched = self._output.find(words, self._searched) + len(words)

    def close(self) -> None:
        # It ends when nobody types any more; asked otherwise it waits for another line.
        assert self._process.stdin is not None
        self._process.stdin.close()
        try:
            self._process.wait(20)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait(20)
