package org.dronemap.core.history;

import java.time.Instant;
import org.dronemap.core.drone.Attitude;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Gps;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.Position;
import org.jspecify.annotations.Nullable;

/**
 * One stored state of a drone at one moment; unknown values are null.
 *
 * @param missionItem index of the item that it heads for
 */
public record TelemetryPoint(
        DroneId drone,
        Instant at,
        @Nullable Position position,
        @Nullable Motion motion,
        @Nullable Attitude attitude,
        @Nullable Battery battery,
        @Nullable Gps gps,
        LinkState link,
        LinkQuality quality,
        @Nullable String mode,
        @Nullable Boolean armed,
        @Nullable FlightPhase phase,
        @Nullable Integer missionItem) {
    /** Shares the parts of the state, which are immutable. */
    public static TelemetryPoint of(DroneState state) {
        return new TelemetryPoint(
                state.id(),
                state.lastUpdate(),
                state.position(),
                state.motion(),
                state.attitude(),
                state.battery(),
                state.gps(),
                state.link().state(),
                state.link().quality(),
                state.mode(),
                state.armed(),
                state.phase(),
                state.mission().current());
    }
}
