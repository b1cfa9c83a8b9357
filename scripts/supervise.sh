#!/usr/bin/env bash
# Runs a server, and runs it again whenever it ends without being stopped: supervise.sh PID-FILE COMMAND…
# A first start that fails with a sentence (exit 1) is not tried again, later ones are: what made them fail may pass.
set -u

readonly PID_FILE=$1
shift
readonly LONGEST_PAUSE=5 STEADY_SECONDS=30

child=""
stopping=false
trap 'stopping=true; [[ -z $child ]] || kill -TERM "$child" 2>/dev/null' TERM INT HUP

pause=0
started=0
while :; do
    started=$((started + 1))
    begun=$SECONDS
    "$@" &
    child=$!
    echo "$child" >"$PID_FILE"
    code=0
    # A signal ends `wait` before the server has ended.
    while :; do
        wait "$child"
        code=$?
        kill -0 "$child" 2>/dev/null || break
    done
    # Stopped, by whoever: 143 is SIGTERM, 130 SIGINT.
    if [[ $stopping == true || $code == 0 || $code == 130 || $code == 143 ]]; then exit 0; fi
    if ((started == 1 && code == 1)); then exit "$code"; fi
    printf '%s the server ended by itself (exit code %s); it is started again\n' "$(date -u +%Y-%m-%dT%H:%M:%SZ)" "$code"
    export DRONEMAP_LAST_EXIT=$code
    if ((SECONDS - begun >= STEADY_SECONDS)); then pause=0; fi
    sleep "$pause" &
    wait $!
    [[ $stopping == false ]] || exit 0
    pause=$((pause < LONGEST_PAUSE ? pause + 1 : LONGEST_PAUSE))
done
