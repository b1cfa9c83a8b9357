"""Checks what a recording keeps, and that figures match the recordings."""

from __future__ import annotations

import json
import tempfile
import unittest
from dataclasses import asdict
from pathlib import Path
from typing import Any

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from measures import RECORDED, figures
from transcript import Transcript
from vehicles import ALL_EXCHANGES


class TranscriptTest(unittest.TestCase):
    """A transcript with a clock that the test turns."""

    def setUp(self) -> None:
        """Fresh folder, time 0."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name) / "exchange.jsonl"
        self.now = 100.0
        self.transcript = Transcript(self.path, {4: "GUIDED"}, lambda: self.now)

    def saved(self) -> list[dict[str, Any]]:
        """The lines of the file."""
        self.transcript.save()
        return [json.loads(line) for line in self.path.read_text(encoding="utf-8").splitlines()]

    def test_records_nothing_before_start(self) -> None:
        """Preparations stay out."""
        self.transcript.received(mavlink.MAVLink_command_ack_message(400, 0))
        self.assertEqual([], self.saved())

    def test_records_heartbeats_only_when_changed(self) -> None:
        """Mode and arming in words."""
        self.transcript.start()
        for base_mode in (89, 89, 217):
            self.now += 1
            self.transcript.received(mavlink.MAVLink_heartbeat_message(2, 3, base_mode, 4, 3, 3))
        lines = self.saved()
        self.assertEqual([(1000, False), (3000, True)], [(line["t_ms"], line["armed"]) for line in lines])
        self.assertEqual({"GUIDED"}, {line["mode"] for line in lines})

    def test_records_one_position_a_second(self) -> None:
        """Ten a second come, one stays."""
        self.transcript.start()
        for tenths in range(25):
            self.now = 100 + tenths / 10
            self.transcript.received(mavlink.MAVLink_global_position_int_message(tenths, 0, 0, 0, 0, 0, 0, 0, 0))
        self.assertEqual([0, 10, 20], [line["time_boot_ms"] for line in self.saved()])

    def test_writes_not_a_number_as_null(self) -> None:
        """JSON has no NaN."""
        self.transcript.start()
        self.transcript.sent(
            mavlink.MAVLink_command_int_message(1, 1, 6, 192, 0, 0, -1.0, 0.0, 0.0, float("nan"), 0, 0, 30.5)
        )
        line = self.saved()[0]
        self.assertEqual((-1, None, 30.5), (line["param1"], line["param4"], line["z"]))

    def test_keeps_only_parameters_that_were_set(self) -> None:
        """The autopilot reports its own changes too."""
        self.transcript.start()
        self.transcript.sent(mavlink.MAVLink_param_set_message(1, 1, b"FS_GCS_ENABLE", 1, 9))
        for name in (b"STAT_RUNTIME", b"FS_GCS_ENABLE"):
            self.transcript.received(mavlink.MAVLink_param_value_message(name, 1, 9, 1, 0))
        received = [line["param_id"] for line in self.saved() if line["dir"] == "from"]
        self.assertEqual(["FS_GCS_ENABLE"], received)


class RecordingsTest(unittest.TestCase):
    """The committed data."""

    def test_every_exchange_has_a_recording(self) -> None:
        """And no recording is left of one that is gone."""
        names = {exchange.name for exchange in ALL_EXCHANGES}
        self.assertEqual(names, {path.stem for path in RECORDED.glob("*.jsonl")})

    def test_figures_match_recordings(self) -> None:
        """measured.json was taken after the last recording."""
        written = json.loads((RECORDED / "measured.json").read_text(encoding="utf-8"))
        self.assertEqual({key: asdict(figure) for key, figure in figures(RECORDED).items()}, written)


if __name__ == "__main__":
    unittest.main()
