# shellcheck shell=bash
# test and soak with a pattern: only what matches, once or several times.

PLAN=""   # one line for each match: language, where it is, what to choose there

run_rounds() { # test|soak
    local kind=$1 round folder=$TEST_LOGS
    plan_tests "$kind"
    for ((round = 1; round <= ROUNDS; round++)); do
        if ((ROUNDS > 1)); then
            step "Round $round of $ROUNDS"
            TEST_LOGS=$folder/round-$round
            mkdir "$TEST_LOGS"
        fi
        run_round "$kind"
        [[ -s $RESULTS ]] || fail "$EXIT_USAGE" "Nothing matches '$ONLY' (in $kind): no test and no check has a name that it is a part of." \
            "Names are written as PATH::TEST; capital letters count. See docs/testing.md"
    done
    TEST_LOGS=$folder
}

plan_tests() { # test|soak
    local log=$TEST_LOGS/plan.log projects
    PLAN=$TEST_LOGS/plan.tsv
    mapfile -t projects < <(python_projects)
    WORK="looking for tests that match '$ONLY'"
    "$PYTHON/python" "$ROOT/scripts/only.py" "$1" "$ONLY" "${projects[@]}" >"$PLAN" 2>"$log" ||
        fail "$EXIT_FAILED" "$(tail -n 1 "$log") Details: $log"
    step "$(tail -n 1 "$log")"
    if [[ -n $(planned java) ]]; then build_web_client; fi
    if any_needs_jars; then provide_jars; fi
}

any_needs_jars() {
    local project file
    while IFS=$'\t' read -r project file; do
        if file_needs_jars "$project" "$file"; then return 0; fi
    done < <(planned pytest | sed 's/::.*//' | sort -u)
    return 1
}

planned() { sed -n "s/^$1\t//p" "$PLAN"; } # LANGUAGE

# The tests take the jars from where Maven makes them; those of another state of the sources may lie there.
provide_jars() {
    local jar kept
    build_if_changed
    for jar in dronemap-ws/target/dronemap.jar dronemap-sim/target/dronemap-sim.jar; do
        kept=$APP/$(basename "$jar")
        if ! cmp -s "$kept" "$ROOT/$jar"; then
            mkdir -p "$(dirname "$ROOT/$jar")"
            cp "$kept" "$ROOT/$jar"
        fi
    done
}

run_round() { # test|soak
    if [[ $1 == test ]]; then
        suite_shell
        suite_typescript_checks
        suite_php_checks
        suite_python_checks
        suite_java_build
        if is_wanted "supply: vulnerabilities"; then suite_vulnerabilities; fi
    fi
    round_of_java "$1"
    round_of_vitest
    round_of_phpunit
    round_of_pytest "$1"
}

round_of_java() { # test|soak
    local modules tests options=(-DexcludedGroups=soak)
    modules=$(planned java | cut -f 1 | sort -u | paste -sd,)
    tests=$(planned java | cut -f 2 | paste -sd,)
    [[ -n $modules ]] || return 0
    if [[ $1 == soak ]]; then options=(-Parchive -Dgroups=soak -DexcludedGroups=); fi
    suite_java tests -Dspotless.check.skip=true -Dcheckstyle.skip=true "${options[@]}" \
        -pl "$modules" -am -Dtest="$tests" -Dsurefire.failIfNoSpecifiedTests=false
}

# Files that match as a whole, then single tests of others, which are chosen by their names.
round_of_vitest() {
    local project
    while IFS= read -r project; do round_of_project "$project"; done < <(planned vitest | cut -f 1 | sort -u)
}

round_of_project() { # PROJECT
    local project=$1 files names
    mapfile -t files < <(planned vitest | awk -F '\t' -v wanted="$project" '$1 == wanted && $3 == "" { print $2 }' | sort -u)
    if ((${#files[@]} > 0)); then VITEST_PART=files run_vitest "$project" "$WORKERS" "${files[@]}"; fi
    mapfile -t files < <(planned vitest | awk -F '\t' -v wanted="$project" '$1 == wanted && $3 != "" { print $2 }' | sort -u)
    names=$(planned vitest | awk -F '\t' -v wanted="$project" '$1 == wanted && $3 != "" { print $3 }' | sort -u | paste -sd '|')
    if ((${#files[@]} > 0)); then
        REPORT_KIND=named VITEST_PART=names run_vitest "$project" "$WORKERS" "${files[@]}" --testNamePattern "^($names)\$"
    fi
}

round_of_phpunit() {
    local names
    names=$(planned phpunit | paste -sd '|')
    [[ -z $names ]] || run_phpunit --filter "/::($names)\b/"
}

round_of_pytest() { # test|soak
    local project tests workers marker="not soak"
    if [[ $1 == soak ]]; then marker=soak; fi
    while IFS= read -r project; do
        mapfile -t tests < <(planned pytest | awk -F '\t' -v wanted="$project" '$1 == wanted { print $2 }')
        # One file is for one worker: others would only start.
        workers=$(printf '%s\n' "${tests[@]%%::*}" | sort -u | wc -l)
        if ((workers == 1)); then workers=0; elif ((workers > WORKERS)); then workers=$WORKERS; fi
        run_pytest "$project" -n "$workers" -m "$marker" "${tests[@]}"
    done < <(planned pytest | cut -f 1 | sort -u)
}
