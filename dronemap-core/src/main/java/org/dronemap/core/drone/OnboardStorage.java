package org.dronemap.core.drone;

import java.util.List;
import org.dronemap.core.parameter.ParameterSet;
import org.jspecify.annotations.Nullable;

/**
 * Copy of what was read from a vehicle's memory: parameters, log list, fence and rally points; null where never read.
 * Immutable.
 */
public record OnboardStorage(
        ParameterSet parameters,
        @Nullable List<VehicleLog> logs,
        @Nullable OnboardFence fence,
        @Nullable OnboardRallyPoints rallyPoints) {
    public static final OnboardStorage UNKNOWN = new OnboardStorage(ParameterSet.NONE, null, null, null);

    public OnboardStorage withParameters(ParameterSet newer) {
        return new OnboardStorage(newer, logs, fence, rallyPoints);
    }

    public OnboardStorage withLogs(List<VehicleLog> newer) {
        return new OnboardStorage(parameters, newer, fence, rallyPoints);
    }

    public OnboardStorage withFence(OnboardFence newer) {
        return new OnboardStorage(parameters, logs, newer, rallyPoints);
    }

    public OnboardStorage withRallyPoints(OnboardRallyPoints newer) {
        return new OnboardStorage(parameters, logs, fence, newer);
    }
}
