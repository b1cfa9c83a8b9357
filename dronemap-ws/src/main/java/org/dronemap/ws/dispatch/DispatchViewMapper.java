package org.dronemap.ws.dispatch;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import org.dronemap.cognitive.operation.CopterEndurance;
import org.dronemap.cognitive.operation.dispatch.DispatchLeg;
import org.dronemap.cognitive.operation.dispatch.DispatchStage;
import org.dronemap.cognitive.operation.dispatch.DispatchState;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Maps a dispatch, with the present position of its drone, to what clients see. Any thread. */
final class DispatchViewMapper {
    private final CloudManager cloud;

    DispatchViewMapper(CloudManager cloud) {
        this.cloud = cloud;
    }

    DispatchView view(Snapshot<DispatchState> dispatch) {
        DispatchState state = dispatch.state();
        DispatchLeg lead = state.lead();
        Instant ended = dispatch.saved().endedAt();
        boolean aside = dispatch.setAside() != null;
        return new DispatchView(
                dispatch.saved().id().value(),
                dispatch.saved().owner(),
                millis(dispatch.saved().beganAt()),
                ended == null ? null : millis(ended),
                WireNames.camel(aside ? DispatchStage.OVER : state.stage()),
                millis(state.since()),
                state.order().place().latitudeDegrees(),
                state.order().place().longitudeDegrees(),
                state.order().heightMeters(),
                state.log().note(),
                aside ? dispatch.setAside() : state.log().end(),
                lead == null ? null : lead.drone().value(),
                lead == null ? null : lead.name(),
                state.log().notices().stream()
                        .map(one -> new DispatchView.NoticeView(millis(one.at()), one.words()))
                        .toList(),
                state.returning().stream()
                        .map(leg -> new DispatchView.OtherView(leg.drone().value(), leg.name()))
                        .toList(),
                ended == null ? now(state) : null);
    }

    DispatchView.@Nullable NowView now(DispatchState state) {
        DispatchLeg lead = state.lead();
        return lead == null
                ? null
                : cloud.drone(lead.drone()).map(drone -> now(state, drone)).orElse(null);
    }

    private static DispatchView.NowView now(DispatchState state, DroneState drone) {
        Position position = drone.position();
        Geodetic point = position == null ? null : position.point();
        Double height = position == null ? null : position.altitudeAboveHomeMeters();
        Battery battery = drone.battery();
        Double away = point == null
                ? null
                : (Double) Geodesy.distanceMeters(point, state.order().place());
        return new DispatchView.NowView(
                point == null ? null : point.latitudeDegrees(),
                point == null ? null : point.longitudeDegrees(),
                height,
                away,
                away == null ? null : seconds(state, away, height),
                battery == null ? null : battery.percent());
    }

    private static @Nullable Integer seconds(DispatchState state, double away, @Nullable Double height) {
        double climb = Math.max(0, state.order().heightMeters() - (height == null ? 0 : height));
        return switch (state.stage()) {
            case CHOSEN, STARTING -> (Integer) (int) Math.ceil(CopterEndurance.secondsToCome(away, climb));
            case EN_ROUTE -> (Integer) (int) Math.ceil(CopterEndurance.secondsOfWay(away));
            case ARRIVED, HERE, SEARCHING, RETURNING, OVER -> null;
        };
    }

    private static Instant millis(Instant time) {
        return time.truncatedTo(ChronoUnit.MILLIS);
    }
}
