# shellcheck shell=bash
# vulnerabilities: whether anything that ships has a known one.

readonly NOTHING_KNOWN=0 VULNERABLE=1 NOT_CHECKED=3

command_vulnerabilities() {
    local code=0
    (($# == 0)) || fail "$EXIT_USAGE" "vulnerabilities takes no options. See ./dronemap help"
    load_settings
    make_tools_folder
    take_lock
    install_missing
    build_if_changed
    WORK="looking for known vulnerabilities"
    step "Looking for known vulnerabilities in what ships"
    run_logged "$TOOLS/logs/vulnerabilities.log" no_progress \
        python3 "$ROOT/scripts/check_vulnerabilities.py" --jar "$APP/dronemap.jar" || code=$?
    cat "$TOOLS/logs/vulnerabilities.log"
    WORK=""
    case $code in
        "$NOTHING_KNOWN") ;;
        "$NOT_CHECKED") exit "$EXIT_UNCHECKED" ;;
        *) exit "$EXIT_FAILED" ;;
    esac
}

# What the network would say today belongs into no test: only a database that is here counts, and without one
# nothing is proved.
suite_vulnerabilities() {
    local log code=0
    log=$(log_of supply vulnerabilities)
    run_logged "$log" no_progress python3 "$ROOT/scripts/check_vulnerabilities.py" --offline || code=$?
    step "supply: $(tail -n 1 "$log")"
    case $code in
        "$NOTHING_KNOWN") record supply passed vulnerabilities ;;
        "$NOT_CHECKED") record supply skipped "$(tail -n 1 "$log")" ;;
        *) record supply failed vulnerabilities "$log" ;;
    esac
}
