# shellcheck shell=bash
# trials: evidence that takes hours, gathered bit by bit.

command_trials() {
    make_tools_folder
    command -v python3 >/dev/null || fail "$EXIT_RIGHTS" "trials needs Python 3.11 or later."
    # The process becomes the trial's: who ends it ends what it runs.
    exec python3 "$ROOT/scripts/trials.py" "$@"
}
