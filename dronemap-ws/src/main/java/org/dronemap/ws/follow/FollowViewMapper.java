package org.dronemap.ws.follow;

import java.time.temporal.ChronoUnit;
import org.dronemap.cognitive.operation.CopterEndurance;
import org.dronemap.cognitive.operation.follow.FollowInput;
import org.dronemap.cognitive.operation.follow.FollowState;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.conduct.Operations;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.TargetReport;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Maps a follow, with the present positions of its drone and phone, to what clients see. Any thread. */
final class FollowViewMapper {
    private final CloudManager cloud;
    private final Operations operations;
    private final OperationKind<FollowState, FollowInput> kind;

    FollowViewMapper(FollowService.OperationContext conduct) {
        this.cloud = conduct.cloud();
        this.operations = conduct.operations();
        this.kind = conduct.kind();
    }

    FollowView view(Snapshot<FollowState> follow) {
        return FollowView.of(follow, follow.saved().endedAt() == null ? now(follow) : null);
    }

    private FollowView.@Nullable NowView now(Snapshot<FollowState> follow) {
        FollowState state = follow.state();
        TargetReport phone = operations.newestReport(kind, follow.saved().id()).orElse(null);
        String reach = operations
                .reporterState(kind, follow.saved().id())
                .map(WireNames::camel)
                .orElse(null);
        Geodetic home = state.order().chosen().home();
        return cloud.drone(state.drone())
                .map(drone -> now(drone, phone, home, reach))
                .orElse(null);
    }

    private static FollowView.NowView now(
            DroneState drone, @Nullable TargetReport phone, Geodetic home, @Nullable String reach) {
        Position position = drone.position();
        Geodetic point = position == null ? null : position.point();
        Battery battery = drone.battery();
        Integer percent = battery == null ? null : battery.percent();
        return new FollowView.NowView(
                point == null ? null : point(point),
                position == null ? null : position.altitudeAboveHomeMeters(),
                point == null || phone == null ? null : Geodesy.distanceMeters(point, phone.point()),
                percent,
                percent == null || point == null
                        ? null
                        : (int) CopterEndurance.secondsLeft(percent, Geodesy.distanceMeters(point, home)),
                phone == null ? null : phone(phone),
                reach);
    }

    private static FollowView.PhoneView phone(TargetReport phone) {
        return new FollowView.PhoneView(
                point(phone.point()),
                phone.accuracyMeters(),
                phone.number(),
                phone.receivedAt().truncatedTo(ChronoUnit.MILLIS));
    }

    private static FollowView.FollowPointView point(Geodetic point) {
        return new FollowView.FollowPointView(point.latitudeDegrees(), point.longitudeDegrees());
    }
}
