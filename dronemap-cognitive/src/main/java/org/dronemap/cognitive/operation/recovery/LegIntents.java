package org.dronemap.cognitive.operation.recovery;

import java.time.Instant;
import java.util.List;
import org.dronemap.cognitive.operation.recovery.RecoveryLeg.IssuedCommand;
import org.dronemap.cognitive.operation.recovery.RecoveryLeg.IssuedCommand.Purpose;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.separation.FlightIntent;

/** States what a recovery means one of its drones to do next. */
final class LegIntents {
    private LegIntents() {}

    static FlightIntent of(RecoveryState state, RecoveryLeg leg) {
        IssuedCommand issued = leg.issued();
        Instant since = issued == null ? state.since() : issued.at();
        Instant ready = leg.signs().readySince();
        RecoverySlot slot = leg.slot();
        boolean goes = leg.sent() == Purpose.GO_TO || ready != null;
        if (state.stage() == RecoveryStage.COMING_DOWN && goes && slot != null) {
            return new FlightIntent(
                    FlightIntent.Step.GO_ON,
                    way(leg, slot),
                    null,
                    issued != null,
                    issued == null && ready != null ? ready : since);
        }
        boolean home = leg.sent() == Purpose.RETURN || leg.sent() == Purpose.LAND;
        return new FlightIntent(
                home ? FlightIntent.Step.COME_HOME : FlightIntent.Step.STAND, List.of(), null, issued != null, since);
    }

    private static List<MissionItem> way(RecoveryLeg leg, RecoverySlot slot) {
        RecoveryStep move = leg.step().isMove() ? leg.step() : leg.step().next();
        Geodetic to = move == RecoveryStep.LEVELLING ? slot.place() : slot.comesDown();
        return List.of(new MissionItem.Waypoint(to, Altitude.aboveHome(slot.layerMeters()), 0));
    }
}
