# shellcheck shell=bash
# backup, restore, replay, password: what is asked of the running server with its local key.

ANSWER_FILE=""

# Asks and keeps the answer; returns 0 only for a status below 400.
ask_into() { # FILE PATH [CURL-OPTIONS]…
    local file=$1 path=$2 status
    shift 2
    status=$(ask_with_key "$path" --output "$file" --write-out '%{http_code}' "$@") || return 1
    ((status >= 200 && status < 400))
}

# The server's own sentence, else that it gave none.
why() { # FILE
    json_sentence detail "$(head -c 4000 "$1" 2>/dev/null | tr '\n' ' ')" | grep . || echo "The server gave no reason; see ./dronemap logs"
}

command_backup() {
    (($# == 1)) && [[ $1 != -* ]] || fail "$EXIT_USAGE" "backup needs the file to write. See ./dronemap help"
    local target
    target=$(realpath -m -- "$1")
    load_settings
    require_running
    [[ ! -e $target ]] || fail "$EXIT_FAILED" "$target exists already. Choose another name or remove it."
    [[ -d $(dirname "$target") && -w $(dirname "$target") ]] || fail "$EXIT_RIGHTS" "No file can be written in $(dirname "$target")."
    WORK="writing the backup"
    PART=$target.part
    ON_INTERRUPT=remove_part
    step "Writing the backup"
    (umask 077 && : >"$PART") || fail "$EXIT_DISK" "$PART cannot be written."
    if ! ask_into "$PART" /api/v1/backup --request POST; then
        backup_failed
    fi
    [[ $(head -c 2 "$PART") == PK ]] || backup_failed
    mv "$PART" "$target"
    note "$target ($(($(stat -c %s "$target") / 1024 + 1)) kB). Keep it safe: it holds everything that is stored."
}

backup_failed() {
    local reason
    reason=$(why "$PART")
    rm -f "$PART"
    need_space "$(dirname "$PART")" 10 "the backup"
    fail "$EXIT_FAILED" "No backup was written. $reason"
}

remove_part() { rm -f "$PART"; }

command_restore() {
    local file="" sure=false answer
    while (($# > 0)); do
        case $1 in
            --yes) sure=true ;;
            -*) fail "$EXIT_USAGE" "restore does not know '$1'. See ./dronemap help" ;;
            *) file=$1 ;;
        esac
        shift
    done
    [[ -n $file ]] || fail "$EXIT_USAGE" "restore needs the backup to read. See ./dronemap help"
    [[ -f $file && -r $file ]] || fail "$EXIT_USAGE" "There is no readable file '$file'."
    file=$(realpath -- "$file")
    load_settings
    make_folders
    take_lock
    ! is_supervised || fail "$EXIT_FAILED" "The server is running. Stop it with ./dronemap down, then restore."
    if [[ -s $RUN_FILE && $sure == false ]]; then
        [[ -t 0 ]] || fail "$EXIT_USAGE" "restore replaces everything stored in $DATA. Say --yes if that is meant."
        read -r -p "This replaces everything stored in $DATA. Go on? [y/N] " answer
        [[ $answer == [yY]* ]] || fail "$EXIT_FAILED" "Nothing was changed."
    fi
    restore_from "$file"
}

restore_from() { # FILE
    install_missing
    build_if_changed
    stop_orphaned_database
    check_data_space
    WORK="restoring"
    step "Restoring $1"
    if ! run_server_once "$LOGS/restore.log" -- --restore "$1"; then
        fail_from_log "$LOGS/restore.log" "$EXIT_FAILED" "The backup was not restored."
    fi
    [[ -s $RUN_FILE ]] || echo restored >"$RUN_FILE"
    note "Restored. Start with ./dronemap up"
}

command_replay() {
    local file="" speed=1
    while (($# > 0)); do
        case $1 in
            --speed)
                speed=${2:-}
                shift
                ;;
            -*) fail "$EXIT_USAGE" "replay does not know '$1'. See ./dronemap help" ;;
            *) file=$1 ;;
        esac
        (($# > 0)) && shift
    done
    [[ $speed =~ ^[0-9]{1,3}(\.[0-9]+)?$ ]] && awk "BEGIN { exit !($speed >= 1 && $speed <= 100) }" ||
        fail "$EXIT_USAGE" "--speed is '$speed'; it must be a number from 1 to 100."
    [[ -n $file ]] || fail "$EXIT_USAGE" "replay needs a recording (.tlog). See ./dronemap help"
    # The id of a flight that the server recorded does as well.
    [[ -f $file && -r $file || $file =~ ^[0-9]{8}T[0-9]{6}Z_[a-z0-9_-]+$ ]] || fail "$EXIT_USAGE" "There is no readable file '$file'."
    load_settings
    require_running
    play "$file" "$speed"
}

play() { # FILE SPEED
    local name
    name=$(basename "$1" | tr -c 'A-Za-z0-9._\n-' _)
    ANSWER_FILE=$(mktemp)
    trap 'rm -f "$ANSWER_FILE"' EXIT
    step "Replaying $1 at $2 times its speed (Ctrl-C ends it)"
    local question=("/api/v1/recordings/$1/replays?speed=$2" --request POST)
    if [[ -f $1 ]]; then
        question=("/api/v1/replays?speed=$2&name=$name" --request POST
            --header 'Content-Type: application/octet-stream' --data-binary "@$1")
    fi
    ask_into "$ANSWER_FILE" "${question[@]}" ||
        fail "$EXIT_FAILED" "The recording is not played. $(why "$ANSWER_FILE")"
    REPLAY=$(json_value id "$(cat "$ANSWER_FILE")")
    [[ -n $REPLAY ]] || fail "$EXIT_FAILED" "The server's answer to the recording is not understood: $(head -c 200 "$ANSWER_FILE")"
    ON_INTERRUPT=cancel_replay
    follow_replay
}

follow_replay() {
    local answer state
    LAST_PROGRESS=""
    while :; do
        ask_into "$ANSWER_FILE" "/api/v1/replays/$REPLAY" || fail "$EXIT_FAILED" "The replay cannot be followed. $(why "$ANSWER_FILE")"
        answer=$(tr '\n' ' ' <"$ANSWER_FILE")
        state=$(json_value state "$answer")
        show_progress "$(awk "BEGIN { printf \"%3.0f %%\", 100 * $(json_value progress "$answer" | grep -E '^[0-9.Ee-]+$' || echo 0) }") drones: $(replayed_drones "$answer")"
        [[ $state == running ]] || break
        sleep 1
    done
    end_progress_line
    note "$(json_value goodMessages "$answer") good messages, $(json_value brokenRuns "$answer") broken runs ($(json_value brokenBytes "$answer") bytes)"
    if [[ $state == finished && $(json_value goodMessages "$answer") == 0 ]]; then
        fail "$EXIT_FAILED" "This is no recording: it holds no MAVLink message."
    fi
    [[ $state == finished ]] || fail "$EXIT_FAILED" "The replay ended as '$state'. See ./dronemap logs"
}

replayed_drones() { # JSON
    sed -nE 's/.*"drones"[[:space:]]*:[[:space:]]*\[([^]]*)\].*/\1/p' <<<"$1" | tr -d '" '
}

cancel_replay() {
    ask_into "$ANSWER_FILE" "/api/v1/replays/$REPLAY" --request DELETE || warn "The replay could not be cancelled. $(why "$ANSWER_FILE")"
    rm -f "$ANSWER_FILE"
}

# For machines that nobody sits at: the first password changed without a browser. Passwords go by files, never by command lines.
command_password() {
    (($# == 0)) || fail "$EXIT_USAGE" "password takes no options; it asks. See ./dronemap help"
    load_settings
    require_running
    local current next again="" folder
    if [[ -r $FIRST_PASSWORD_FILE ]]; then
        current=$(cut -d ' ' -f 2 "$FIRST_PASSWORD_FILE")
    else
        current=$(read_secret "Present password of admin: ")
    fi
    next=$(read_secret "New password (10 characters or more): ")
    if [[ -t 0 ]]; then
        again=$(read_secret "Once more: ")
        [[ $next == "$again" ]] || fail "$EXIT_FAILED" "The two differ. Nothing was changed."
    fi
    folder=$(umask 077 && mktemp -d)
    # shellcheck disable=SC2064 # the folder of now
    trap "rm -rf '$folder'" EXIT
    json_object name admin password "$current" >"$folder/session"
    json_object current "$current" next "$next" >"$folder/password"
    change_password "$folder"
    step "The administrator's password is changed"
}

change_password() { # FOLDER
    local status part path=/api/v1/session
    for part in session password; do
        status=$(ask "$path" --request POST --cookie "$1/cookies" --cookie-jar "$1/cookies" \
            --header 'X-Dronemap: 1' --header 'Content-Type: application/json' --data-binary "@$1/$part" \
            --output "$1/answer" --write-out '%{http_code}') || status=0
        ((status >= 200 && status < 300)) || fail "$EXIT_FAILED" "The password was not changed. $(why "$1/answer")"
        path=/api/v1/session/password
    done
}

read_secret() { # PROMPT
    local secret
    IFS= read -r -s -p "$1" secret || fail "$EXIT_USAGE" "No password was given."
    if [[ -t 0 ]]; then printf '\n' >&2; fi
    printf '%s' "$secret"
}

json_object() { # NAME VALUE…
    local separator='{' text
    while (($# > 1)); do
        text=${2//\\/\\\\}
        printf '%s"%s":"%s"' "$separator" "$1" "${text//\"/\\\"}"
        separator=,
        shift 2
    done
    printf '}'
}
