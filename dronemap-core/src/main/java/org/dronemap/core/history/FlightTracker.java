package org.dronemap.core.history;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.lease.LeaseHolder;
import org.jspecify.annotations.Nullable;

/**
 * Detects beginnings and ends of one drone's flights from its states. Owned by the drone's {@link
 * DroneHistoryRecorder}.
 */
final class FlightTracker {
    /** A drone that was silent for longer has begun another flight, if it flies. */
    private static final Duration SAME_FLIGHT = Duration.ofHours(1);

    /** After a silence the first state shows what was known before: armed counts when it stays so. */
    private static final Duration CERTAIN = Duration.ofSeconds(3);

    private static final Duration SAVED_EVERY = Duration.ofSeconds(10);
    private static final Duration JUST = Duration.ofSeconds(60);
    /** What the cloud does by itself is nobody's command. */
    private static final String SAFETY = "safety";

    private final Supplier<String> newIds;
    private final Consumer<Flight> keep;
    private @Nullable Flight flight;
    private FlightStatisticsBuilder meter = new FlightStatisticsBuilder(FlightStatistics.NONE);
    private Instant kept = Instant.MIN;
    private @Nullable Instant foundAgainAt;
    private @Nullable CommandRecord lastCommand;
    private @Nullable ControlState control;

    /** {@code open}: the flight that was under way before a restart, null: none. */
    FlightTracker(Supplier<String> newIds, Consumer<Flight> keep, @Nullable Flight open) {
        this.newIds = newIds;
        this.keep = keep;
        this.flight = open;
        if (open != null) {
            meter = new FlightStatisticsBuilder(open.measures());
        }
    }

    /** {@code point}: when this state is one of those that are kept. */
    void changed(DroneState now, @Nullable TelemetryPoint point) {
        Flight open = flight;
        if (open == null) {
            if (isFlying(now)) {
                begin(now);
            }
        } else if (open.state() == Flight.State.LOST) {
            lookForLost(open, now);
        } else {
            follow(open, now, point);
        }
    }

    void commanded(CommandRecord command) {
        if (command.face().equals(SAFETY)) {
            return;
        }
        lastCommand = command;
        Flight open = flight;
        if (open != null && command.outcome() instanceof Outcome.Succeeded) {
            update(open, open.by(command.by()));
        }
    }

    void controlled(ControlState now) {
        control = now;
        Flight open = flight;
        if (open != null) {
            update(open, conducted(open));
        }
    }

    void removed(Instant at) {
        Flight open = flight;
        if (open != null && open.state() == Flight.State.RUNNING) {
            put(open.in(Flight.State.LOST, open.lastHeardAt(), "The drone was removed while it flew."), at);
        }
        flight = null;
    }

    private void begin(DroneState now) {
        Instant at = now.lastUpdate();
        meter = new FlightStatisticsBuilder(FlightStatistics.NONE);
        meter.add(TelemetryPoint.of(now));
        Flight begun = new Flight(
                newIds.get(),
                now.id(),
                now.name(),
                at,
                null,
                Flight.State.RUNNING,
                at,
                meter.measures(),
                List.of(),
                null,
                null,
                "");
        put(conducted(begun.by(armer(at))), at);
    }

    /** Whoever gave a command just before, unless it came to nothing. */
    private @Nullable String armer(Instant at) {
        CommandRecord command = lastCommand;
        if (command == null || Duration.between(command.at(), at).compareTo(JUST) > 0) {
            return null;
        }
        Outcome outcome = command.outcome();
        return outcome == null || outcome instanceof Outcome.Succeeded ? command.by() : null;
    }

    private Flight conducted(Flight open) {
        ControlState now = control;
        if (now == null || now.tenure() == null) {
            return open;
        }
        if (now.tenure().holder() instanceof LeaseHolder.Operation operation) {
            return open.conductedBy(new Flight.FlightOperation(operation.id(), operation.words()))
                    .by(operation.user());
        }
        return open;
    }

    private void follow(Flight open, DroneState now, @Nullable TelemetryPoint point) {
        Instant at = now.lastUpdate();
        if (now.link().state() == LinkState.LOST) {
            Instant heard = now.link().lastHeard();
            Flight measured = open.with(meter.measures(), heard == null ? open.lastHeardAt() : heard);
            put(measured.in(Flight.State.LOST, measured.lastHeardAt(), "Contact was lost in flight."), at);
            foundAgainAt = null;
        } else if (Boolean.FALSE.equals(now.armed())) {
            meter.add(TelemetryPoint.of(now));
            put(open.with(meter.measures(), at).in(Flight.State.ENDED, at, open.notice()), at);
            flight = null;
        } else if (point != null) {
            meter.add(point);
            Flight grown = open.with(meter.measures(), at);
            flight = grown;
            Duration since = Duration.between(kept, at);
            if (since.isNegative() || since.compareTo(SAVED_EVERY) >= 0) {
                put(grown, at);
            }
        }
    }

    private void lookForLost(Flight lost, DroneState now) {
        Boolean armed = now.armed();
        Instant at = now.lastUpdate();
        if (now.link().state() == LinkState.LOST || armed == null) {
            foundAgainAt = null;
        } else if (!armed) {
            put(
                    lost.in(
                            Flight.State.ENDED,
                            lost.end(),
                            "Disarmed while there was no contact; the flight is known until it was last heard."),
                    at);
            flight = null;
        } else if (foundAgainAt == null) {
            foundAgainAt = at;
        } else if (Duration.between(foundAgainAt, at).compareTo(CERTAIN) >= 0) {
            goOn(lost, now);
        }
    }

    private void goOn(Flight lost, DroneState now) {
        Instant at = now.lastUpdate();
        foundAgainAt = null;
        if (Duration.between(lost.lastHeardAt(), at).compareTo(SAME_FLIGHT) > 0) {
            flight = null;
            begin(now);
            return;
        }
        meter.add(TelemetryPoint.of(now));
        put(lost.with(meter.measures(), at).in(Flight.State.RUNNING, null, "There was no contact for a while."), at);
    }

    private void update(Flight before, Flight after) {
        if (!after.equals(before)) {
            put(after, kept);
        }
    }

    private void put(Flight now, Instant at) {
        flight = now;
        kept = at;
        keep.accept(now);
    }

    private static boolean isFlying(DroneState now) {
        return Boolean.TRUE.equals(now.armed())
                && (now.link().state() == LinkState.LIVE || now.link().state() == LinkState.SUSPECT);
    }
}
