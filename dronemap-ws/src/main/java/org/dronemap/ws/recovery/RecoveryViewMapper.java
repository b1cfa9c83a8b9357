package org.dronemap.ws.recovery;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Comparator;
import java.util.List;
import org.dronemap.cognitive.operation.recovery.RecoveryLeg;
import org.dronemap.cognitive.operation.recovery.RecoverySlot;
import org.dronemap.cognitive.operation.recovery.RecoveryStage;
import org.dronemap.cognitive.operation.recovery.RecoveryState;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Maps a recovery to what clients see. */
final class RecoveryViewMapper {
    private RecoveryViewMapper() {}

    static RecoveryView view(Snapshot<RecoveryState> recovery, Instant now) {
        RecoveryState state = recovery.state();
        Instant ended = recovery.saved().endedAt();
        boolean aside = recovery.setAside() != null;
        return new RecoveryView(
                recovery.saved().id().value(),
                recovery.saved().owner(),
                millis(recovery.saved().beganAt()),
                ended == null ? null : millis(ended),
                WireNames.camel(state.order().manner()),
                WireNames.camel(aside ? RecoveryStage.OVER : state.stage()),
                millis(state.since()),
                state.order().lowestMeters(),
                state.order().ceilingMeters(),
                state.legs().stream()
                        .sorted(Comparator.comparingDouble(RecoveryViewMapper::downSeconds))
                        .map(leg -> leg(state, leg, now))
                        .toList(),
                state.notices().stream()
                        .map(one -> new RecoveryView.NoticeView(millis(one.at()), one.words()))
                        .toList(),
                aside ? recovery.setAside() : state.end());
    }

    private static double downSeconds(RecoveryLeg leg) {
        RecoverySlot slot = leg.slot();
        return slot == null ? Double.MAX_VALUE : slot.downSeconds();
    }

    private static RecoveryView.LegView leg(RecoveryState state, RecoveryLeg leg, Instant now) {
        RecoveryLeg.LegEnd end = leg.end();
        return new RecoveryView.LegView(
                leg.drone().value(),
                leg.name(),
                WireNames.camel(leg.step()),
                end == null ? null : WireNames.camel(end.outcome()),
                end == null ? leg.signs().note() : end.why(),
                state.stage() == RecoveryStage.COMING_DOWN ? names(state.waitsFor(leg, now)) : List.of(),
                part(leg.slot()));
    }

    private static List<String> names(List<RecoveryLeg> legs) {
        return legs.stream().map(RecoveryLeg::name).toList();
    }

    static RecoveryView.@Nullable PartView part(@Nullable RecoverySlot slot) {
        return slot == null
                ? null
                : new RecoveryView.PartView(
                        slot.comesDown().latitudeDegrees(),
                        slot.comesDown().longitudeDegrees(),
                        slot.layerMeters(),
                        Math.round(slot.startSeconds()),
                        Math.round(slot.downSeconds()));
    }

    private static Instant millis(Instant time) {
        return time.truncatedTo(ChronoUnit.MILLIS);
    }
}
