package org.dronemap.core.virtual;

import java.util.Set;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.VehicleKind;
import org.jspecify.annotations.Nullable;

/**
 * Requirements that a real drone must meet to serve a virtual drone or a follow.
 *
 * @param kind null: any
 * @param capabilities beside what a mission takes anyway
 * @param enduranceMinutes in the air with what is in its battery now, reserve included; null: what the mission takes
 * @param area where it has to stand; null: anywhere
 */
public record DroneRequirements(
        @Nullable VehicleKind kind,
        Set<Capability> capabilities,
        @Nullable Integer enduranceMinutes,
        @Nullable RequiredArea area) {
    /** Any drone that can fly the mission. */
    public static final DroneRequirements NONE = new DroneRequirements(null, Set.of(), null, null);

    public static final int LONGEST_ENDURANCE_MINUTES = 1_440;

    public DroneRequirements {
        capabilities = Set.copyOf(capabilities);
        if (enduranceMinutes != null && (enduranceMinutes < 1 || enduranceMinutes > LONGEST_ENDURANCE_MINUTES)) {
            throw new IllegalArgumentException("an endurance must be 1 to 1440 minutes: " + enduranceMinutes);
        }
    }
}
