package org.dronemap.core.drone;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Immutable snapshot of all that is known of a drone; what was not reported is null, never a default.
 *
 * @param replay it comes from a recording: shown, never commanded
 * @param local where it is in a frame of its own; null where it has none
 * @param returnHeight null: the cloud has not set it
 * @param readyToArm the vehicle's own pre-arm checks pass, and it knows where it is, as far as it tells
 * @param messages newest last, at most {@link #MAX_MESSAGES}
 * @param version rises with every change of this drone
 * @param groundAmslMeters of the ground that it stands on, or left; what bounds above home are measured from
 */
public record DroneState(
        DroneId id,
        String name,
        boolean replay,
        LinkStatus link,
        Identification identification,
        IdentityTrust standing,
        Capabilities capabilities,
        @Nullable String mode,
        @Nullable Boolean armed,
        @Nullable Boolean readyToArm,
        @Nullable FlightPhase phase,
        @Nullable Position position,
        @Nullable LocalPosition local,
        @Nullable Motion motion,
        @Nullable Attitude attitude,
        @Nullable Battery battery,
        @Nullable Gps gps,
        @Nullable Home home,
        @Nullable ReturnHeight returnHeight,
        PayloadState payload,
        MissionProgress mission,
        List<TextMessage> messages,
        Instant lastUpdate,
        long version,
        @Nullable Double groundAmslMeters) {
    public static final int MAX_MESSAGES = 30;

    /** In the air as far as anybody knows: said so, or clearly above its home or the ground that it left. */
    public boolean airborne() {
        if (identification.kind().neverFlies()) {
            return false;
        }
        if (phase != null) {
            return phase != FlightPhase.ON_GROUND;
        }
        return Boolean.TRUE.equals(armed) && position != null && isHigh(position);
    }

    /** On the ground as far as is known; false where nothing tells. */
    public boolean isOnGround() {
        if (identification.kind().neverFlies()) {
            return true;
        }
        if (phase != null) {
            return phase == FlightPhase.ON_GROUND;
        }
        return position != null && reportsHeight(position) && !isHigh(position);
    }

    private boolean reportsHeight(Position place) {
        return place.altitudeAboveHomeMeters() != null
                || (place.altitudeAmslMeters() != null && groundAmslMeters != null);
    }

    private boolean isHigh(Position place) {
        Double above = place.altitudeAboveHomeMeters();
        Double amsl = place.altitudeAmslMeters();
        return (above != null && above > 1)
                || (amsl != null && groundAmslMeters != null && amsl - groundAmslMeters > 3);
    }
}
