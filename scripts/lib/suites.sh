# shellcheck shell=bash
# test and soak: runs every suite, or what a pattern names, goes on after a failure, ends with one table.

RESULTS=""      # one line for each check: suite, result, details
TEST_LOGS=""
ONLY=""         # the pattern that tests and checks must match; empty: all
ONLY_GLOB=""    # the same as the shell matches it
ROUNDS=1
readonly MOST_ROUNDS=1000
# In a file of the scripts' tests: it asks for a checkout that is built, or for the list of what a jar holds.
readonly ASKS_FOR_JARS='^(def test_.*[( ]|    )built: Checkout|^import bill_of_materials'
# What `java: build` has done already; a compiler that asks what changed would take jars for changes.
readonly AS_BUILT=(-Dspotless.check.skip=true -Dcheckstyle.skip=true -Dmaven.compiler.useIncrementalCompilation=false)

command_test() {
    choose_tests test "$@"
    prepare_suites
    if [[ -n $ONLY ]]; then run_rounds test; else test_everything; fi
    report
}

command_soak() {
    choose_tests soak "$@"
    prepare_suites
    if [[ -n $ONLY ]]; then run_rounds soak; else soak_everything; fi
    report
}

# Java compiles with one worker while the small suites run; then its tests have all workers, and then those that need its jars.
test_everything() {
    begin_statuses
    suite_web_client
    side_by_side suite_java_build suite_small
    suite_java tests "${AS_BUILT[@]}" -DexcludedGroups=soak
    record archive skipped "days of telemetry as Parquet on HDFS, and a crash in the middle: ./dronemap soak tests them"
    suite_vulnerabilities
    suite_pytest "not soak" needs_jars
    suite_scripts with_jars
    suite_statuses
}

soak_everything() {
    build_web_client
    suite_java soak -Parchive -Dgroups=soak -DexcludedGroups= -Dsurefire.failIfNoSpecifiedTests=false
    suite_pytest soak any_project
}

# Whatever needs nothing that Java builds.
suite_small() {
    suite_shell
    suite_typescript
    suite_php
    suite_python_checks
    suite_pytest "not soak" needs_no_jars
    suite_scripts without_jars -n "$(workers_beside)"
}

choose_tests() { # test|soak [--only PATTERN | --repeat N PATTERN]
    local word=$1
    shift
    case ${1:-} in
        "") (($# == 0)) || fail "$EXIT_USAGE" "$word does not know ''. See ./dronemap help" ;;
        --only)
            (($# == 2)) || fail "$EXIT_USAGE" "--only needs one pattern (quote it if it has spaces). See ./dronemap help"
            ONLY=$2
            ;;
        --repeat)
            (($# >= 2)) && [[ $2 =~ ^[0-9]{1,4}$ ]] && ((10#$2 >= 1 && 10#$2 <= MOST_ROUNDS)) ||
                fail "$EXIT_USAGE" "--repeat is '${2:-}'; it must be a number from 1 to $MOST_ROUNDS."
            (($# == 3)) || fail "$EXIT_USAGE" "--repeat needs a number and one pattern (quote it if it has spaces). See ./dronemap help"
            ROUNDS=$((10#$2)) ONLY=$3
            ;;
        *) fail "$EXIT_USAGE" "$word does not know '$1'. See ./dronemap help" ;;
    esac
    if (($# > 0)); then
        [[ -n ${ONLY//[*[:space:]]/} ]] || fail "$EXIT_USAGE" "The pattern '$ONLY' names nothing: it must have a letter or a digit."
        # Only the star is more than itself.
        ONLY_GLOB=$(sed 's/[][?\\()|!+@&;<> ]/\\&/g' <<<"$ONLY")
    fi
}

# Whether a check belongs to what was asked for.
is_wanted() { # TITLE
    # shellcheck disable=SC2053 # the stars in it are meant
    [[ -z $ONLY || $1 == *$ONLY_GLOB* ]]
}

prepare_suites() {
    load_settings
    make_tools_folder
    take_lock
    need_space "$ROOT" "$BUILD_MEGABYTES" testing
    count_workers
    install_missing for-tests
    provide_test_python
    TEST_LOGS=$TOOLS/test
    RESULTS=$TEST_LOGS/results.tsv
    rm -rf "$TEST_LOGS"
    mkdir -p "$TEST_LOGS"
    : >"$RESULTS"
    SUITES_STARTED=$SECONDS
    # The tests choose their own ports and folders.
    unset DRONEMAP_DATA_DIR DRONEMAP_HTTP_PORT DRONEMAP_STREAM_PORT DRONEMAP_MAVLINK_UDP DRONEMAP_MAVLINK_TCP DRONEMAP_ENDPOINTS DRONEMAP_OUTLET DRONEMAP_OUTLET_PORTS DRONEMAP_PHONE_PORT DRONEMAP_PHP_PORT DRONEMAP_NAMES
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
    is_wanted "$suite: $what" || return 0
    log=$(log_of "$suite" "$what")
    if run_check "$suite: $what" "$log" "$@"; then record "$suite" passed "$what"; else record "$suite" failed "$what" "$log"; fi
}

# Runs, tells how it went, shows the end of the log of what failed.
run_check() { # TITLE LOG COMMAND…
    local title=$1 log=$2 started=$SECONDS
    shift 2
    WORK="testing ($title)"
    if run_logged "$log" no_progress "$@"; then
        say_together step "$title: passed ($((SECONDS - started)) s)"
        return 0
    fi
    say_together say_failed "$title" "$((SECONDS - started))" "$log"
    return 1
}

say_failed() { # TITLE SECONDS LOG
    step "$1: FAILED ($2 s). The end of $3:"
    tail -n 60 "$3" | sed 's/^/    /'
}

log_of() { printf '%s/%s.log' "$TEST_LOGS" "$(tr -c 'a-zA-Z0-9\n' - <<<"$1-$2")"; }

record() { # SUITE passed|failed|skipped|junit|named|status WHAT-OR-PATTERN [LOG]
    printf '%s\t%s\t%s\t%s\n' "$1" "$2" "$3" "${4:-}" >>"$RESULTS"
}

suite_shell() {
    local script
    # The parts under lib/ are checked as parts of ./dronemap, which sources them.
    while IFS= read -r script; do
        check shell "shellcheck ${script#./}" env -C "$ROOT" shellcheck "$script"
    done < <(cd "$ROOT" && find ./dronemap ./.ci/run ./scripts ./docker -type f \( -name '*.sh' -o -name dronemap -o -name run \) ! -path './scripts/lib/*')
}

# Java packs the web client into the server, so it is built before anything else is.
suite_web_client() {
    # In a process of its own: what ends `up` with a sentence is one failed check here.
    if (build_web_client); then
        record typescript passed build
    else
        record typescript failed build "$TOOLS/logs/build.log"
    fi
}

suite_typescript() {
    suite_typescript_checks
    run_vitest web-client "$(workers_beside)"
    run_vitest sdk-typescript "$(workers_beside)"
}

suite_typescript_checks() {
    check typescript lint env -C "$ROOT/web-client" CI=true npm run lint
    check typescript types env -C "$ROOT/web-client" CI=true npm run check
    # Its page has no build of its own and no packages: it is judged by the compiler of the other page.
    check typescript "types php-soap-proxy" env -C "$ROOT/web-client" npx tsc --project ../php-soap-proxy/jsconfig.json
    check typescript "lint sdk-typescript" in_typescript sdk-typescript npm run lint
    check typescript "types sdk-typescript" in_typescript sdk-typescript npm run check
    check typescript "package sdk-typescript" in_typescript sdk-typescript npm run package
}

# The client's packages are for its checks and tests alone: what builds the page needs none of them.
in_typescript() { # PROJECT COMMAND…
    local folder=$ROOT/$1 lock
    if [[ $1 == sdk-typescript ]]; then
        lock=$(hash_of sdk-typescript/package-lock.json)
        if [[ $(cat "$folder/node_modules/.dronemap-lock" 2>/dev/null) != "$lock" ]]; then
            env -C "$folder" CI=true npm ci --no-audit --no-fund && echo "$lock" >"$folder/node_modules/.dronemap-lock" || return 1
        fi
    fi
    shift
    env -C "$folder" CI=true "$@"
}

run_vitest() { # PROJECT WORKERS ARGUMENT…
    local project=$1 workers=$2 report=$TEST_LOGS/vitest-$1-${VITEST_PART:-all}.xml
    shift 2
    counted typescript "units $project${VITEST_PART:+ ($VITEST_PART)}" "$report" in_typescript "$project" npm test -- \
        --maxWorkers="$workers" --reporter=default --reporter=junit --outputFile.junit="$report" "$@"
}

# A suite whose tests are counted from its JUnit reports; its exit status counts as one more failure
# when the reports show none.
counted() { # SUITE WHAT REPORT-PATTERN COMMAND…
    local suite=$1 what=$2 pattern=$3 log status=0
    shift 3
    log=$(log_of "$suite" "$what")
    run_check "$suite: $what" "$log" "$@" || status=1
    record "$suite" "${REPORT_KIND:-junit}" "$pattern" "$log"
    if ((status != 0)); then record "$suite" status "$what" "$log"; fi
}

# All but the tests: compiles, judges form and limits, makes the jars.
suite_java_build() {
    check java build mvn -B -ntp -T "$(workers_beside)" -fae -f "$ROOT/pom.xml" -DskipTests verify
}

suite_java() { # WHAT OPTIONS…
    local what=$1
    shift
    rm -rf "$ROOT"/dronemap-*/target/surefire-reports "$TEST_LOGS/java"
    mkdir "$TEST_LOGS/java"
    counted java "$what" "$TEST_LOGS/java/TEST-*.xml" test_java "$@" test
}

# One module after the other, each with so many machines that test as there are workers: modules at the same time would each
# have as many. A failed test must not keep the modules that build on it from being tested; the reports tell that it failed.
test_java() { # OPTIONS…
    local status=0
    mvn -B -ntp -T 1 -DforkCount="$WORKERS" -fae -Dmaven.test.failure.ignore=true -f "$ROOT/pom.xml" "$@" || status=$?
    find "$ROOT"/dronemap-*/target/surefire-reports -name 'TEST-*.xml' -exec cp -t "$TEST_LOGS/java" {} + 2>/dev/null || true
    ((status == 0)) && ! grep -qE '<(failure|error)[ >]' "$TEST_LOGS"/java/TEST-*.xml
}

# Tests of Java and of e2e write into that folder with which statuses REST answers them.
begin_statuses() {
    export DRONEMAP_SEEN_STATUSES=$TEST_LOGS/seen-statuses
    mkdir "$DRONEMAP_SEEN_STATUSES"
}

# Only a whole run can tell that no test at all has seen what the description lists.
suite_statuses() {
    local tests=$ROOT/dronemap-ws/src/test/resources
    check statuses "each that is listed was seen" "$PYTHON/python" "$ROOT/scripts/listed_statuses.py" \
        "$tests/wire/openapi.json" "$tests/unseen-statuses.txt" "$DRONEMAP_SEEN_STATUSES"
}

suite_php() {
    suite_php_checks
    run_phpunit
}

suite_php_checks() {
    check php "syntax" in_php bash -c 'git ls-files "*.php" | xargs -n 1 php -l'
    check php "form" in_php phpcs
    check php "contract as the WSDL gives it" in_php bash -c 'php bin/write-contract.php && git diff --exit-code src/Contract/contract.php'
}

# Those of the group server need one: an end-to-end test runs them.
run_phpunit() { # ARGUMENT…
    counted php units "$TEST_LOGS/phpunit.xml" in_php phpunit --exclude-group server --log-junit "$TEST_LOGS/phpunit.xml" "$@"
}

in_php() { env -C "$ROOT/php-soap-proxy" "$@"; } # COMMAND…

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
suite_pytest() { # MARKER-EXPRESSION WHICH-PROJECTS
    local project
    while IFS= read -r project; do
        if "$2" "$project"; then run_pytest "$project" -m "$1"; fi
    done < <(python_projects)
}

run_pytest() { # PROJECT ARGUMENT…
    local project=$1 report=$TEST_LOGS/pytest-${1//\//-}${PYTEST_PART:+-$PYTEST_PART}.xml
    shift
    counted "$(suite_name "$project")" "pytest $project${PYTEST_PART:+ (${PYTEST_PART//_/ })}" "$report" \
        env -C "$ROOT/$project" PATH="$PYTHON:$PATH" "$PYTHON/python" "$ROOT/scripts/pytest_or_none.py" \
        --junitxml="$report" --durations=10 -p no:cacheprovider "$@"
}

# Of the scripts' own tests some files need no jars. What is not known to need them is run without: it fails if it does.
suite_scripts() { # with_jars|without_jars ARGUMENT…
    local files
    mapfile -t files < <(cd "$ROOT/scripts" && grep -lE "$ASKS_FOR_JARS" tests/test_*.py)
    if [[ $1 == without_jars ]]; then files=("${files[@]/#/--ignore=}"); fi
    PYTEST_PART=$1 run_pytest scripts -m "not soak" "${@:2}" "${files[@]}"
}

# A project that nobody named may need them. The scripts' own has files of either kind.
needs_no_jars() { [[ $1 == ros-bridge || $1 == sdk-python || $1 == signing-relay || $1 == site || $1 == dronemap-sim/exchanges ]]; } # PROJECT
needs_jars() { ! needs_no_jars "$1" && [[ $1 != scripts ]]; }

file_needs_jars() { # PROJECT FILE
    needs_jars "$1" || { [[ $1 == scripts ]] && grep -qE "$ASKS_FOR_JARS" "$ROOT/$1/$2"; }
}

any_project() { :; }

suite_name() { case $1 in e2e*) echo 'end to end' ;; scripts*) echo script ;; *) echo python ;; esac; }

report() {
    local status=0
    WORK=""
    step "Tested in $(((SECONDS - SUITES_STARTED) / 60)) min $(((SECONDS - SUITES_STARTED) % 60)) s. Logs: $TEST_LOGS"
    "$PYTHON/python" "$ROOT/scripts/report.py" --rounds "$ROUNDS" "$RESULTS" || status=$?
    exit "$status"
}
