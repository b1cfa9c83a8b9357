package org.dronemap.core.drone;

import java.util.List;
import org.dronemap.core.mission.FenceZone;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.core.parameter.ParameterSet;
import org.jspecify.annotations.Nullable;

/** Parameters, logs, fence and rally points on board of a vehicle; null where never read; immutable. Immutable. */
public record OnBoard(
        ParameterSet parameters,
        @Nullable List<VehicleLog> logs,
        @Nullable List<FenceZone> fence,
        @Nullable List<RallyPoint> rallyPoints) {
    public static final OnBoard UNKNOWN = new OnBoard(ParameterSet.NONE, null, null, null);

    public OnBoard withParameters(ParameterSet newer) {
        return new OnBoard(newer, logs, fence, rallyPoints);
    }

    public OnBoard withLogs(List<VehicleLog> newer) {
        return new OnBoard(parameters, newer, fence, rallyPoints);
    }

    public OnBoard withFence(List<FenceZone> newer) {
        return new OnBoard(parameters, logs, newer, rallyPoints);
    }

    public OnBoard withRallyPoints(List<RallyPoint> newer) {
        return new OnBoard(parameters, logs, fence, newer);
    }
}
