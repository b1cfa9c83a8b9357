# shellcheck shell=bash
# The PHP SOAP proxy with its page, on PHP's own web server: for this machine alone.

readonly PHP_SOURCES=$ROOT/php-soap-proxy
readonly PHP_WORKERS=4
WANT_PHP=false

php_address() { printf 'http://%s:%s/' "$LOOPBACK" "$PHP_PORT"; }

# What it was started with; it reads its own files anew by itself.
php_description() { printf 'port=%s\nserver=%s\n' "$PHP_PORT" "$(local_address)"; }

start_php() {
    local wanted
    wanted=$(php_description)
    if is_running php; then
        if [[ $(cat "$DATA/php.run" 2>/dev/null) == "$wanted" ]]; then return; fi
        stop_php
    fi
    check_port tcp "$PHP_PORT" "the PHP page" DRONEMAP_PHP_PORT
    step "Starting the PHP page"
    keep_small "$LOGS/php.log"
    DRONEMAP_PHP_SERVER=$(local_address) DRONEMAP_PHP_SESSIONS=$DATA/php-sessions PHP_CLI_SERVER_WORKERS=$PHP_WORKERS \
        start_daemon php "$LOGS/php.log" php "-ddronemap.checkout=$DATA" -d opcache.enable_cli=1 -q \
        -S "$LOOPBACK:$PHP_PORT" -t "$PHP_SOURCES/public"
    until curl --silent --output /dev/null --noproxy '*' --max-time 3 "$(php_address)"; do
        is_running php || fail_from_log "$LOGS/php.log" "$EXIT_START" "The PHP page did not start."
        sleep 0.1
    done
    printf '%s\n' "$wanted" >"$DATA/php.run"
}

# Its workers belong to its group and do not end with it.
stop_php() {
    local pid
    if ! is_running php; then return; fi
    pid=$(pid_of php)
    step "Stopping the PHP page"
    kill -TERM -- "-$pid" 2>/dev/null || true
    stop_process php 10
}
