package org.dronemap.core.cloud;

import java.time.Clock;
import java.time.Duration;
import java.util.Locale;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.jspecify.annotations.Nullable;

/**
 * Notices that somebody else than this cloud chose the mode of one drone: a pilot with a remote control, or another ground
 * station. Owned by the drone's lane.
 */
final class ModeWatch {
    /** A fail-safe says why it changes the mode about when it does. */
    private static final Duration SAID_WITH = Duration.ofSeconds(5);

    private final ManagedDrone drone;
    private final CommandGate gate;
    private final Clock clock;
    private @Nullable String last;

    ModeWatch(ManagedDrone drone, CommandGate gate, Clock clock) {
        this.drone = drone;
        this.gate = gate;
        this.clock = clock;
    }

    /** The mode that somebody else has chosen since this was asked last; null: nobody has. */
    @Nullable
    String foreign(DroneState state) {
        String mode = state.link().state() == LinkState.LOST ? null : state.mode();
        String before = last;
        last = mode;
        return before != null && mode != null && !mode.equals(before) && isForeign(state, mode) ? mode : null;
    }

    private boolean isForeign(DroneState state, String mode) {
        Steering by = state.capabilities().steering(mode).orElse(null);
        return Boolean.TRUE.equals(state.armed())
                && isNeverEnteredByItself(state.capabilities(), by)
                && !gate.mayHaveChangedTo(drone, mode, by)
                && state.messages().stream()
                        .filter(message -> message.at().isAfter(clock.instant().minus(SAID_WITH)))
                        .noneMatch(message ->
                                message.text().toLowerCase(Locale.ROOT).contains("failsafe"));
    }

    /** Vehicles that have a mode to stand in go into that by themselves, and into the one that takes orders only when told. */
    private static boolean isNeverEnteredByItself(Capabilities can, @Nullable Steering by) {
        return by == Steering.STICKS
                || by == Steering.MISSION
                || (by == Steering.ORDERS && can.steering().containsValue(Steering.STANDS));
    }
}
