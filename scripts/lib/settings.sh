# shellcheck shell=bash
# Settings: from the environment, with the defaults that `help` states; checked once.

readonly TOOLS=$ROOT/.tools
readonly APP=$TOOLS/app
readonly LOOPBACK=127.0.0.1

load_settings() {
    DATA=$(realpath -m -- "${DRONEMAP_DATA_DIR:-$ROOT/.data}")
    HTTP_PORT=$(port_setting DRONEMAP_HTTP_PORT 8080) || exit
    STREAM_PORT=$(port_setting DRONEMAP_STREAM_PORT 8081) || exit
    PHONE_PORT=$(port_setting DRONEMAP_PHONE_PORT 8082) || exit
    PHP_PORT=$(port_setting DRONEMAP_PHP_PORT 8083) || exit
    MAVLINK_UDP=$(port_setting DRONEMAP_MAVLINK_UDP 14550) || exit
    MAVLINK_TCP=$(port_setting DRONEMAP_MAVLINK_TCP 5760) || exit
    LOGS=$DATA/logs
    RUN_FILE=$DATA/server.run
    FIRST_PASSWORD_FILE=$DATA/first-password.txt
    KEY_FILE=$DATA/local-key
    PUBLIC=false
    set_bind
}

# Commands that talk to a running server find it where it is, whatever the environment says now.
adopt_running_settings() {
    is_running server || return 0
    PUBLIC=$(started_with public)
    HTTP_PORT=$(started_with http)
    STREAM_PORT=$(started_with stream)
    ENDPOINTS=$(started_with endpoints)
}

started_with() { sed -n "s/^$1=//p" "$RUN_FILE"; }

port_setting() { # NAME DEFAULT
    local value=${!1:-$2}
    [[ $value =~ ^[0-9]{1,5}$ ]] && ((value >= 1 && value <= 65535)) ||
        fail "$EXIT_USAGE" "$1 is '$value'; it must be a port from 1 to 65535."
    printf '%s' "$value"
}

# In a container the engine's published ports say who can reach it; anywhere else only --public leaves loopback.
set_bind() {
    BIND=$LOOPBACK
    if [[ $PUBLIC == true ]]; then
        BIND=0.0.0.0
    elif [[ -n ${DRONEMAP_BIND:-} && $DRONEMAP_BIND != 127.* && $DRONEMAP_BIND != localhost ]]; then
        in_container || fail "$EXIT_USAGE" "DRONEMAP_BIND is '$DRONEMAP_BIND': to leave loopback use ./dronemap up --public."
        BIND=$DRONEMAP_BIND
    fi
    ENDPOINTS=${DRONEMAP_ENDPOINTS:-udpserver://$BIND:$MAVLINK_UDP,tcpserver://$BIND:$MAVLINK_TCP}
}

# `container` is how container engines and systemd tell the programs inside.
in_container() { [[ -n ${container:-} ]]; }

scheme() { if [[ $PUBLIC == true ]]; then printf https; else printf http; fi; }
local_address() { printf '%s://%s:%s' "$(scheme)" "$LOOPBACK" "$HTTP_PORT"; }

# Folders that hold keys and passwords are for their owner alone.
make_folders() {
    (umask 077 && mkdir -p "$DATA" "$LOGS") 2>/dev/null && [[ -w $DATA && -w $LOGS ]] ||
        fail_to_write "$DATA" "or choose another folder with DRONEMAP_DATA_DIR"
    make_tools_folder
}

make_tools_folder() {
    mkdir -p "$APP" "$TOOLS/logs" 2>/dev/null && [[ -w $TOOLS/logs && -w $APP ]] ||
        fail_to_write "$TOOLS" "or clone the project to a folder of your own"
}

fail_to_write() { # PATH WHAT-ELSE
    local near=$1
    while [[ ! -e $near ]]; do near=$(dirname "$near"); done
    if [[ $(free_megabytes "$near") -lt 1 ]]; then
        fail "$EXIT_DISK" "The disk that holds $1 is full. Make room and run the same command again."
    fi
    fail "$EXIT_RIGHTS" "The user $(id -un) may not write to $1. Run this as its owner ($(stat -c %U "$near")), $2."
}
