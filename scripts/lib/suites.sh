# shellcheck shell=bash
# test and soak: runs every suite, goes on after a failure, ends with one table.

RESULTS=""      # one line for each check: suite, result, details
TEST_LOGS=""

command_test() {
    (($# == 0)) || fail "$EXIT_USAGE" "test takes no options. See ./dronemap help"
    prepare_suites
    suite_shell
    suite_typescript
    suite_java test -DexcludedGroups=soak
    record archive skipped "days of telemetry as Parquet on HDFS, and a crash in the middle: ./dronemap soak tests them"
    suite_vulnerabilities
    suite_python_checks
    suite_pytest "not soak"
    report
}

command_soak() {
    (($# == 0)) || fail "$EXIT_USAGE" "soak takes no options. See ./dronemap help"
    prepare_suites
    build_web_client
    suite_java soak -Parchive -Dgroups=soak -DexcludedGroups= -Dsurefire.failIfNoSpecifiedTests=false
    suite_pytest soak
    report
}

prepare_suites() {
    load_settings
    make_tools_folder
    take_lock
    need_space "$ROOT" "$BUILD_MEGABYTES" testing
    install_missing for-tests
    provide_test_python
    TEST_LOGS=$TOOLS/test
    RESULTS=$TEST_LOGS/results.tsv
    rm -rf "$TEST_LOGS"
    mkdir -p "$TEST_LOGS"
    : >"$RESULTS"
    SUITES_STARTED=$SECONDS
    # The tests choose their own ports and folders.
    unset DRONEMAP_DATA_DIR DRONEMAP_HTTP_PORT DRONEMAP_STREAM_PORT DRONEMAP_MAVLINK_UDP DRONEMAP_MAVLINK_TCP DRONEMAP_ENDPOINTS DRONEMAP_OUTLET DRONEMAP_OUTLET_PORTS DRONEMAP_PHONE_PORT DRONEMAP_NAMES
    DRONEMAP_CHROMIUM=$(find_chromium)
    export DRONEMAP_CHROMIUM
}

provide_test_python() {
    local wanted log=$TOOLS/logs/python.log
    wanted=$(hash_of scripts/requirements-test.txt)
    if [[ $(stamp_of python) != "$wanted" || ! -x $TOOLS/py/bin/pytest ]]; then
        WORK="installing the Python test programs"
        step "Installing the Python test programs into .tools/py"
        rm -rf "$TOOLS/py"
        run_logged "$log" no_progress make_venv "$TOOLS/py" -r "$ROOT/scripts/requirements-test.txt" ||
            fail_from_log "$log" "$EXIT_RIGHTS" "The Python test programs could not be installed."
        echo "$wanted" >"$APP/python.stamp"
        WORK=""
    fi
    PYTHON=$TOOLS/py/bin
}

# One check that passes or fails as a whole.
check() { # SUITE WHAT COMMAND…
    local suite=$1 what=$2 log
    shift 2
    log=$(log_of "$suite" "$what")
    if run_check "$suite: $what" "$log" "$@"; then record "$suite" passed "$what"; else record "$suite" failed "$what" "$log"; fi
}

# Runs, tells how it went, shows the end of the log of what failed.
run_check() { # TITLE LOG COMMAND…
    local title=$1 log=$2 started=$SECONDS
    shift 2
    WORK="testing ($title)"
    if run_logged "$log" no_progress "$@"; then
        step "$title: passed ($((SECONDS - started)) s)"
        return 0
    fi
    step "$title: FAILED ($((SECONDS - started)) s). The end of $log:"
    tail -n 60 "$log" | sed 's/^/    /'
    return 1
}

log_of() { printf '%s/%s.log' "$TEST_LOGS" "$(tr -c 'a-zA-Z0-9\n' - <<<"$1-$2")"; }

record() { # SUITE passed|failed|skipped|junit|status WHAT-OR-PATTERN [LOG]
    printf '%s\t%s\t%s\t%s\n' "$1" "$2" "$3" "${4:-}" >>"$RESULTS"
}

suite_shell() {
    local script
    # The parts under lib/ are checked as parts of ./dronemap, which sources them.
    while IFS= read -r script; do
        check shell "shellcheck ${script#./}" env -C "$ROOT" shellcheck "$script"
    done < <(cd "$ROOT" && find ./dronemap ./.ci/run ./scripts ./docker -type f \( -name '*.sh' -o -name dronemap -o -name run \) ! -path './scripts/lib/*')
}

suite_typescript() {
    build_web_client_as_check || return 0
    check typescript lint env -C "$ROOT/web-client" CI=true npm run lint
    check typescript types env -C "$ROOT/web-client" CI=true npm run check
    counted typescript units "$TEST_LOGS/vitest.xml" env -C "$ROOT/web-client" CI=true npm test -- \
        --reporter=default --reporter=junit --outputFile.junit="$TEST_LOGS/vitest.xml"
}

# In a process of its own: what ends `up` with a sentence is one failed check here.
build_web_client_as_check() {
    if (build_web_client); then
        record typescript passed build
    else
        record typescript failed build "$TOOLS/logs/build.log"
        return 1
    fi
}

# A suite whose tests are counted from its JUnit reports; its exit status counts as one more failure
# when the reports show none.
counted() { # SUITE WHAT REPORT-PATTERN COMMAND…
    local suite=$1 what=$2 pattern=$3 log status=0
    shift 3
    log=$(log_of "$suite" "$what")
    run_check "$suite: $what" "$log" "$@" || status=1
    record "$suite" junit "$pattern" "$log"
    if ((status != 0)); then record "$suite" status "$what" "$log"; fi
}

suite_java() { # GOALS-NAME OPTIONS…
    local name=$1
    shift
    rm -rf "$ROOT"/dronemap-*/target/surefire-reports
    counted "java" "$name" "$ROOT/dronemap-*/target/surefire-reports/TEST-*.xml" \
        verify_java "$@"
}

# A failed test must not keep the modules that build on it from being tested; the reports tell that it failed.
verify_java() { # OPTIONS…
    mvn -B -ntp -T 3 -fae -Dmaven.test.failure.ignore=true -f "$ROOT/pom.xml" "$@" verify &&
        ! grep -qE '<(failure|error)[ >]' "$ROOT"/dronemap-*/target/surefire-reports/TEST-*.xml
}

# Every folder with a pyproject.toml is a Python project, checked and run by its own settings.
python_projects() {
    (cd "$ROOT" && find . \( -name node_modules -o -name target -o -name '.?*' \) -prune -o -name pyproject.toml -printf '%P\n' |
        xargs -r -n 1 dirname | sort)
}

suite_python_checks() {
    local project
    while IFS= read -r project; do
        check python "ruff $project" env -C "$ROOT/$project" "$PYTHON/ruff" check --no-cache .
        check python "format $project" env -C "$ROOT/$project" "$PYTHON/ruff" format --no-cache --check .
        check python "mypy $project" env -C "$ROOT/$project" "$PYTHON/mypy" --cache-dir "$TOOLS/mypy/$project" .
    done < <(python_projects)
}

# Two test modules of different projects may share a name, so each runs apart. The jars are the ones the Java suite built.
suite_pytest() { # MARKER-EXPRESSION
    local project report
    while IFS= read -r project; do
        report=$TEST_LOGS/pytest-${project//\//-}.xml
        counted "$(suite_name "$project")" "pytest $project" "$report" \
            env -C "$ROOT/$project" PATH="$PYTHON:$PATH" "$PYTHON/python" "$ROOT/scripts/pytest_or_none.py" \
            -m "$1" --junitxml="$report" --durations=10 -p no:cacheprovider
    done < <(python_projects)
}

suite_name() { case $1 in e2e*) echo 'end to end' ;; scripts*) echo script ;; *) echo python ;; esac; }

report() {
    local status=0
    WORK=""
    step "Tested in $(((SECONDS - SUITES_STARTED) / 60)) min $(((SECONDS - SUITES_STARTED) % 60)) s. Logs: $TEST_LOGS"
    "$PYTHON/python" "$ROOT/scripts/report.py" "$RESULTS" || status=$?
    exit "$status"
}
