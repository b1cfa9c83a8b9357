# shellcheck shell=bash
# How the script speaks and how it ends: progress, sentences, exit codes, interruption.

readonly EXIT_FAILED=1 EXIT_USAGE=2 EXIT_RIGHTS=3 EXIT_PORT=4 EXIT_DISK=5 EXIT_NETWORK=6
readonly EXIT_BUILD=7 EXIT_START=8 EXIT_PASSWORD=9 EXIT_CHANGED=10 EXIT_UNCHECKED=11

WORK=""           # what is being done, for the sentence after an interruption
ACTIVE_GROUP=""   # process group of the long command under way
ON_INTERRUPT=""   # function that undoes what is half done

step() { printf '\033[1m==>\033[0m %s\n' "$*" | plain_unless_terminal; }
note() { printf '    %s\n' "$*"; }
warn() { printf 'dronemap: %s\n' "$*" >&2; }

plain_unless_terminal() {
    if [[ -t 1 ]]; then cat; else sed 's/\x1b\[[0-9;]*m//g'; fi
}

# One sentence that says what to do, and the exit code that `help` documents.
fail() { # CODE SENTENCE…
    local code=$1
    shift
    printf 'dronemap: %s\n' "$*" >&2
    exit "$code"
}

watch_for_interruption() {
    trap 'interrupted 130' INT
    trap 'interrupted 143' TERM
    trap 'interrupted 129' HUP
}

interrupted() { # CODE
    trap '' INT TERM HUP
    end_active_group
    [[ -z $ON_INTERRUPT ]] || "$ON_INTERRUPT" || true
    printf '\n' >&2
    if [[ -n $WORK ]]; then
        fail "$1" "Interrupted while $WORK. Nothing is broken: run the same command again and it goes on."
    fi
    exit "$1"
}

end_active_group() {
    local tries
    [[ -n $ACTIVE_GROUP ]] || return 0
    kill -TERM -- "-$ACTIVE_GROUP" 2>/dev/null || true
    for ((tries = 0; tries < 50; tries++)); do
        kill -0 -- "-$ACTIVE_GROUP" 2>/dev/null || break
        sleep 0.1
    done
    kill -KILL -- "-$ACTIVE_GROUP" 2>/dev/null || true
    ACTIVE_GROUP=""
}

# Runs a long command with its output in a log, in a process group of its own so that an interruption ends all of it;
# PROGRESS is called once a second and may print. Returns the command's status.
run_logged() { # LOG PROGRESS COMMAND…
    local log=$1 progress=$2 status=0
    shift 2
    set -m
    "$@" >"$log" 2>&1 </dev/null {LOCK}>&- &
    ACTIVE_GROUP=$!
    set +m
    LAST_PROGRESS=""
    # What shows nothing meanwhile needs no looking at: waiting for it ends when it does.
    while [[ $progress != no_progress ]] && kill -0 "$ACTIVE_GROUP" 2>/dev/null; do
        "$progress" "$log"
        sleep 0.5
    done
    wait "$ACTIVE_GROUP" || status=$?
    "$progress" "$log"
    end_progress_line
    ACTIVE_GROUP=""
    return "$status"
}

no_progress() { :; }

# Shows where a long command is: over the same line on a terminal, else one line for each new thing.
show_progress() { # TEXT
    [[ -n $1 && $1 != "$LAST_PROGRESS" ]] || return 0
    LAST_PROGRESS=$1
    if [[ -t 1 ]]; then printf '\r\033[K    %.100s' "$1"; else note "$1"; fi
}

end_progress_line() {
    if [[ -t 1 && -n $LAST_PROGRESS ]]; then printf '\n'; fi
}

# Why a command that downloads or builds failed, judged by its own log: a full disk and a missing network get their sentence.
fail_from_log() { # LOG CODE SENTENCE…
    local log=$1 code=$2
    shift 2
    if grep -qE 'No space left on device|ENOSPC|enough free space|Disk quota exceeded' "$log"; then
        fail "$EXIT_DISK" "The disk is full. Make room (building needs 2 GB) and run the same command again. Details: $log"
    fi
    if grep -qE 'certificate verify failed|PKIX path|SELF_SIGNED_CERT|UNABLE_TO_(GET|VERIFY)' "$log"; then
        fail "$EXIT_NETWORK" "A download failed because its certificate is not trusted here. Behind an inspecting proxy, install" \
            "its authority (update-ca-certificates) and run the same command again. Details: $log"
    fi
    if grep -qiE 'unknown ?host|Temporary failure in name resolution|Temporary failure resolving|Network is unreachable|ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ECONNRESET|ETIMEDOUT|Could not resolve host|Could not resolve .http|connection timed out|Could not transfer artifact|NewConnectionError|Failed to establish a new connection|Failed to fetch|Unable to connect|cannot access .* in offline mode' "$log"; then
        fail "$EXIT_NETWORK" "A package could not be downloaded: no network. Check the connection (and the proxy settings of apt, npm," \
            "pip and Maven) and run the same command again. Details: $log"
    fi
    # What Java noted on its way is no reason.
    grep -vE '^[0-9-]+T[0-9:.]+[^ ]* (INFO|DEBUG) ' "$log" | tail -n 20 >&2 || true
    fail "$code" "$* Details: $log"
}
