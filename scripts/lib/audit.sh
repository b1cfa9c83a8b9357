# shellcheck shell=bash
# verify-audit: whether all records of what was done are as they were written.

command_verify_audit() {
    local receipt=""
    while (($# > 0)); do
        case $1 in
            --receipt) receipt=$(option_file "$@") && shift || exit ;;
            *) fail "$EXIT_USAGE" "verify-audit does not know '$1'. See ./dronemap help" ;;
        esac
        shift
    done
    load_settings
    if is_running server; then
        verify_running "$receipt"
    else
        verify_stopped "$receipt"
    fi
}

verify_running() { # [RECEIPT]
    adopt_running_settings
    ANSWER_FILE=$(mktemp)
    trap 'rm -f "$ANSWER_FILE"' EXIT
    step "Verifying the records of the running server"
    local receipt=()
    if [[ -n $1 ]]; then receipt=(--data-binary "@$1"); fi
    ask_into "$ANSWER_FILE" /api/v1/audit/verification --request POST --max-time 600 \
        --header 'Content-Type: application/json' "${receipt[@]}" ||
        fail "$EXIT_FAILED" "The records were not verified. $(why "$ANSWER_FILE")"
    [[ $(json_value sound "$(cat "$ANSWER_FILE")") == true ]] || fail "$EXIT_CHANGED" "$(why "$ANSWER_FILE")"
    note "$(why "$ANSWER_FILE")"
}

verify_stopped() { # [RECEIPT]
    local code=0
    [[ -s $RUN_FILE ]] || fail "$EXIT_FAILED" "There is nothing stored in $DATA to verify."
    make_folders
    take_lock
    install_missing
    build_if_changed
    stop_orphaned_database
    WORK="verifying"
    step "Verifying the records of the stopped server"
    # What takes seconds would spend half of them on compiling well.
    run_server_once "$LOGS/verify.log" -XX:TieredStopAtLevel=1 -- --verify-audit ${1:+"$1"} || code=$?
    case $code in
        0) note "$(verdict)" ;;
        "$EXIT_CHANGED") fail "$EXIT_CHANGED" "$(verdict)" ;;
        *) fail_from_log "$LOGS/verify.log" "$EXIT_FAILED" "The records were not verified." ;;
    esac
}

verdict() { sed -n 's/^VERDICT //p' "$LOGS/verify.log" | tail -n 1; }
