package org.dronemap.core.cloud.outlook;

import org.dronemap.core.cloud.rule.FlightFacts;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.lease.LapsedLease;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.lease.LeaseRules;
import org.dronemap.core.safety.ReturnEnding;
import org.jspecify.annotations.Nullable;

/** Texts for users about what happens to a flying drone when control of it ends. */
public final class OutlookMessages {
    private final LeaseRules rules;

    public OutlookMessages(LeaseRules rules) {
        this.rules = rules;
    }

    /** {@code ours}: this cloud was the last that commanded it; {@code way}: there is one to bring it down. */
    public Outlook.State state(ControlState control, DroneState state, boolean ours, boolean way) {
        Lease tenure = control.tenure();
        if (!ours || (tenure != null && tenure.holder() instanceof LeaseHolder.Pilot)) {
            return Outlook.State.LEFT_ALONE;
        }
        if (tenure != null) {
            return Outlook.State.KEPT;
        }
        if (state.capabilities().isSafe(state.mode())) {
            return Outlook.State.RETURNS;
        }
        LapsedLease lapse = control.lapse();
        if (lapse == null || !returns()) {
            return Outlook.State.LEFT_ALONE;
        }
        if (!way) {
            return Outlook.State.HELPLESS;
        }
        return lapse.returned() && !FlightFacts.isInMission(state) ? Outlook.State.RETURNS : Outlook.State.WAITS;
    }

    /** Whether a drone that nobody has is brought home at all. */
    public boolean returns() {
        return rules.onLoss() == LeaseRules.OnLoss.RETURN;
    }

    public String of(Outlook.State is, ControlState control, DroneState state) {
        Lease tenure = control.tenure();
        boolean inMission = FlightFacts.isInMission(state);
        return switch (is) {
            case KEPT -> tenure == null ? "" : ofHolder(tenure, inMission);
            case WAITS ->
                inMission
                        ? "Nobody has control of it; it flies its mission, and is brought home when that is over."
                        : "Nobody has control of it; it is brought home unless somebody takes control.";
            case RETURNS -> "Nobody has control of it; it is on its way home or down.";
            case HELPLESS -> "Nobody has control of it, and it cannot be brought home or down: take control of it.";
            case LEFT_ALONE -> leftAlone(tenure, control.lapse() != null && !returns());
        };
    }

    /** More to say of one that is brought home. */
    public static String atHome(ReturnEnding end) {
        return switch (end) {
            case LANDS, LANDS_BY_MISSION -> "";
            case CIRCLES -> " At home it circles until somebody lands it: it has no landing sequence on board.";
            case NOT_KNOWN -> " Whether it lands at home or circles there is not known: its mission was not read.";
        };
    }

    private static String leftAlone(@Nullable Lease tenure, boolean byRule) {
        if (tenure != null && tenure.holder() instanceof LeaseHolder.Pilot) {
            return "A pilot at the vehicle or another ground station flies it; this server leaves it alone.";
        }
        return byRule
                ? "Nobody has control of it, and it is not brought home: that is how this server is set."
                : "It was not commanded from here; this server leaves it alone.";
    }

    private String ofHolder(Lease tenure, boolean inMission) {
        String name = tenure.holder().words();
        String home = home(inMission);
        if (tenure.holder() instanceof LeaseHolder.Operation) {
            return name + " flies it; when that ends in the air, " + home;
        }
        return tenure.explicit()
                ? "When " + name + " gives no sign for " + rules.silence().toSeconds() + " s, " + home
                : "When " + name + " has not commanded it for " + rules.idle().toSeconds()
                        + " s and does not look at it any more, " + home;
    }

    private String home(boolean inMission) {
        if (inMission) {
            return "it flies its mission to the end" + (returns() ? " and is brought home then." : ".");
        }
        return switch (rules.onLoss()) {
            case NOTHING -> "nothing happens: that is how this server is set.";
            case HOLD -> "it holds.";
            case RETURN -> "it is brought home " + rules.untilReturn().toSeconds() + " s later.";
        };
    }
}
