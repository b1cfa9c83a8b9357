package org.dronemap.cognitive.operation.dispatch;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.operation.dispatch.DispatchInput.Look;
import org.dronemap.cognitive.operation.dispatch.DispatchInput.Observed;
import org.dronemap.core.operation.OperationAction;
import org.jspecify.annotations.Nullable;

/** Brings home the drones of a dispatch that do not come any more, each until it is down or somebody else has it. */
final class ReturningLegs {
    /** Who was silent for so long flies no more; if it does, it is brought home as nobody's when it is heard. */
    static final int LONGEST_SILENT_SECONDS = 600;

    private ReturningLegs() {}

    static DispatchState next(DispatchState state, Observed seen, List<OperationAction<DispatchInput>> actions) {
        DispatchState next = state;
        List<DispatchLeg> left = new ArrayList<>();
        for (DispatchLeg leg : state.returning()) {
            Look look = seen.of(leg.drone()).orElse(null);
            String gone = look == null ? leg.name() + " was removed." : whyGone(leg, look);
            if (look == null || gone != null) {
                next = next.withNotice(seen.at(), String.valueOf(gone));
                continue;
            }
            LegCommands commands = new LegCommands(state, leg);
            if (look.place().silentSeconds() == 0) {
                commands.home(look, seen.at());
            }
            String aside = look.aside(leg.name());
            next = aside == null ? next : next.noted(aside);
            actions.addAll(commands.actions());
            left.add(commands.leg());
        }
        return next.withReturning(left).overIfAllAreHome();
    }

    /** As a sentence; null: it has to be brought home still. */
    private static @Nullable String whyGone(DispatchLeg leg, Look look) {
        if (look.control().whyNotHeld() != null) {
            return leg.name() + " was taken: " + look.control().whyNotHeld();
        }
        if (look.place().silentSeconds() > 0) {
            return look.place().silentSeconds() < LONGEST_SILENT_SECONDS
                    ? null
                    : leg.name() + " has not been heard for " + LONGEST_SILENT_SECONDS / 60 + " min.";
        }
        if (!look.flight().armed()) {
            return leg.name() + " is down.";
        }
        return look.flight().steered() && look.flight().airborne()
                ? leg.name() + " was taken: a pilot flies it in "
                        + look.flight().mode() + "."
                : null;
    }
}
