"""Errors are one sentence that says what to do, and a question is asked once."""

import io

import click
import pytest
from fake_server import FakeServer, drone, run

from dronectl.__main__ import main
from dronectl.command import agreed
from dronectl.failure import NotAnswered, exit_code, sentence
from dronectl.output import Output
from dronectl.settings import Settings
from dronemap import AnswerLost, NotConfigured, OutcomeUnknown, Problem, Refused, Unreachable, WaitedTooLong

UNKNOWN = OutcomeUnknown("c1", "arm", None, by=None, code="unknown")
REFUSED = Refused("c1", "arm", "It is in the air.", by="gate", code="drone-airborne")


@pytest.mark.parametrize(
    ("error", "code"),
    [
        (REFUSED, 1),
        (Problem(409, {"detail": "No.", "code": "x"}), 1),
        (click.UsageError("No."), 2),
        (UNKNOWN, 3),
        (AnswerLost("lost"), 3),
        (WaitedTooLong("long"), 3),
        (Unreachable("away"), 4),
        (NotConfigured("nothing"), 4),
        (KeyboardInterrupt(), 130),
        (click.Abort(), 130),
        (ZeroDivisionError(), 1),
    ],
)
def test_code_at_the_end(error: BaseException, code: int) -> None:
    assert exit_code(error) == code


def test_sentence_says_what_to_do() -> None:
    assert sentence(REFUSED) == "arm: It is in the air. [drone-airborne]"
    assert "before you repeat" in sentence(UNKNOWN)
    assert "dronectl config" in sentence(Unreachable("away"))
    assert "access key" in sentence(Problem(401, {"detail": "Sign in.", "code": "not-signed-in"}))
    assert sentence(FileNotFoundError(2, "No such file", "a.txt")) == "a.txt: No such file."
    assert "DRONECTL_DEBUG" in sentence(ZeroDivisionError("by zero"))


def test_fault_of_dronectl_is_no_traceback(monkeypatch: pytest.MonkeyPatch) -> None:
    server = FakeServer(answers={"GET /drones": ZeroDivisionError("by zero")})
    result = run(server, "drones")
    assert result.exit_code == 1
    assert result.stderr.startswith("dronectl: This is a fault of dronectl: ZeroDivisionError")
    monkeypatch.setenv("DRONECTL_DEBUG", "1")
    with pytest.raises(ZeroDivisionError):
        main(["drones"], Settings(transport=server))


def test_reader_that_went_away_ends_it_silently() -> None:
    server = FakeServer(answers={"GET /drones": BrokenPipeError()})
    result = run(server, "drones")
    assert (result.exit_code, result.stderr) == (1, "")


def test_what_a_vehicle_says_does_not_steer_the_terminal() -> None:
    server = FakeServer(drones=[drone(name="a\x1b[2Jb\x9bc")])
    for args in (["drones"], ["arm", "--drone", "none"], ["hold"]):
        printed = run(server, *args).output
        assert "a\N{REPLACEMENT CHARACTER}[2Jb\N{REPLACEMENT CHARACTER}c" in printed
        assert "\x1b" not in printed


class _Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize(("answer", "goes_on"), [("y\n", True), ("n\n", False), ("\n", False)])
def test_question_is_answered_at_a_terminal(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], answer: str, goes_on: bool
) -> None:
    monkeypatch.setattr("sys.stdin", _Terminal(answer))
    monkeypatch.setattr("click.termui.visible_prompt_func", lambda prompt="": answer.strip())
    if goes_on:
        agreed(False, "Delete it?")
    else:
        with pytest.raises(NotAnswered):
            agreed(False, "Delete it?")


def test_names_are_text_and_no_markup(capsys: pytest.CaptureFixture[str]) -> None:
    server = FakeServer(drones=[drone(name="[red]Heron[/red] :smile:")])
    assert "[red]Heron[/red] :smile:" in run(server, "drones").stdout
    Output(False).note("[bold]\x1b[2J")
    assert capsys.readouterr().err == "[bold]\N{REPLACEMENT CHARACTER}[2J\n"


def test_table_in_a_pipe_is_neither_cut_nor_filled_up() -> None:
    server = FakeServer(drones=[drone(name="Heron " + "x" * 120), drone("d2", "Heron-2")])
    lines = run(server, "drones").stdout.splitlines()
    assert len(lines) == 3
    assert all(line == line.rstrip() for line in lines)
