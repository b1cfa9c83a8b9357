# shellcheck shell=bash
# up, down, status, logs: the life of the server.

DEMO=true
FOREGROUND=false
CERTIFICATE=""
PRIVATE_KEY=""
AUTHORITY=""
WANT_PUBLIC=false

command_up() {
    read_up_options "$@"
    load_settings
    make_folders
    take_lock
    if [[ $WANT_PUBLIC == true ]]; then refuse_first_password; fi
    PUBLIC=$WANT_PUBLIC
    set_bind
    install_missing
    if ! is_supervised; then check_ports; fi
    build_if_changed
    start_everything
    if [[ $FOREGROUND == true ]]; then stay; fi
}

read_up_options() {
    while (($# > 0)); do
        case $1 in
            --no-demo) DEMO=false ;;
            --php) WANT_PHP=true ;;
            --foreground) FOREGROUND=true ;;
            --public) WANT_PUBLIC=true ;;
            --cert) CERTIFICATE=$(option_file "$@") && shift || exit ;;
            --key) PRIVATE_KEY=$(option_file "$@") && shift || exit ;;
            *) fail "$EXIT_USAGE" "up does not know '$1'. See ./dronemap help" ;;
        esac
        shift
    done
    if [[ $WANT_PHP == true && $WANT_PUBLIC == true ]]; then
        fail "$EXIT_USAGE" "--php is for this machine alone. With --public let a web server with TLS run the page: php-soap-proxy/README.md"
    fi
    if [[ -n $CERTIFICATE$PRIVATE_KEY ]]; then
        [[ $WANT_PUBLIC == true ]] || fail "$EXIT_USAGE" "--cert and --key go with --public."
        [[ -n $CERTIFICATE && -n $PRIVATE_KEY ]] || fail "$EXIT_USAGE" "--cert and --key go together."
    fi
}

option_file() { # OPTION [FILE]…
    (($# > 1)) || fail "$EXIT_USAGE" "$1 needs a file."
    [[ -f $2 && -r $2 ]] || fail "$EXIT_USAGE" "$1: there is no readable file '$2'."
    realpath -- "$2"
}

start_everything() {
    provide_certificate
    local wanted
    wanted=$(run_description)
    if is_supervised && [[ $(cat "$RUN_FILE" 2>/dev/null) != "$wanted" ]]; then
        step "The server runs with another build or other settings: restarting it"
        stop_everything
        check_ports
    fi
    if is_supervised; then
        step "The server is already running (process $(pid_of server))"
    else
        start_server "$wanted"
    fi
    wait_until_up
    if [[ $DEMO == true ]]; then
        start_fleet
        wait_until_flyable
    else
        stop_fleet
    fi
    if [[ $WANT_PHP == true ]]; then start_php; else stop_php; fi
    print_welcome
}

# What a running server was started with; another description means a restart.
run_description() {
    printf 'build=%s\npublic=%s\nbind=%s\nhttp=%s\nstream=%s\nendpoints=%s\nsettings=%s\ncertificate=%s\n' "$(stamp_of jars)" \
        "$PUBLIC" "$BIND" "$HTTP_PORT" "$STREAM_PORT" "$ENDPOINTS" "$(hash_of_environment)" "$(certificate_mark)"
}

# Hashed, as the address of a database may hold its password.
hash_of_environment() {
    env | grep '^DRONEMAP_' | grep -vE '^DRONEMAP_(TEST_|SITL_|CHROMIUM|TLS_|PHP_)' | sort | sha256sum | cut -c 1-16
}

# The first start makes a database; later ones only need room to write.
check_data_space() {
    if [[ -s $RUN_FILE ]]; then
        need_space "$DATA" 100 "the database"
    else
        need_space "$DATA" 400 "the first start of the database"
    fi
}

start_server() { # DESCRIPTION
    check_data_space
    step "Starting the server"
    WORK="starting the server"
    unpack_server
    ON_INTERRUPT=stop_everything
    keep_small "$LOGS/server.log"
    # The log before this mark belongs to earlier runs.
    LOG_START=$(stat -c %s "$LOGS/server.log" 2>/dev/null || echo 0)
    local options
    read -r -a options <<<"${DRONEMAP_JAVA_OPTS:-}"
    server_environment
    # The process ends where Java says that its memory is used up, whoever would catch that; and is started again.
    start_daemon supervisor "$LOGS/server.log" "$ROOT/scripts/supervise.sh" "$DATA/server.pid" \
        "$JDK/bin/java" -Xmx384m -XX:+ExitOnOutOfMemoryError "${options[@]}" "-Ddronemap.checkout=$DATA" -jar "$SERVER"
    until is_running server || ! is_running supervisor; do sleep 0.02; done
    printf '%s\n' "$1" >"$RUN_FILE"
}

# It runs, or is about to run again.
is_supervised() { is_running supervisor || is_running server; }

# A server with its libraries beside it starts in half the time of one that has them inside. Each build has a folder
# of its own, so that none changes under a running server; those that no server runs from are removed.
unpack_server() {
    local folder old
    folder=$APP/server-$(stamp_of jars)
    SERVER=$folder/dronemap.jar
    [[ -f $SERVER ]] && return
    for old in "$APP"/server-*; do
        # Not in brackets, this very search would find itself.
        grep -qsa -- "[/]${old#/}/" /proc/[0-9]*/cmdline || rm -rf "$old"
    done
    "$JDK/bin/java" -Djarmode=tools -jar "$APP/dronemap.jar" extract --destination "$folder.new" >"$LOGS/unpack.log" 2>&1 ||
        fail_from_log "$LOGS/unpack.log" "$EXIT_START" "The server could not be unpacked into $folder."
    mv "$folder.new" "$folder"
}

# For work on what a stopped server stored; it speaks into a log.
run_server_once() { # LOG JAVA-OPTION… -- OPTION…
    local log=$1 options=()
    shift
    while [[ $1 != -- ]]; do
        options+=("$1")
        shift
    done
    shift
    unpack_server
    server_environment
    run_logged "$log" no_progress "$JDK/bin/java" -Xmx384m "${options[@]}" "-Ddronemap.checkout=$DATA" -jar "$SERVER" "$@"
}

server_environment() {
    export DRONEMAP_DATA_DIR=$DATA DRONEMAP_HTTP_PORT=$HTTP_PORT DRONEMAP_STREAM_PORT=$STREAM_PORT
    export DRONEMAP_BIND=$BIND DRONEMAP_ENDPOINTS=$ENDPOINTS DRONEMAP_PUBLIC=$PUBLIC
    if [[ $PUBLIC == true ]]; then
        export DRONEMAP_TLS_CERT=$CERTIFICATE DRONEMAP_TLS_KEY=$PRIVATE_KEY
        if [[ -n $AUTHORITY ]]; then export DRONEMAP_TLS_AUTHORITY=$AUTHORITY DRONEMAP_PHONE_PORT=$PHONE_PORT; fi
    fi
}

# Detached from this terminal; the process id is kept for the next run. Until it has become the program that was asked for,
# which a busy machine does late, the process is a copy of this shell: whoever looks for the program then misses it.
start_daemon() { # NAME LOG COMMAND…
    local name=$1 log=$2 pid
    shift 2
    (umask 077 && cd "$DATA" && exec setsid nohup "$@" </dev/null >>"$log" 2>&1 {LOCK}>&-) &
    pid=$!
    echo "$pid" >"$DATA/$name.pid"
    disown "$pid"
    until is_running "$name" || ! kill -0 "$pid" 2>/dev/null; do sleep 0.02; done
}

keep_small() { # LOG
    if [[ -f $1 ]] && (($(stat -c %s "$1") > 20000000)); then mv -f "$1" "$1.1"; fi
}

pid_of() { cat "$DATA/$1.pid" 2>/dev/null || true; }

# A process id can be given anew after a crash: the command line must be ours too.
is_running() { # supervisor|server|sim|php
    local pid
    pid=$(pid_of "$1")
    [[ -n $pid && -r /proc/$pid/cmdline ]] && tr '\0' ' ' <"/proc/$pid/cmdline" | grep -qiF -- "-Ddronemap.checkout=$DATA "
}

command_down() {
    (($# == 0)) || fail "$EXIT_USAGE" "down takes no options. See ./dronemap help"
    load_settings
    if ! is_supervised && ! is_running sim && ! is_running php; then
        rm -f "$DATA"/{supervisor,server,sim,php}.pid
        stop_orphaned_database
        step "Dronemap is not running"
        return
    fi
    warn_of_armed_drones
    stop_everything
    step "Dronemap is stopped"
}

# What flies goes on flying without the cloud; whoever stops the cloud should know.
warn_of_armed_drones() {
    local armed
    is_running server || return 0
    adopt_running_settings
    armed=$(json_value armed "$(health)")
    if [[ ${armed:-0} =~ ^[1-9] ]]; then
        warn "Armed when last heard: $armed. Real drones go on without the cloud, each as its own fail-safe says; simulated ones end here."
    fi
}

stop_everything() {
    stop_php
    stop_fleet
    # It hands the signal on, and ends when the server has.
    stop_process supervisor 40
    stop_process server 40
    stop_orphaned_database
}

stop_process() { # NAME SECONDS
    local pid tries
    pid=$(pid_of "$1")
    if is_running "$1"; then
        kill -TERM "$pid" 2>/dev/null || fail "$EXIT_RIGHTS" "Process $pid belongs to $(stat -c %U "/proc/$pid"). Run this as that user."
        for ((tries = 0; tries < $2 * 5; tries++)); do
            is_running "$1" || break
            sleep 0.2
        done
        if is_running "$1"; then
            warn "The $1 (process $pid) did not stop within $2 s and was killed; what it had acknowledged is stored."
            kill -KILL "$pid" 2>/dev/null || true
        fi
    fi
    rm -f "$DATA/$1.pid"
}

# A killed server leaves its own PostgreSQL behind; SIGINT is PostgreSQL's orderly, fast shutdown.
stop_orphaned_database() {
    local file pid
    while IFS= read -r file; do
        pid=$(head -n 1 "$file")
        if [[ $pid =~ ^[0-9]+$ && $(readlink "/proc/$pid/cwd" 2>/dev/null) == "$(dirname "$file")" ]]; then
            kill -INT "$pid" 2>/dev/null || true
            timeout 20 tail --pid="$pid" -f /dev/null || true
        fi
    done < <(find "$DATA" -maxdepth 4 -name postmaster.pid 2>/dev/null)
}

# For containers and service managers: lives and dies with the server.
stay() {
    WORK=""
    ON_INTERRUPT=stop_everything
    note "Stays until interrupted (Ctrl-C)."
    while is_running supervisor; do sleep 1; done
    stop_everything
    fail "$EXIT_START" "The server was stopped, or its supervisor ended. See ./dronemap logs"
}

command_logs() {
    local follow=() what=server file
    while (($# > 0)); do
        case $1 in
            -f | --follow) follow=(-F) ;;
            server | sim | php | build) what=$1 ;;
            *) fail "$EXIT_USAGE" "logs does not know '$1'. See ./dronemap help" ;;
        esac
        shift
    done
    load_settings
    file=$LOGS/$what.log
    if [[ $what == build ]]; then file=$TOOLS/logs/build.log; fi
    [[ -r $file ]] || fail "$EXIT_FAILED" "There is no log $file yet."
    trap - INT
    exec tail -n 200 "${follow[@]}" -- "$file"
}
