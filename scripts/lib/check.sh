# shellcheck shell=bash
# Ports: who holds one that the server needs.

check_ports() {
    local url endpoint kind urls
    check_port tcp "$HTTP_PORT" "the page" DRONEMAP_HTTP_PORT
    check_port tcp "$STREAM_PORT" "the stream" DRONEMAP_STREAM_PORT
    if [[ $PUBLIC == true && (-z $CERTIFICATE || -n $AUTHORITY) ]]; then check_port tcp "$PHONE_PORT" "the page for phones" DRONEMAP_PHONE_PORT; fi
    IFS=, read -r -a urls <<<"$ENDPOINTS"
    for url in "${urls[@]}"; do
        endpoint=${url##*:}
        case $url in
            udpserver://*) kind=udp ;;
            tcpserver://*) kind=tcp ;;
            *) continue ;;
        esac
        check_port "$kind" "$endpoint" "vehicles ($kind)" "DRONEMAP_MAVLINK_${kind^^}"
    done
}

check_port() { # tcp|udp PORT USE SETTING [COMMAND]
    local holder
    holder=$(ss -Hlnp "--$1" "sport = :$2" 2>/dev/null | head -n 1)
    [[ -n $holder ]] || return 0
    fail "$EXIT_PORT" "Port $2 ($1), needed for $3, is taken by $(holder_name "$holder")." \
        "Stop that process, or choose another port: $4=$(($2 < 65435 ? $2 + 100 : $2 - 100)) ./dronemap ${5:-up}"
}

# ss shows processes of other users to root alone.
holder_name() { # LINE-OF-SS
    local name pid
    name=$(sed -nE 's/.*users:\(\("([^"]+)".*/\1/p' <<<"$1")
    pid=$(sed -nE 's/.*pid=([0-9]+).*/\1/p' <<<"$1")
    if [[ -n $pid ]]; then
        printf '%s (process %s)' "$name" "$pid"
    else
        printf 'a process of another user (sudo ss -lnp shows which)'
    fi
}
