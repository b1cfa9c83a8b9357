# shellcheck shell=bash
# Workers: how many programs test or build at the same time, and what runs beside what.

MOST_WORKERS=256
SIDE_LANE=""   # process of the lane beside the main one

# As many as there are cores: two programs that share one make tests slow, and those red that wait for a condition.
count_workers() {
    WORKERS=${DRONEMAP_TEST_WORKERS:-$(nproc)}
    [[ $WORKERS =~ ^[0-9]{1,3}$ ]] && ((10#$WORKERS >= 1 && 10#$WORKERS <= MOST_WORKERS)) ||
        fail "$EXIT_USAGE" "DRONEMAP_TEST_WORKERS is '$WORKERS'; it must be a number from 1 to $MOST_WORKERS."
    WORKERS=$((10#$WORKERS))
    # What `-n auto` in the settings of the Python projects becomes.
    export PYTEST_XDIST_AUTO_NUM_WORKERS=$WORKERS
}

# What is left for one lane while another one takes one worker.
workers_beside() { printf '%s' $((WORKERS > 1 ? WORKERS - 1 : 1)); }

# Two lanes at the same time, or one after the other where there is one worker. Returns when both have ended.
side_by_side() { # FUNCTION SIDE-FUNCTION
    local status=0
    if ((WORKERS == 1)); then
        "$2"
        "$1"
        return
    fi
    set -m
    (in_side_lane "$2") </dev/null &
    SIDE_LANE=$!
    set +m
    ON_INTERRUPT=end_side_lane
    "$1"
    WORK="testing ($2)"
    wait "$SIDE_LANE" || status=$?
    SIDE_LANE=""
    ON_INTERRUPT=""
    if ((status != 0)); then record lanes failed "$2 ended early, with $status" "$TEST_LOGS"; fi
}

# The main lane speaks of an interruption; this one only ends what it runs.
in_side_lane() { # FUNCTION
    trap 'end_active_group; exit 143' INT TERM HUP
    set +m
    ON_INTERRUPT=""
    "$1"
}

end_side_lane() {
    [[ -n $SIDE_LANE ]] || return 0
    kill -TERM "$SIDE_LANE" 2>/dev/null || true
    wait "$SIDE_LANE" 2>/dev/null || true
}

# What a lane says about one thing stands together, whatever other lanes say meanwhile.
say_together() { # COMMAND…
    (
        flock 9
        "$@"
    ) 9>"$TEST_LOGS/speaking"
}
