package org.dronemap.cognitive.operation.recovery;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dronemap.cognitive.operation.recovery.RecoveryInput.CommandEnded;
import org.dronemap.cognitive.operation.recovery.RecoveryLeg.Attempts;
import org.dronemap.cognitive.operation.recovery.RecoveryLeg.HeightSetting;
import org.dronemap.cognitive.operation.recovery.RecoveryLeg.IssuedCommand;
import org.dronemap.cognitive.operation.recovery.RecoveryLeg.IssuedCommand.Purpose;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.SetReturnHeight;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.operation.OperationAction;

/** Gives the drones of a recovery their commands, one at a time each, and judges how they ended. */
final class LegCommands {
    private static final int MOST_TRIES = 3;
    private static final Duration BETWEEN_TRIES = Duration.ofSeconds(1);
    /** What is received of the vehicle takes a moment to show the same. */
    private static final Duration SETTLING = Duration.ofMillis(500);

    private final RecoveryState state;
    private final Instant at;
    private final List<OperationAction<RecoveryInput>> actions;

    /** {@code actions}: commands are added there. */
    LegCommands(RecoveryState state, Instant at, List<OperationAction<RecoveryInput>> actions) {
        this.state = state;
        this.at = at;
        this.actions = actions;
    }

    boolean isBusy(RecoveryLeg leg) {
        Instant notBefore = leg.attempts().notBefore();
        return leg.issued() != null || (notBefore != null && at.isBefore(notBefore));
    }

    RecoveryLeg hold(RecoveryLeg leg) {
        return send(leg, Purpose.HOLD, new Command.Hold());
    }

    RecoveryLeg disarm(RecoveryLeg leg) {
        return send(leg, Purpose.DISARM, new Command.Disarm(false));
    }

    /** The vehicle's own way home is as high, also when it misses the cloud on its way. */
    RecoveryLeg setHeight(RecoveryLeg leg, double meters) {
        return send(leg, Purpose.HEIGHT, new SetReturnHeight(Math.max(0, Math.round(meters)), false));
    }

    RecoveryLeg putBackHeight(RecoveryLeg leg, double meters) {
        return send(leg, Purpose.HEIGHT, new SetReturnHeight(meters, false));
    }

    RecoveryLeg goTo(RecoveryLeg leg, RecoveryStep move, Geodetic place, double meters) {
        Command command = new Command.GoTo(place, Altitude.aboveHome(meters));
        return send(leg.at(move, Purpose.GO_TO), Purpose.GO_TO, command);
    }

    /** {@code move}: the step that it is in from now on. */
    RecoveryLeg comeDown(RecoveryLeg leg, RecoveryStep move) {
        boolean land = state.order().manner() == RecoveryManner.LAND;
        Purpose purpose = land ? Purpose.LAND : Purpose.RETURN;
        RecoveryStep step = land ? RecoveryStep.DESCENDING : move;
        RecoveryLeg moved = leg.step().isBefore(step) ? leg.at(step, purpose) : leg.sent(purpose);
        return send(moved, purpose, land ? new Command.Land() : new Command.ReturnToLaunch());
    }

    private RecoveryLeg send(RecoveryLeg leg, Purpose purpose, Command command) {
        Attempts next = new Attempts(leg.attempts().given() + 1, leg.attempts().failed(), null);
        CommandId id = new CommandId(state.id() + "-" + leg.number() + "-" + next.given());
        actions.add(new OperationAction.SendCommand<>(leg.drone(), id, command));
        return leg.with(new IssuedCommand(id, purpose, at), next);
    }

    /** The drone after its command has ended. */
    static RecoveryLeg ended(RecoveryLeg leg, IssuedCommand issued, CommandEnded ended) {
        String why = ended.outcome().reason();
        Instant at = ended.at();
        if (why == null) {
            RecoveryLeg done = leg.with(null, new Attempts(leg.attempts().given(), 0, at.plus(SETTLING)));
            return issued.purpose() == Purpose.HEIGHT ? done.with(new HeightSetting(true, null)) : done;
        }
        int failed = leg.attempts().failed() + 1;
        RecoveryLeg tried = leg.with(null, new Attempts(leg.attempts().given(), failed, at.plus(BETWEEN_TRIES)));
        if (issued.purpose() == Purpose.GO_TO) {
            tried = tried.sent(null);
        }
        return failed < MOST_TRIES
                ? tried
                : givenUp(tried.with(null, new Attempts(tried.attempts().given(), 0, at)), issued, why);
    }

    private static RecoveryLeg givenUp(RecoveryLeg leg, IssuedCommand issued, String why) {
        return switch (issued.purpose()) {
            // It is tried again, or comes home without having stopped.
            case HOLD -> leg.noted(leg.name() + " could not be stopped: " + why);
            case HEIGHT ->
                leg.with(new HeightSetting(true, null))
                        .noted("The return height of " + leg.name() + " could not be set: " + why);
            case GO_TO ->
                leg.planned(null, leg.step())
                        .noted(leg.name() + " could not be sent to its height, and returns as it is: " + why);
            case RETURN, LAND, DISARM ->
                leg.ended(RecoveryOutcome.FAILED, leg.name() + " cannot be brought down: " + why);
        };
    }
}
