package org.dronemap.core.cloud;

import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.Control;
import org.dronemap.core.lease.Holder;
import org.dronemap.core.lease.Lapse;
import org.dronemap.core.lease.LeaseRules;
import org.dronemap.core.lease.Tenure;

/** What happens to a drone in the air when whoever has it has it no more, as a sentence. */
final class OutlookWords {
    private final LeaseRules rules;

    OutlookWords(LeaseRules rules) {
        this.rules = rules;
    }

    /** {@code ours}: this cloud was the last that commanded it; {@code inMission}: it flies one that is not over. */
    String of(Control control, DroneState state, boolean ours, boolean inMission) {
        Tenure tenure = control.tenure();
        if (tenure != null && tenure.holder() instanceof Holder.Pilot) {
            return "A pilot at the vehicle or another ground station flies it; this server leaves it alone.";
        }
        if (!ours) {
            return "It was not commanded from here; this server leaves it alone.";
        }
        if (tenure != null) {
            return ofHolder(tenure, inMission);
        }
        if (state.capabilities().isSafe(state.mode())) {
            return "Nobody has control of it; it is on its way home or down.";
        }
        Lapse lapse = control.lapse();
        if (lapse == null || rules.onLoss() != LeaseRules.OnLoss.RETURN) {
            return "Nobody has control of it, and it is not brought home: that is how this server is set.";
        }
        if (inMission) {
            return "Nobody has control of it; it flies its mission, and is brought home when that is over.";
        }
        return lapse.returned()
                ? "Nobody took control of it; it is brought home."
                : "Nobody has control of it; it is brought home unless somebody takes control.";
    }

    private String ofHolder(Tenure tenure, boolean inMission) {
        String name = tenure.holder().words();
        String home = home(inMission);
        if (tenure.holder() instanceof Holder.Operation) {
            return name + " flies it; when that ends in the air, " + home;
        }
        return tenure.explicit()
                ? "When " + name + " gives no sign for " + rules.silence().toSeconds() + " s, " + home
                : "When " + name + " has not commanded it for " + rules.idle().toSeconds()
                        + " s and does not look at it any more, " + home;
    }

    private String home(boolean inMission) {
        if (inMission) {
            return "it flies its mission to the end"
                    + (rules.onLoss() == LeaseRules.OnLoss.RETURN ? " and is brought home then." : ".");
        }
        return switch (rules.onLoss()) {
            case NOTHING -> "nothing happens: that is how this server is set.";
            case HOLD -> "it holds.";
            case RETURN -> "it is brought home " + rules.untilReturn().toSeconds() + " s later.";
        };
    }
}
