package org.dronemap.core.cloud;

import java.time.Clock;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.command.CommandPhase;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.time.Time;
import org.dronemap.core.zone.Zone;
import org.dronemap.core.zone.ZoneBreachDetector;
import org.dronemap.core.zone.ZoneRegistry;
import org.dronemap.core.zone.ZoneRules;

/**
 * Watches flying drones against the zones: warns before a breach, and has the zone's action commanded on one. Each
 * drone on its own lane.
 */
final class ZoneWatch implements CloudListener {
    private static final long RHYTHM_NANOS = 100_000_000L;
    private final ZoneRegistry book;
    private final ZoneRules rules;
    private final ZoneBreachExecutor actions;
    private final Time time;
    private final Clock clock;
    private final ConcurrentHashMap<DroneId, Watched> watched = new ConcurrentHashMap<>();
    private final ConcurrentHashMap<DroneId, String> pilots = new ConcurrentHashMap<>();

    /** Owned by the drone's lane. */
    private static final class Watched {
        private final ZoneBreachDetector lookout = new ZoneBreachDetector();
        private long lookedNanos;

        Watched(long nowNanos) {
            lookedNanos = nowNanos - RHYTHM_NANOS;
        }
    }

    ZoneWatch(ZoneRegistry book, ZoneBreachExecutor actions, Time time) {
        this.book = book;
        this.rules = new ZoneRules(book);
        this.actions = actions;
        this.time = time;
        this.clock = time.clock();
    }

    @Override
    public void droneChanged(DroneState state) {
        if (book.zones().isEmpty() || state.replay()) {
            return;
        }
        if (!state.airborne()) {
            watched.remove(state.id());
            return;
        }
        long now = time.nanos();
        Watched drone = watched.computeIfAbsent(state.id(), id -> new Watched(now));
        if (now - drone.lookedNanos >= RHYTHM_NANOS) {
            drone.lookedNanos = now;
            check(drone.lookout, state, now);
        }
    }

    /** Zones were changed: nobody waits for the next position to learn what that means. Any thread. */
    void lookAgain(ManagedDrone drone) {
        drone.lane().offer(() -> droneChanged(drone.drone().state()));
    }

    private void check(ZoneBreachDetector lookout, DroneState state, long nanos) {
        List<Zone> zones = book.binding(pilot(state.id()), state.id(), clock.instant(), clock.instant());
        for (ZoneBreachDetector.Finding finding : lookout.check(zones, state, nanos)) {
            if (finding instanceof ZoneBreachDetector.Finding.Breach breach) {
                actions.breached(state, breach.zone());
            } else if (finding instanceof ZoneBreachDetector.Finding.Continuing still) {
                actions.stillBreached(state, still.zone());
            } else if (finding instanceof ZoneBreachDetector.Finding.Predicted ahead) {
                String does = ahead.zone().shape().inside() ? "leaves " : "enters ";
                actions.publishMessage(
                        state.id(),
                        Severity.WARNING,
                        String.format(
                                Locale.ROOT,
                                "If it goes on like this it %s in about %.0f s.",
                                does + ahead.zone().words(),
                                Math.ceil(ahead.seconds())));
            }
        }
    }

    private String pilot(DroneId id) {
        return pilots.getOrDefault(id, "");
    }

    @Override
    public void commandChanged(CommandRecord command) {
        Outcome outcome = command.outcome();
        boolean refused = outcome != null && outcome.kind() == Outcome.Kind.REFUSED;
        Optional<CommandKind> kind = CommandKind.named(command.type());
        if (command.face().equals(ZoneBreachExecutor.FACE) || refused || kind.isEmpty()) {
            return;
        }
        if (kind.get().purpose() == CommandKind.Purpose.FLY) {
            pilots.put(command.drone(), command.by());
        } else if (kind.get() == CommandKind.RETURN_TO_LAUNCH && command.phase() == CommandPhase.SENT) {
            actions.state(command.drone())
                    .flatMap(state -> rules.homewardDoubt(command.by(), state, clock.instant()))
                    .ifPresent(doubt -> actions.publishMessage(
                            command.drone(), Severity.WARNING, "It returns all the same, but: " + doubt));
        }
    }

    @Override
    public void droneRemoved(DroneId id) {
        watched.remove(id);
        pilots.remove(id);
    }
}
