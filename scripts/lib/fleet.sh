# shellcheck shell=bash
# The demo fleet: four simulated drones, so that there is something to fly at once.

readonly FLEET_COUNT=4
readonly FLEET_HOME=47.3977,8.5456

start_fleet() {
    if is_running sim; then return; fi
    step "Starting the demo fleet of $FLEET_COUNT simulated drones"
    WORK="starting the demo fleet"
    ON_INTERRUPT=${ON_INTERRUPT:-stop_fleet}
    keep_small "$LOGS/sim.log"
    start_daemon sim "$LOGS/sim.log" "$JDK/bin/java" -Xmx128m "-Ddronemap.checkout=$DATA" -jar "$APP/dronemap-sim.jar" \
        --count "$FLEET_COUNT" --connect "$(fleet_target)" --home "$FLEET_HOME"
}

# The first UDP endpoint that this machine can reach over loopback.
fleet_target() {
    local url endpoint urls
    IFS=, read -r -a urls <<<"$ENDPOINTS"
    for url in "${urls[@]}"; do
        endpoint=${url#udpserver://}
        if [[ $endpoint != "$url" ]]; then
            printf 'udp://%s:%s' "$LOOPBACK" "${endpoint##*:}"
            return
        fi
    done
    fail "$EXIT_USAGE" "The demo fleet needs a udpserver:// endpoint; DRONEMAP_ENDPOINTS has none. Add one or use --no-demo."
}

stop_fleet() {
    if is_running sim; then step "Stopping the demo fleet"; fi
    stop_process sim 10
}
