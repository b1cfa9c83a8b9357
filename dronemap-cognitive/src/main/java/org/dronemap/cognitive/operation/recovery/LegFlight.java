package org.dronemap.cognitive.operation.recovery;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.operation.CopterEndurance;
import org.dronemap.cognitive.operation.recovery.RecoveryInput.Look;
import org.dronemap.cognitive.operation.recovery.RecoveryLeg.IssuedCommand.Purpose;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.OperationAction;
import org.dronemap.core.separation.GiveWay;

/** Decides what one drone of a recovery does next, from its part of the plan and what is seen of it. */
final class LegFlight {
    /** Who was silent for so long flies no more; if it does, it is brought home as nobody's when it is heard. */
    static final int LONGEST_SILENT_SECONDS = 600;

    private static final double AT_HEIGHT_METERS = 0.4;
    /** One that stands is there, though its height wanders. */
    private static final double NEAR_HEIGHT_METERS = 1.5;

    private static final double OVER_HOME_METERS = 3;
    /** Below this above its home one that comes down by itself is not stopped any more. */
    private static final double LOW_METERS = 8;
    /** So long the guard has time to see what it means to do, before it sets off. */
    private static final Duration LOOKING_OUT = Duration.ofMillis(700);
    /** So long it waits for drones of others; then it returns by itself, which the guard keeps apart as well. */
    private static final Duration LONGEST_YIELD = Duration.ofSeconds(30);

    private final RecoveryState state;
    private final LegCommands commands;
    private final Look look;
    private final Instant at;
    private final List<OperationAction<RecoveryInput>> actions = new ArrayList<>();
    private RecoveryLeg leg;

    LegFlight(RecoveryState state, RecoveryLeg leg, Look look, Instant at) {
        this.state = state;
        this.leg = leg;
        this.look = look;
        this.at = at;
        this.commands = new LegCommands(state, at, actions);
    }

    List<OperationAction<RecoveryInput>> actions() {
        return actions;
    }

    RecoveryLeg next() {
        if (look.whyNotHeld() != null) {
            return leg.ended(RecoveryOutcome.TAKEN, leg.name() + " was taken: " + look.whyNotHeld());
        }
        if (look.isSilent()) {
            return silent();
        }
        if (leg.signs().silentSince() != null) {
            leg = leg.silent(null).noted(null);
        }
        if (!look.flight().airborne()) {
            return onTheGround();
        }
        if (look.flight().steered() && state.stage() != RecoveryStage.STOPPING) {
            return leg.ended(
                    RecoveryOutcome.TAKEN,
                    leg.name() + " was taken: a pilot flies it in "
                            + look.flight().mode() + ".");
        }
        return switch (state.stage()) {
            case STOPPING -> stopping();
            case COMING_DOWN -> comingDown();
            case GIVING_BACK -> givingBack();
            case OVER -> leg;
        };
    }

    private RecoveryLeg silent() {
        if (look.silentSeconds() >= LONGEST_SILENT_SECONDS) {
            return leg.ended(
                    RecoveryOutcome.NOT_KNOWN,
                    leg.name() + " has not been heard for " + LONGEST_SILENT_SECONDS / 60
                            + " min; where it came down is not known.");
        }
        String words = "There is no contact with " + leg.name() + ": its own fail-safe brings it home.";
        return leg.signs().silentSince() == null ? leg.silent(at).noted(words) : leg;
    }

    private RecoveryLeg onTheGround() {
        if (leg.step() != RecoveryStep.DOWN) {
            leg = leg.at(RecoveryStep.DOWN, null).noted(null);
        }
        if (commands.isBusy(leg)) {
            return leg;
        }
        if (look.flight().armed()) {
            return commands.disarm(leg);
        }
        Double before = leg.height().beforeMeters();
        return before == null ? leg.ended(RecoveryOutcome.DOWN, null) : commands.putBackHeight(leg, before);
    }

    /** It comes down by itself, and is almost there. */
    private boolean isAlmostDown() {
        Double height = look.place().heightMeters();
        return look.flight().homing() && height != null && height < LOW_METERS;
    }

    /** It was stopped, and stands where it is. */
    boolean isStanding() {
        return leg.issued() == null
                && leg.attempts().given() > 0
                && look.flight().waits()
                && look.flight().stands();
    }

    private RecoveryLeg stopping() {
        boolean stopped = leg.attempts().given() > 0 && look.flight().waits();
        return commands.isBusy(leg) || isAlmostDown() || stopped ? leg : commands.hold(leg);
    }

    private RecoveryLeg givingBack() {
        if (commands.isBusy(leg) || isAlmostDown() || leg.step() == RecoveryStep.DESCENDING) {
            return leg;
        }
        boolean stopped = look.flight().waits() && leg.sent() == null;
        if (!stopped && leg.attempts().failed() == 0) {
            return commands.hold(leg.sent(null));
        }
        Double before = leg.height().beforeMeters();
        if (before != null) {
            return commands.putBackHeight(leg, before);
        }
        actions.add(new OperationAction.HandOver<>(leg.drone()));
        return leg.ended(RecoveryOutcome.GIVEN_BACK, null);
    }

    private RecoveryLeg comingDown() {
        leg = progressed();
        if (commands.isBusy(leg)) {
            return leg;
        }
        GiveWay give = look.giveWay();
        if (give != null && give.standsAside()) {
            RecoveryLeg stopped = isByItself() ? leg : leg.sent(null).ready(null);
            return stopped.noted(leg.name() + " gives way to " + give.toName() + ".");
        }
        leg = leg.noted(null);
        if (look.flight().homing()) {
            return leg;
        }
        RecoverySlot slot = leg.slot();
        if (slot == null || isUrgent()) {
            return commands.comeDown(leg, RecoveryStep.UNDER_WAY);
        }
        if (!leg.height().asked() && state.order().manner() == RecoveryManner.RETURN) {
            return commands.setHeight(leg, slot.layerMeters());
        }
        return move(slot);
    }

    private boolean isByItself() {
        return leg.sent() == Purpose.RETURN || leg.sent() == Purpose.LAND;
    }

    /** Its battery lasts only just, or it has waited much longer than it should. */
    private boolean isUrgent() {
        Integer percent = look.place().batteryPercent();
        double back = CopterEndurance.percentBack(homeMeters());
        return state.isOverdue(at) || (percent != null && percent < CopterEndurance.RESERVE_PERCENT + back);
    }

    private double homeMeters() {
        Geodetic point = look.place().point();
        Geodetic home = look.place().home();
        return point == null || home == null ? 0 : Geodesy.distanceMeters(point, home);
    }

    private RecoveryLeg progressed() {
        boolean over = look.place().home() != null && homeMeters() < OVER_HOME_METERS;
        return look.flight().homing() ? homing(over) : sent(over);
    }

    private RecoveryLeg homing(boolean over) {
        boolean land = state.order().manner() == RecoveryManner.LAND;
        RecoveryStep step = land || over ? RecoveryStep.DESCENDING : RecoveryStep.UNDER_WAY;
        return leg.step().isBefore(step) ? leg.at(step, land ? Purpose.LAND : Purpose.RETURN) : leg;
    }

    private RecoveryLeg sent(boolean over) {
        RecoverySlot slot = leg.slot();
        if (leg.sent() != Purpose.GO_TO
                || slot == null
                || leg.issued() != null
                || !look.flight().stands()) {
            return leg;
        }
        if (leg.step() == RecoveryStep.LEVELLING && isWithin(slot.layerMeters(), NEAR_HEIGHT_METERS)) {
            return leg.at(RecoveryStep.LEVEL, null);
        }
        return leg.step() == RecoveryStep.UNDER_WAY && over ? leg.at(RecoveryStep.OVER_HOME, null) : leg;
    }

    private boolean isAt(double meters) {
        return isWithin(meters, AT_HEIGHT_METERS);
    }

    private boolean isWithin(double meters, double by) {
        Double height = look.place().heightMeters();
        return height != null && Math.abs(height - meters) < by;
    }

    private RecoveryLeg move(RecoverySlot slot) {
        RecoveryStep step = leg.step();
        if (step.isMove()) {
            boolean goes = leg.sent() == Purpose.GO_TO;
            if (!goes) {
                return go(slot, step);
            }
            return waitsForOthers() ? commands.hold(leg.sent(null).ready(null)) : leg;
        }
        RecoveryStep next = step.next();
        return state.waitsFor(leg, next, at).isEmpty() ? go(slot, next) : leg.ready(null);
    }

    private RecoveryLeg go(RecoverySlot slot, RecoveryStep move) {
        return switch (move) {
            case LEVELLING ->
                isAt(slot.layerMeters()) ? leg.at(RecoveryStep.LEVEL, null) : goTo(move, slot.place(), slot);
            case UNDER_WAY ->
                state.waitsFor(leg, RecoveryStep.DESCENDING, at).isEmpty()
                        ? commands.comeDown(leg, move)
                        : goTo(move, slot.comesDown(), slot);
            case DESCENDING -> commands.comeDown(leg, move);
            case ALOFT, LEVEL, OVER_HOME, DOWN -> leg;
        };
    }

    /** It sets off as soon as that is clear of all drones that are none of the recovery's. */
    private RecoveryLeg goTo(RecoveryStep move, Geodetic place, RecoverySlot slot) {
        Instant since = leg.signs().readySince();
        if (since == null) {
            return leg.ready(at);
        }
        Duration ready = Duration.between(since, at);
        if (ready.compareTo(LONGEST_YIELD) > 0) {
            return commands.comeDown(leg, RecoveryStep.UNDER_WAY);
        }
        return ready.compareTo(LOOKING_OUT) < 0 || waitsForOthers()
                ? leg
                : commands.goTo(leg, move, place, slot.layerMeters());
    }

    /** Those of the recovery wait for each other as planned. */
    private boolean waitsForOthers() {
        GiveWay give = look.giveWay();
        boolean own = give != null
                && !give.to().equals(leg.drone())
                && state.leg(give.to()).isPresent();
        return give != null && give.manner() == GiveWay.Manner.WAIT && !give.clear() && !own;
    }
}
