package org.dronemap.core.cloud;

import java.time.Duration;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.time.Time;
import org.jspecify.annotations.Nullable;

/**
 * Detects that one drone's flight mode was changed from outside this cloud: by a pilot or another ground station. Owned
 * by the drone's lane.
 */
final class ModeWatch {
    /** A fail-safe says why it changes the mode about when it does. */
    private static final Duration SAID_WITH = Duration.ofSeconds(5);

    /** Datagrams overtake each other: what was left just before may be heard once more. */
    private static final long JUST_NANOS = Duration.ofSeconds(3).toNanos();

    private static final long STAYS_NANOS = Duration.ofMillis(1_500).toNanos();

    private final ManagedDrone drone;
    private final CommandGate gate;
    private final Time time;
    /** Those of the last seconds: a vehicle may name as many modes as it likes. */
    private final Map<String, Long> leftNanos = new HashMap<>();

    private @Nullable String last;
    /** Since when it is in a mode that may be an old one; null: it is in none. */
    private @Nullable Long doubtfulNanos;

    ModeWatch(ManagedDrone drone, CommandGate gate, Time time) {
        this.drone = drone;
        this.gate = gate;
        this.time = time;
    }

    /** The mode that somebody else has chosen since this was asked last; null: nobody has. */
    @Nullable
    String foreign(DroneState state) {
        String mode = state.link().state() == LinkState.LOST ? null : state.mode();
        // Whoever took it while it was silent, or this process was away, shows by that.
        String before = last == null ? drone.control().mode() : last;
        last = mode;
        long now = time.nanos();
        if (mode != null && mode.equals(before)) {
            return isToStay(now) ? mode : null;
        }
        doubtfulNanos = null;
        if (before == null || drone.isFirstModeOfOtherComponent()) {
            return null;
        }
        leftNanos.values().removeIf(left -> now - left >= JUST_NANOS);
        leftNanos.put(before, now);
        if (mode == null || !isForeign(state, mode)) {
            return null;
        }
        if (leftNanos.containsKey(mode)) {
            doubtfulNanos = now;
            return null;
        }
        return mode;
    }

    private boolean isToStay(long now) {
        Long since = doubtfulNanos;
        boolean stays = since != null && now - since >= STAYS_NANOS;
        if (stays) {
            doubtfulNanos = null;
        }
        return stays;
    }

    private boolean isForeign(DroneState state, String mode) {
        Steering by = state.capabilities().steering(mode).orElse(null);
        return Boolean.TRUE.equals(state.armed())
                && isNeverEnteredByItself(state.capabilities(), by)
                && !gate.mayHaveChangedTo(drone, mode, state.capabilities())
                && state.messages().stream()
                        .filter(message ->
                                message.at().isAfter(time.clock().instant().minus(SAID_WITH)))
                        .noneMatch(message -> changesModes(message.text().toLowerCase(Locale.ROOT)));
    }

    /** A fail-safe that is over, or lets the vehicle go on, explains no other mode. */
    private static boolean changesModes(String text) {
        return text.contains("failsafe") && !text.contains("continuing") && !text.contains("cleared");
    }

    /** Vehicles that have a mode to stand in go into that by themselves, and into the one that takes orders only when told. */
    private static boolean isNeverEnteredByItself(Capabilities can, @Nullable Steering by) {
        return by == Steering.STICKS
                || by == Steering.MISSION
                || (by == Steering.ORDERS && can.steering().containsValue(Steering.STANDS));
    }
}
