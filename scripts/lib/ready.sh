# shellcheck shell=bash
# Talking to the running server: health, readiness, what `up` and `status` tell about it.

readonly UP_SECONDS=120
readonly FLYABLE_SECONDS=60
readonly LOOKS_THAT_IT_SERVES=10

# Only this machine's own server is asked, over loopback; its certificate names the machine, not 127.0.0.1.
ask() { # PATH [CURL-OPTIONS]…
    local path=$1
    shift
    curl --silent --show-error --insecure --noproxy '*' "$@" "$(local_address)$path"
}

# The local key goes by a file: a command line can be read by every user of the machine.
ask_with_key() { # PATH [CURL-OPTIONS]…
    local path=$1
    shift
    [[ -r $KEY_FILE ]] || fail "$EXIT_RIGHTS" "The server's local key $KEY_FILE cannot be read. Run this as the user who started the server."
    ask "$path" --header "@"<(printf 'Authorization: Bearer %s\n' "$(cat "$KEY_FILE")") "$@"
}

# A number or plain word of a flat JSON text; enough for the few fields that are asked here.
json_value() { # NAME JSON
    sed -nE "s/.*\"$1\"[[:space:]]*:[[:space:]]*\"?([^\",}]*).*/\1/p" <<<"$2" | head -n 1
}

# A sentence in a JSON text may hold quotes.
json_sentence() { # NAME JSON
    sed -nE "s/.*\"$1\"[[:space:]]*:[[:space:]]*\"(([^\"\\\\]|\\\\.)*)\".*/\1/p" <<<"$2" | sed -E 's/\\(.)/\1/g' | head -n 1
}

health() { ask /api/v1/health --max-time 3 2>/dev/null || true; }

require_running() {
    is_running server || fail "$EXIT_FAILED" "The server is not running. Start it with ./dronemap up"
    adopt_running_settings
}

serves() { # HEALTH
    [[ $(json_value database "$1")$(json_value links "$1")$(json_value history "$1") == upupup ]]
}

wait_until_up() {
    local deadline=$((SECONDS + UP_SECONDS)) served=0 answer
    LAST_PROGRESS=""
    while :; do
        answer=$(health)
        if [[ $(json_value status "$answer") == up ]]; then break; fi
        # What users conduct may wait for silent drones for long; the server serves all the same.
        serves "$answer" && served=$((served + 1)) || served=0
        if ((served >= LOOKS_THAT_IT_SERVES)); then
            warn "The server serves, but not all of it is well. See ./dronemap status"
            break
        fi
        is_supervised || fail_from_server_log "The server ended while it started."
        if ((SECONDS >= deadline)); then
            fail_from_server_log "The server was not up after $UP_SECONDS s${answer:+; it says: $answer}."
        fi
        sleep 0.3
    done
    WORK=""
}

# Ready means that a demo drone can be armed, or is, when only the server was started anew.
wait_until_flyable() {
    local deadline=$((SECONDS + FLYABLE_SECONDS)) answer
    WORK="waiting for the demo fleet"
    step "Waiting until a demo drone can be flown"
    LAST_PROGRESS=""
    while :; do
        answer=$(health)
        if [[ $(json_value ready "$answer")$(json_value armed "$answer") == *[1-9]* ]]; then break; fi
        is_supervised || fail_from_server_log "The server ended while it waited for the demo fleet."
        is_running sim || fail "$EXIT_START" "The demo fleet ended by itself: $(tail -n 1 "$LOGS/sim.log"). See ./dronemap logs sim"
        ((SECONDS < deadline)) || fail "$EXIT_START" "No demo drone could be armed after $FLYABLE_SECONDS s. See ./dronemap logs and ./dronemap logs sim"
        sleep 0.3
    done
    WORK=""
    ON_INTERRUPT=""
}

# What the server wrote since it was started tells why; the usual causes get their sentence.
fail_from_server_log() { # SENTENCE
    local said
    said=$(tail -c "+$((${LOG_START:-0} + 1))" "$LOGS/server.log" 2>/dev/null || true)
    stop_everything >/dev/null
    if grep -qE 'No space left on device|could not extend file|Disk quota exceeded|[Tt]he disk (that holds .* |of the database )?is full' <<<"$said"; then
        fail "$EXIT_DISK" "$1 The disk that holds $DATA is full: make room and run ./dronemap up again."
    elif grep -qE 'Address already in use|PortInUseException' <<<"$said"; then
        fail "$EXIT_PORT" "$1 A port is taken: $(grep -m 1 -E 'Address already in use|PortInUseException' <<<"$said" | tail -c 200)"
    fi
    tail -n 15 <<<"$said" >&2
    fail "$EXIT_START" "$1 See ./dronemap logs"
}

print_welcome() {
    local answer
    answer=$(health)
    step "Dronemap is ready: $(page_address)"
    if [[ -r $FIRST_PASSWORD_FILE ]]; then
        note "First sign-in: user $(cut -d ' ' -f 1 "$FIRST_PASSWORD_FILE"), one-time password $(cut -d ' ' -f 2 "$FIRST_PASSWORD_FILE")"
        note "(You choose your own after signing in; then this line goes away.)"
    fi
    if [[ $PUBLIC == true ]]; then note "Open to the network. Certificate (SHA-256): $(fingerprint)"; fi
    if [[ -n $AUTHORITY ]]; then note "For phones: $(phone_address) (fingerprint there: $(fingerprint "$AUTHORITY"))"; fi
    if is_running php; then note "PHP page: $(php_address)"; fi
    note "Drones: $(json_value live "$answer") live, $(json_value ready "$answer") ready to be armed, $(json_value armed "$answer") armed. Vehicles connect to: ${ENDPOINTS//,/ }"
    note "Go on with: ./dronemap status | logs | down | help"
}

page_address() {
    if [[ $PUBLIC == true ]]; then
        printf '%s://%s:%s' "$(scheme)" "$(hostname)" "$HTTP_PORT"
    else
        local_address
    fi
}

# Phones seldom know machines by name: what the certificate names first is what they reach.
phone_address() {
    local name
    name=$(certificate_names | tr ',' '\n' | head -n 1)
    printf 'http://%s:%s/' "${name#*:}" "$PHONE_PORT"
}

command_status() {
    (($# == 0)) || fail "$EXIT_USAGE" "status takes no options. See ./dronemap help"
    load_settings
    local answer free
    if ! is_running server && is_running supervisor; then
        echo "The server ended by itself and is being started again: $(last_end)"
        exit "$EXIT_FAILED"
    fi
    if ! is_running server; then
        echo "Dronemap is not running. Start it with ./dronemap up"
        exit "$EXIT_FAILED"
    fi
    adopt_running_settings
    answer=$(health)
    printf '%-9s %s\n' Server "$(json_value status "$answer" | grep . || echo 'not answering') (process $(pid_of server), $(resident_megabytes) MB)" \
        Page "$(page_address)" Stream "port $STREAM_PORT" Vehicles "${ENDPOINTS//,/ }" \
        Drones "$(json_value live "$answer") live, $(json_value ready "$answer") ready to be armed, $(json_value armed "$answer") armed, $(json_value lost "$answer") lost" \
        Database "$(json_value database "$answer")" History "$(json_value history "$answer")" \
        Parts "$(what_is_down "$answer")"
    if is_running sim; then printf '%-9s %s\n' Demo "$FLEET_COUNT simulated drones (process $(pid_of sim))"; else printf '%-9s none\n' Demo; fi
    if is_running php; then printf '%-9s %s\n' PHP "$(php_address) (process $(pid_of php))"; fi
    free=$(free_megabytes "$DATA")
    printf '%-9s %s\n' Data "$DATA ($free MB free)" Build "$(is_built && echo 'up to date' || echo 'older than the sources: ./dronemap up builds anew')"
    if ((free < 100)); then warn "The disk that holds $DATA is nearly full. Make room, or the server can store nothing more."; fi
    [[ $(json_value status "$answer") == up ]] || exit "$EXIT_FAILED"
}

# Names of all that a health tells to be down.
what_is_down() { # HEALTH
    local down
    down=$(grep -oE '"[a-zA-Z0-9-]+"[[:space:]]*:[[:space:]]*"down"' <<<"$1" | cut -d '"' -f 2 | paste -sd ' ') || true
    printf '%s' "${down:+not well: }${down:-all well}"
}

# What was said last of an end that nobody wanted.
last_end() { grep -aE 'The server ends, to be started again|Terminating due to|ended by itself' "$LOGS/server.log" | tail -n 1; }

resident_megabytes() { awk '/^VmRSS/ { print int($2 / 1024) }' "/proc/$(pid_of server)/status" 2>/dev/null; }
