package org.dronemap.core.history;

import java.time.Instant;
import java.time.InstantSource;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.ControlState;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Records states, events and flights of all drones to the history; replays are left out. Recordings that play are not
 * remembered again.
 */
public final class HistoryRecorder implements CloudListener {
    private static final Logger LOG = LoggerFactory.getLogger(HistoryRecorder.class);

    private final Persistence keeping;
    private final HistoryPolicy policy;
    private final InstantSource clock;
    private final Supplier<String> newIds;
    private final ConcurrentHashMap<DroneId, DroneHistoryRecorder> watches = new ConcurrentHashMap<>();
    private final Map<DroneId, Flight> open = new HashMap<>();

    /** Store, writer, flight registry and maintenance of the history. */
    public record Persistence(
            TelemetryStore telemetry, TelemetryWriter writer, FlightRegistry flights, HistoryMaintenance keeper) {}

    public HistoryRecorder(Persistence keeping, HistoryPolicy policy, InstantSource clock, Supplier<String> newIds) {
        this.keeping = keeping;
        this.policy = policy;
        this.clock = clock;
        this.newIds = newIds;
    }

    /** Takes up the flights that were under way; before any drone is heard. */
    public void start() {
        for (Flight flight : keeping.flights().open()) {
            Flight known = flight.state() == Flight.State.RUNNING ? interrupted(flight) : flight;
            open.put(known.drone(), known);
        }
    }

    public TelemetryStore telemetry() {
        return keeping.telemetry();
    }

    /** Called whenever events have been stored, by the thread that stores them; must return soon. */
    public void onEventsStored(Runnable listener) {
        keeping.writer().onEventsStored(listener);
    }

    public FlightRegistry flights() {
        return keeping.flights();
    }

    /** How well things are remembered at the moment. */
    public HistoryHealth health() {
        HistoryHealth health = keeping.writer().health();
        String trouble = Optional.ofNullable(health.trouble())
                .or(() -> keeping.flights().problem())
                .or(() -> keeping.keeper().trouble())
                .orElse(null);
        return new HistoryHealth(trouble, health.written(), health.dropped(), health.waiting());
    }

    @Override
    public void droneChanged(DroneState state) {
        if (!state.replay()) {
            watch(state.id()).changed(state);
        }
    }

    @Override
    public void droneRemoved(DroneId id) {
        DroneHistoryRecorder watch = watches.remove(id);
        if (watch != null) {
            watch.removed(clock.instant());
        }
    }

    @Override
    public void commandChanged(CommandRecord command) {
        watch(command.drone()).commanded(command);
    }

    @Override
    public void controlChanged(DroneId drone, ControlState now, ControlChange change) {
        watch(drone).controlled(now, change, clock.instant());
    }

    private DroneHistoryRecorder watch(DroneId drone) {
        DroneHistoryRecorder known = watches.get(drone);
        return known != null
                ? known
                : watches.computeIfAbsent(
                        drone,
                        id -> new DroneHistoryRecorder(
                                keeping.writer(),
                                policy,
                                new FlightTracker(newIds, keeping.flights()::keep, removeOpen(id))));
    }

    private @Nullable Flight removeOpen(DroneId drone) {
        synchronized (open) {
            return open.remove(drone);
        }
    }

    /** What was flown between the last time it was kept and the end of the server is among the telemetry. */
    private Flight interrupted(Flight flight) {
        FlightStatisticsBuilder meter = new FlightStatisticsBuilder(flight.measures());
        Instant[] heard = {flight.lastHeardAt()};
        try {
            TimeRange since = new TimeRange(
                    flight.lastHeardAt().plusNanos(1_000), clock.instant().plusSeconds(1));
            keeping.telemetry().points(flight.drone(), since, point -> {
                meter.add(point);
                heard[0] = point.at();
            });
        } catch (RuntimeException e) {
            LOG.warn("The last moments of flight {} before the restart cannot be read", flight.id(), e);
        }
        Flight lost = flight.with(meter.measures(), heard[0])
                .in(Flight.State.LOST, heard[0], "The server stopped while it flew.");
        keeping.flights().keep(lost);
        return lost;
    }
}
