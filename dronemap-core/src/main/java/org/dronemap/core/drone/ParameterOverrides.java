package org.dronemap.core.drone;

import java.time.Instant;
import java.util.List;
import org.dronemap.core.parameter.OverriddenParameter;
import org.jspecify.annotations.Nullable;

/**
 * The owner's parameter values that the cloud has overridden on one drone, until they are restored.
 *
 * @param droneName as it was called then: this outlives the drone
 * @param returnMeters how high it flies home meanwhile; null: not known
 * @param written the cloud's own values are on board: what they are found as from now on is no owner's
 */
public record ParameterOverrides(
        DroneId drone,
        String droneName,
        Instant since,
        @Nullable Double returnMeters,
        boolean written,
        List<OverriddenParameter> values) {
    public ParameterOverrides {
        values = List.copyOf(values);
    }

    public ParameterOverrides returningAt(double meters) {
        return new ParameterOverrides(drone, droneName, since, meters, written, values);
    }

    public ParameterOverrides asWritten(boolean nowWritten) {
        return new ParameterOverrides(drone, droneName, since, returnMeters, nowWritten, values);
    }
}
