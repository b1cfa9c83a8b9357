package org.dronemap.core.operation;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.separation.GiveWay;
import org.jspecify.annotations.Nullable;

/**
 * Observation of an operation's drones at one moment; input of its decisions.
 *
 * @param lastReportAt when the newest {@link TargetReport} came that was fresh; null: none came since the process began
 * @param reach of who tells of them; null: not known, as when they come one by one
 * @param airspace nothing where nobody steers
 * @param refusedSetpoints drones that could not be steered, and why, as sentences
 */
public record OperationObservation(
        Instant now,
        List<ObservedDrone> drones,
        @Nullable Instant lastReportAt,
        @Nullable ReporterState reach,
        AirspaceSnapshot airspace,
        Map<DroneId, String> refusedSetpoints) {
    public OperationObservation {
        drones = List.copyOf(drones);
        refusedSetpoints = Map.copyOf(refusedSetpoints);
    }

    public OperationObservation(Instant now, List<ObservedDrone> drones) {
        this(now, drones, AirspaceSnapshot.NONE);
    }

    public OperationObservation(Instant now, List<ObservedDrone> drones, AirspaceSnapshot around) {
        this(now, drones, null, null, around, Map.of());
    }

    public Optional<ObservedDrone> of(DroneId drone) {
        return drones.stream().filter(seen -> seen.state().id().equals(drone)).findFirst();
    }

    /**
     * One drone.
     *
     * @param silence for how long nothing was heard, zero while its link is live
     * @param still for how long it has not moved from its place
     * @param giveWay to whom it gives way; null: to nobody
     */
    public record ObservedDrone(
            DroneState state,
            ControlStatus control,
            Duration silence,
            Duration still,
            @Nullable GiveWay giveWay) {
        public ObservedDrone(DroneState state, ControlStatus control, Duration silence, Duration still) {
            this(state, control, silence, still, null);
        }

        /** Why the operation may not command it, as a sentence; null: it may. */
        public @Nullable String whyNotCommandable() {
            return control.whyNotHeld() == null ? control.whyNotAllowed() : control.whyNotHeld();
        }
    }

    /**
     * Control of a drone from an operation's view, and a mission transfer that it has to wait for.
     *
     * @param whyNotHeld why the operation has not, as a sentence; null: it has
     * @param whyNotAllowed why drones are not commanded for its user any more, as a sentence, whoever has control; null: they are
     * @param owned the user whom the operation is conducted for has control, by hand
     * @param free nobody has
     * @param transfer of a mission, with that drone, which is under way, whoever asked for it, as people call it: no other one
     *     is taken before its end; null: none is
     */
    public record ControlStatus(
            @Nullable String whyNotHeld,
            @Nullable String whyNotAllowed,
            boolean owned,
            boolean free,
            @Nullable String transfer) {
        /** The user whom the operation is conducted for does not have control by hand. */
        public ControlStatus(
                @Nullable String whyNotHeld, @Nullable String whyNotAllowed, boolean free, @Nullable String transfer) {
            this(whyNotHeld, whyNotAllowed, false, free, transfer);
        }
    }
}
