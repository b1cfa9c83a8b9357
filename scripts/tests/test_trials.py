"""Trials: what is done is done, what was interrupted goes on, and nothing is called passed that was not."""

import ast
import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import trial_results
import trial_table
import trial_units
import trials

from .conftest import ROOT
from .waiting import until

TABLE = """
[seeds]
says = "Three seeds."
run = "sh unit.sh {unit}"
units = "1-3"

[names]
says = "Two names beside a busy process."
run = "sh unit.sh {unit}"
units = ["a", "b"]
busy = 1

[files]
says = "Each file."
run = "true {unit}"
files = "tests/*.py"
except = ["tests/no.py"]
needs = "SOMETHING_THAT_IS_NOT_THERE"

[some]
says = "A unit that needs something."
run = "sh unit.sh {unit}"
units = ["a", "b"]
needs = { b = "SOMETHING_THAT_IS_NOT_THERE" }

[nothing]
says = "A program that is not there."
run = "./no-such-program"
units = "1-2"
"""


class TrialCheckout:
    """A checkout with trials of its own, whose units do as `unit.sh` says and are noted in `ran`."""

    def __init__(self, root: Path) -> None:
        self.root = root
        (root / "scripts").mkdir()
        (root / "tests").mkdir()
        for name in ("yes", "no", "also"):
            (root / "tests" / f"{name}.py").touch()
        for module in ("trials", "trial_table", "trial_results", "trial_units"):
            shutil.copy2(ROOT / "scripts" / f"{module}.py", root / "scripts")
        (root / "scripts" / "trials.toml").write_text(TABLE)
        self.set_unit_script("exit 0")

    def set_unit_script(self, what: str) -> None:
        (self.root / "unit.sh").write_text(f'echo "$1" >>ran\n{what}\n')

    def command(self, *arguments: str) -> list[str]:
        return [sys.executable, str(self.root / "scripts" / "trials.py"), *arguments]

    def run(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            self.command(*arguments), text=True, capture_output=True, check=False, timeout=60
        )

    @property
    def ran(self) -> list[str]:
        file = self.root / "ran"
        return file.read_text().split() if file.exists() else []

    def state(self, name: str) -> Path:
        return self.root / ".tools" / "trials" / f"{name}.tsv"

    def results(self, name: str) -> list[str]:
        return (self.root / "docs" / "trials" / f"{name}.tsv").read_text().splitlines()


@pytest.fixture
def trial_checkout(tmp_path: Path) -> TrialCheckout:
    return TrialCheckout(tmp_path)


def is_alive(pid: str) -> bool:
    stat = Path(f"/proc/{pid}/stat")
    return stat.exists() and stat.read_text().rpartition(")")[2].split()[0] != "Z"


def test_list_shows_progress_of_all_trials(trial_checkout: TrialCheckout) -> None:
    trial_checkout.set_unit_script("test $1 != 2")
    assert trial_checkout.run("seeds").returncode == 1
    listed = trial_checkout.run().stdout.splitlines()
    assert listed[0].split(None, 1) == ["seeds", "3 of 3, 1 failed  Three seeds."]
    assert listed[1].split(None, 1)[1].startswith("0 of 2 ")
    assert listed[2].split(None, 1)[1].startswith("0 of 2 ")


def test_results_are_published_in_docs(trial_checkout: TrialCheckout) -> None:
    assert trial_checkout.run("seeds").returncode == 0
    lines = trial_checkout.results("seeds")
    assert lines[0] == "# seeds: Three seeds."
    assert lines[2] == "# 3 of 3 units done, 0 failed"
    assert lines[3] == "unit\tresult\tseconds\tload before\tload\tcores\tcommit\tprocessor"
    for unit, line in zip("123", lines[4:], strict=True):
        values = line.split("\t")
        assert values[:2] == [unit, "passed"]
        assert 0 <= float(values[2]) < 30 and float(values[3]) >= 0 and float(values[4]) >= 0
        assert values[5] == str(len(os.sched_getaffinity(0)))
        assert values[7] == trial_units.processor() != ""


def test_result_names_commit_and_local_changes(trial_checkout: TrialCheckout) -> None:
    git = ["git", "-c", "user.name=a", "-c", "user.email=a@b", "-C", str(trial_checkout.root)]
    (trial_checkout.root / ".gitignore").write_text(".tools\nran\n__pycache__\n")
    for arguments in (["init", "-q"], ["add", "-A"], ["commit", "-qm", "x"]):
        subprocess.run([*git, *arguments], check=True)
    commit = subprocess.run(
        [*git, "rev-parse", "--short=10", "HEAD"], text=True, capture_output=True, check=True
    )
    trial_checkout.run("seeds")
    assert [line.split("\t")[6] for line in trial_checkout.results("seeds")[4:]] == [
        commit.stdout.strip()
    ] * 3
    trial_checkout.set_unit_script("exit 0 # changed")
    trial_checkout.run("seeds", "--again")
    assert trial_checkout.results("seeds")[4].split("\t")[6] == commit.stdout.strip() + "+"


def test_finished_units_are_not_run_again(trial_checkout: TrialCheckout) -> None:
    trial_checkout.set_unit_script("test $1 != 2")
    first = trial_checkout.run("seeds")
    assert "unit 2 failed (1)" in first.stdout
    trial_checkout.set_unit_script("exit 0")
    again = trial_checkout.run("seeds")
    assert again.returncode == 1, "a unit that failed once has failed"
    assert trial_checkout.ran == ["1", "2", "3"]
    assert trial_checkout.results("seeds")[5].startswith("2\tfailed (1)\t")


def test_again_discards_results(trial_checkout: TrialCheckout) -> None:
    trial_checkout.set_unit_script("exit 1")
    trial_checkout.run("seeds")
    trial_checkout.set_unit_script("exit 0")
    assert trial_checkout.run("seeds", "--again").returncode == 0
    assert trial_checkout.ran == ["1", "2", "3"] * 2


def running_second_unit(trial_checkout: TrialCheckout) -> subprocess.Popen[str]:
    """A trial whose second unit says which process it is, and waits."""
    trial_checkout.set_unit_script('if [ "$1" = 2 ] && [ ! -e resumed ]; then echo $$ >waits; sleep 300; fi')
    run = subprocess.Popen(
        trial_checkout.command("seeds"), text=True, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL
    )
    until(
        "it has begun",
        lambda: (
            (trial_checkout.root / "waits").exists()
            and (trial_checkout.root / "waits").read_text().strip() != ""
        ),
    )
    return run


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGTERM, signal.SIGINT])
def test_interrupted_trial_continues_with_its_unit(
    trial_checkout: TrialCheckout, number: signal.Signals
) -> None:
    with running_second_unit(trial_checkout) as run:
        run.send_signal(number)
        errors = run.communicate(timeout=60)[1]
    assert run.returncode == (-number if number == signal.SIGKILL else trial_units.INTERRUPTED)
    assert number == signal.SIGKILL or "run the same command again and it goes on" in errors
    unit = (trial_checkout.root / "waits").read_text().strip()
    until("it has ended", lambda: not is_alive(unit))
    assert len(trial_checkout.state("seeds").read_text().splitlines()) == 1
    assert trial_checkout.results("seeds")[2] == "# 1 of 3 units done, 0 failed", (
        "shown at once, not at the end"
    )

    (trial_checkout.root / "resumed").touch()
    resumed = trial_checkout.run("seeds")
    assert resumed.returncode == 0, resumed.stderr
    assert trial_checkout.ran == ["1", "2", "2", "3"]
    assert trial_checkout.results("seeds")[2] == "# 3 of 3 units done, 0 failed"


def test_killed_unit_is_not_recorded(trial_checkout: TrialCheckout) -> None:
    trial_checkout.set_unit_script("exit 143")
    outcome = trial_checkout.run("seeds")
    assert outcome.returncode == 1
    assert "The unit 1 was ended from outside" in outcome.stderr
    assert not trial_checkout.state("seeds").exists()


@pytest.mark.parametrize(
    "damage",
    [
        lambda line: line.replace("passed", "failed (1)"),
        lambda line: line.replace("passed", "pass\x00ed"),
        lambda line: line[:20],
        lambda line: line.rpartition("\t")[0],
        lambda line: "\udcff" + line,
        lambda line: "3" + line[1:],
        lambda line: "",
    ],
    ids=["changed", "bytes", "cut off", "no sum", "no text", "another unit", "gone"],
)
def test_damaged_line_is_reported_and_unit_runs_again(
    trial_checkout: TrialCheckout, damage: Callable[[str], str]
) -> None:
    trial_checkout.run("seeds")
    lines = trial_checkout.state("seeds").read_text().splitlines()
    lines[1] = damage(lines[1])
    trial_checkout.state("seeds").write_bytes("\n".join(lines).encode(errors="surrogateescape"))
    listed = trial_checkout.run()
    assert listed.returncode == 0 and "2 of 3 " in listed.stdout
    again = trial_checkout.run("seeds")
    if lines[1]:
        for outcome in (listed, again):
            assert f"Line 2 of {trial_checkout.state('seeds')} is damaged" in outcome.stderr
    assert trial_checkout.ran == ["1", "2", "3", "2"]
    assert again.returncode == 0 and trial_checkout.run("seeds").stderr == ""


def test_results_of_another_command_are_ignored(trial_checkout: TrialCheckout) -> None:
    trial_checkout.run("seeds")
    table = trial_checkout.root / "scripts" / "trials.toml"
    table.write_text(TABLE.replace('run = "sh unit.sh {unit}"', 'run = "sh unit.sh {unit} more"', 1))
    assert trial_checkout.run("seeds").stderr.count("of another command") == 3
    assert trial_checkout.ran == ["1", "2", "3"] * 2


def test_no_unit_starts_that_would_exceed_the_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Units of 50 s in two minutes are two; a trial with less time than one takes comes on by one."""
    TrialCheckout(tmp_path)
    now = [0.0]

    def fifty_seconds(trial: trial_table.Trial, unit: str, root: Path, log: Path) -> trial_results.UnitResult:
        now[0] += 50
        return trial_results.UnitResult(unit, "passed", "50.0", "0", "0", "2", "abc", "cpu")

    monkeypatch.setattr(trials, "run_unit", fifty_seconds)
    monkeypatch.setattr("trials.time.monotonic", lambda: now[0])
    assert trials.main(["seeds", "--minutes", "2"], tmp_path) == 0
    assert "2 of 3." in capsys.readouterr().out.splitlines()[-1]
    assert trials.main(["seeds", "--again", "--minutes", "1"], tmp_path) == 0
    assert "run the same command again to go on with unit 2" in capsys.readouterr().out
    assert trials.main(["seeds", "--minutes", "1"], tmp_path) == 0
    assert "2 of 3." in capsys.readouterr().out.splitlines()[-1]


def test_busy_process_runs_during_each_unit(trial_checkout: TrialCheckout) -> None:
    trial_checkout.set_unit_script("ps -o pid=,args= --ppid $PPID | grep 'while True: pass' >>busy")
    assert trial_checkout.run("names").returncode == 0
    busy = (trial_checkout.root / "busy").read_text().splitlines()
    assert len(busy) == 2
    assert not any(is_alive(line.split()[0]) for line in busy)
    assert trial_checkout.results("names")[1].endswith("beside 1 busy process(es)")


def test_busy_processes_end_when_trial_is_killed(trial_checkout: TrialCheckout) -> None:
    trial_checkout.set_unit_script("ps -o pid=,args= --ppid $PPID | grep 'while True: pass' >busy; sleep 300")
    with subprocess.Popen(trial_checkout.command("names"), stdout=subprocess.DEVNULL) as run:
        until(
            "it is busy",
            lambda: (
                (trial_checkout.root / "busy").exists() and (trial_checkout.root / "busy").read_text() != ""
            ),
        )
        run.kill()
    until("it has ended", lambda: not is_alive((trial_checkout.root / "busy").read_text().split()[0]))


def test_files_are_units_except_excluded_ones(
    trial_checkout: TrialCheckout, monkeypatch: pytest.MonkeyPatch
) -> None:
    refused = trial_checkout.run("files")
    assert refused.returncode == 1 and "needs SOMETHING_THAT_IS_NOT_THERE" in refused.stderr
    monkeypatch.setenv("SOMETHING_THAT_IS_NOT_THERE", "here")
    assert trial_checkout.run("files").returncode == 0
    assert [line.split("\t")[0] for line in trial_checkout.results("files")[4:]] == [
        "tests/also.py",
        "tests/yes.py",
    ]


def test_unit_without_what_it_needs_is_not_proved(trial_checkout: TrialCheckout) -> None:
    outcome = trial_checkout.run("some")
    assert outcome.returncode == 0
    assert "The unit b is left out and not proved: it needs SOMETHING_THAT_IS_NOT_THERE" in outcome.stderr
    assert trial_checkout.ran == ["a"]
    assert "1 of 2" in outcome.stdout


def test_missing_command_is_not_a_failed_unit(trial_checkout: TrialCheckout) -> None:
    outcome = trial_checkout.run("nothing")
    assert outcome.returncode == 1
    assert "The command of 'nothing' cannot be run" in outcome.stderr
    assert not trial_checkout.state("nothing").exists()


def test_busy_checkout_is_not_a_failed_unit(
    trial_checkout: TrialCheckout, monkeypatch: pytest.MonkeyPatch
) -> None:
    (trial_checkout.root / ".tools").mkdir()
    monkeypatch.setattr(trials, "END_SECONDS", 0.3)
    with trial_units.exclusive_lock(trial_checkout.root / ".tools" / "lock", ""):
        assert trials.main(["seeds"], trial_checkout.root) == 1
    assert trial_checkout.ran == []


def test_trial_does_not_run_twice_at_once(trial_checkout: TrialCheckout) -> None:
    with running_second_unit(trial_checkout) as run:
        outcome = trial_checkout.run("seeds")
        run.terminate()
    assert outcome.returncode == 1
    assert "The trial 'seeds' is being run already" in outcome.stderr


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["fly"], "There is no trial 'fly'"),
        (["seeds", "--minutes", "0"], "'0' must be a number from 1 to 100000"),
        (["seeds", "--minutes", "soon"], "'soon' must be a number from 1 to 100000"),
        (["--minutes", "5"], "--minutes and --again need the name of a trial"),
        (["seeds", "--loud"], "unrecognized arguments: --loud"),
    ],
)
def test_wrong_use_is_answered_with_a_sentence(
    trial_checkout: TrialCheckout, arguments: list[str], sentence: str
) -> None:
    outcome = trial_checkout.run(*arguments)
    assert outcome.returncode == trials.USAGE
    assert outcome.stderr.startswith("dronemap: ") and sentence in outcome.stderr


@pytest.mark.parametrize(
    ("entry", "sentence"),
    [
        ('[a]\nsays = "x"\nrun = "y"\nunits = "9-1"', "must be a range such as 1-20"),
        ('[a]\nsays = "x"\nrun = "y"\nunits = []', "needs units"),
        ('[a]\nsays = "x"\nrun = "y"\nunits = ["b", "b"]', "each of them once"),
        ('[a]\nsays = "x"\nunits = "1-2"', "needs what it says and what it runs"),
        ('[a]\nsays = "x"\nrun = "y"\nunits = "1-2"\nbusy = "much"', "has 'busy = much'"),
        ('[a]\nsays = "x"\nrun = "y"\nunits = "1-2"\ncolour = 1', "has 'colour = 1'"),
        ('["../a"]\nsays = "x"\nrun = "y"\nunits = "1-2"', "must have a name of small letters"),
        ('[a]\nsays = "x"\nrun = "y"\nunits = ["b"]\nneeds = { c = "D" }', "has needs of 'c'"),
        ("[a", "is not readable"),
    ],
)
def test_invalid_trial_table_is_refused(trial_checkout: TrialCheckout, entry: str, sentence: str) -> None:
    (trial_checkout.root / "scripts" / "trials.toml").write_text(entry)
    outcome = trial_checkout.run()
    assert outcome.returncode == 1
    assert sentence in outcome.stderr


# --- what this trial_checkout declares ---


def is_marked(node: ast.AST) -> bool:
    return any(isinstance(part, ast.Attribute) and part.attr == "soak" for part in ast.walk(node))


def _is_mark(node: ast.Assign) -> bool:
    return any(isinstance(target, ast.Name) and target.id == "pytestmark" for target in node.targets)


def kinds_of(file: Path) -> tuple[bool, bool]:
    """Kinds of tests in a file: ordinary ones, long ones."""
    ordinary = long = False
    module = ast.parse(file.read_text())
    if any(isinstance(node, ast.Assign) and _is_mark(node) and is_marked(node.value) for node in module.body):
        return False, True
    for node in ast.walk(module):
        if isinstance(node, ast.FunctionDef) and node.name.startswith("test_"):
            direct = any(isinstance(mark, ast.Attribute) and is_marked(mark) for mark in node.decorator_list)
            ordinary |= not direct
            long |= any(is_marked(mark) for mark in node.decorator_list)
    return ordinary, long


def test_each_file_with_long_tests_has_a_trial() -> None:
    commands = [trial.run for trial in trial_table.load_trials(ROOT).values()]
    python = [
        path for project in ("bench", "e2e", "scripts") for path in (ROOT / project).glob("tests/test_*.py")
    ]
    java = [
        path
        for path in ROOT.glob("dronemap-*/src/test/java/**/*Test.java")
        if '@Tag("soak")' in path.read_text() and "dronemap-archive" not in path.parts
    ]
    long = [path for path in python if kinds_of(path)[1]]
    assert len(long) > 20 and len(java) > 4
    commands += [
        " ".join(trial.command(unit))
        for trial in trial_table.load_trials(ROOT).values()
        for unit in trial.units
    ]
    for path in [str(file.relative_to(ROOT)) for file in long] + [f"/{file.name}" for file in java]:
        assert any(command.endswith(f" {path}::") for command in commands), path
    assert any(command.endswith("--only dronemap-archive/") for command in commands)


def test_each_file_of_ordinary_end_to_end_tests_is_repeated() -> None:
    units = trial_table.load_trials(ROOT)["repeat-e2e"].units
    files = [path for path in sorted((ROOT / "e2e").glob("tests/test_*.py")) if kinds_of(path)[0]]
    assert units == [str(path.relative_to(ROOT)) for path in files]
