# shellcheck shell=bash
# Building: the web client first, then the two jars; only what changed.
# Programs run from copies in .tools/app, so that a build never changes a jar under a running server.

readonly BUILD_MEGABYTES=2048

command_build() {
    (($# == 0)) || fail "$EXIT_USAGE" "build takes no options. See ./dronemap help"
    load_settings
    make_tools_folder
    take_lock
    install_missing
    build_if_changed
    step "Built"
}

# Hash over names and contents of the files that a build reads.
hash_of() { # PATH…
    (cd "$ROOT" && find "$@" \( -name node_modules -o -name target -o -name dist -o -name coverage -o -name test-results \) -prune \
        -o -type f ! -name '*.log' -print0 2>/dev/null | sort -z | xargs -0 sha256sum | sha256sum | cut -c 1-16)
}

hash_of_sources() {
    (cd "$ROOT" && hash_of pom.xml .mvn config dronemap-*/pom.xml dronemap-*/src/main web-client sdk-typescript/src)
}

# The page is built of its own sources and of the TypeScript client's.
hash_of_page() { hash_of web-client sdk-typescript/src; }

stamp_of() { cat "$APP/$1.stamp" 2>/dev/null || true; }

is_built() { [[ -f $APP/dronemap.jar && -f $APP/dronemap-sim.jar && $(stamp_of jars) == "$(hash_of_sources)" ]]; }

build_if_changed() {
    if is_built; then return; fi
    need_space "$ROOT" "$BUILD_MEGABYTES" building
    local started=$SECONDS
    build_web_client
    build_jars
    note "Built in $((SECONDS - started)) s"
}

build_web_client() {
    local stamp
    install_web_packages
    stamp=$(hash_of_page)
    if [[ $(stamp_of web) == "$stamp" && -f $ROOT/web-client/dist/index.html ]]; then return; fi
    WORK="building the web client"
    step "Building the web client"
    rm -f "$APP/web.stamp"
    in_web_client build.log npm run build || fail_from_log "$TOOLS/logs/build.log" "$EXIT_BUILD" "The web client does not build."
    echo "$stamp" >"$APP/web.stamp"
    WORK=""
}

install_web_packages() {
    local lock
    lock=$(hash_of web-client/package-lock.json)
    if [[ $(cat "$ROOT/web-client/node_modules/.dronemap-lock" 2>/dev/null) == "$lock" ]]; then return; fi
    WORK="downloading the web client's packages"
    step "Downloading the web client's packages"
    # npm's own waits between tries add up to a minute and a half of silence when there is no network.
    in_web_client npm.log npm ci --no-audit --no-fund --fetch-retry-mintimeout=1000 --fetch-retry-maxtimeout=5000 ||
        fail_from_log "$TOOLS/logs/npm.log" "$EXIT_BUILD" "The web client's packages could not be installed."
    echo "$lock" >"$ROOT/web-client/node_modules/.dronemap-lock"
    WORK=""
}

in_web_client() { # LOG COMMAND…
    local log=$TOOLS/logs/$1
    shift
    run_logged "$log" no_progress env -C "$ROOT/web-client" CI=true "$@"
}

build_jars() {
    local stamp log=$TOOLS/logs/build.log
    stamp=$(hash_of_sources)
    WORK="building the server"
    step "Building the server (the first time this downloads about 200 MB and takes a few minutes)"
    run_logged "$log" maven_progress mvn -B -ntp -f "$ROOT/pom.xml" -Pfast -pl dronemap-ws,dronemap-sim -am package ||
        fail_from_log "$log" "$EXIT_BUILD" "The server does not build."
    keep_jars
    echo "$stamp" >"$APP/jars.stamp"
    WORK=""
}

maven_progress() { # LOG
    show_progress "$(sed -nE 's/^\[INFO\] Building (.*[^ ]) +\[([0-9]+)\/([0-9]+)\]$/\1 (\2 of \3)/p' "$1" | tail -n 1)"
}

# Renaming leaves a running server its own, unlinked file.
keep_jars() {
    local jar
    rm -f "$APP/jars.stamp"
    for jar in dronemap-ws/target/dronemap.jar dronemap-sim/target/dronemap-sim.jar; do
        [[ -f $ROOT/$jar ]] || fail "$EXIT_BUILD" "The build made no $jar."
        cp "$ROOT/$jar" "$APP/$(basename "$jar").new" ||
            fail "$EXIT_DISK" "The disk that holds $APP is full. Make room and run the same command again."
        mv "$APP/$(basename "$jar").new" "$APP/$(basename "$jar")"
    done
}
