package org.dronemap.core.drone;

import java.util.List;
import org.dronemap.core.mission.FenceZone;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.core.parameter.ParameterSet;
import org.jspecify.annotations.Nullable;

/** Parameters, logs, fence and rally points on board of a vehicle; null where never read; immutable. Immutable. */
public record OnboardStorage(
        ParameterSet parameters,
        @Nullable List<VehicleLog> logs,
        @Nullable List<FenceZone> fence,
        @Nullable List<RallyPoint> rallyPoints) {
    public static final OnboardStorage UNKNOWN = new OnboardStorage(ParameterSet.NONE, null, null, null);

    public OnboardStorage withParameters(ParameterSet newer) {
        return new OnboardStorage(newer, logs, fence, rallyPoints);
    }

    public OnboardStorage withLogs(List<VehicleLog> newer) {
        return new OnboardStorage(parameters, newer, fence, rallyPoints);
    }

    public OnboardStorage withFence(List<FenceZone> newer) {
        return new OnboardStorage(parameters, logs, newer, rallyPoints);
    }

    public OnboardStorage withRallyPoints(List<RallyPoint> newer) {
        return new OnboardStorage(parameters, logs, fence, newer);
    }
}
