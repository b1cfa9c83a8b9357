package org.dronemap.cognitive.operation.follow;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.operation.TakeOffPatience;
import org.dronemap.cognitive.operation.follow.FollowInput.Observation;
import org.dronemap.cognitive.operation.follow.FollowState.Attempts;
import org.dronemap.cognitive.operation.follow.FollowState.IssuedCommand;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.SetReturnOnCloudLoss;
import org.dronemap.core.operation.OperationAction;
import org.dronemap.core.separation.GiveWay;

/** Chooses the commands for a drone of a follow, one at a time: arm, take off, change mode, return home. */
final class FollowCommands {
    /** What it ends with that a follow's only drone is down. */
    static final String IT_IS_OVER = "; it is over.";

    private static final Duration PAUSE = Duration.ofSeconds(3);
    private static final int MOST_TRIES = 3;

    private FollowState state;
    private final List<OperationAction<FollowInput>> actions = new ArrayList<>();

    FollowCommands(FollowState state) {
        this.state = state;
    }

    FollowState state() {
        return state;
    }

    List<OperationAction<FollowInput>> actions() {
        return actions;
    }

    /** Up, and then it follows. */
    void start(Observation look, Instant at) {
        if (isBusy(at)) {
            return;
        }
        GiveWay give = look.giveWay();
        if (state.attempts().given() == 0) {
            send(IssuedCommand.Purpose.CLOUD_LOSS, new SetReturnOnCloudLoss());
        } else if (!look.guided()) {
            switchToGuided(look, at);
        } else if (give != null && look.waitsOnTheGround()) {
            waitOnTheGround(give, at);
        } else if (!look.armed()) {
            if (look.mayRise()) {
                state = state.noted(null);
                send(IssuedCommand.Purpose.ARM, new Command.Arm());
            }
        } else if (!look.airborne()) {
            send(
                    IssuedCommand.Purpose.TAKE_OFF,
                    new Command.TakeOff(state.order().place().heightMeters()));
        } else {
            // One that replaces another leads only once it is there.
            String what = state.reliefOrNone().number() == 0 ? "follows." : "comes.";
            state = state.to(FollowStage.TRACKING, at, state.order().chosen().name() + " is in the air and " + what);
        }
    }

    private void waitOnTheGround(GiveWay give, Instant at) {
        String name = state.order().chosen().name();
        state = TakeOffPatience.isOver(state.since(), at)
                ? state.to(FollowStage.OVER, at, TakeOffPatience.words(name, give))
                : state.noted(give.sentence(name));
    }

    /** Into the mode in which it can be led. */
    private void switchToGuided(Observation look, Instant at) {
        String orders = look.modes() == null ? null : look.modes().orders();
        if (orders == null) {
            state = state.to(
                    FollowStage.RETURNING, at, state.order().chosen().name() + " has no mode in which it can be led.");
        } else {
            send(IssuedCommand.Purpose.MODE, new Command.SetMode(orders));
        }
    }

    /** Home, and then it is over. */
    void home(Observation look, Instant at) {
        if (!look.armed()) {
            state = state.to(FollowStage.OVER, at, state.order().chosen().name() + " is down" + IT_IS_OVER);
        } else if (!isBusy(at) && !look.standsAside()) {
            if (!look.airborne()) {
                send(IssuedCommand.Purpose.DISARM, new Command.Disarm(false));
            } else if (!look.homing()) {
                send(IssuedCommand.Purpose.HOME, new Command.ReturnToLaunch());
            }
        }
    }

    private boolean isBusy(Instant at) {
        Instant notBefore = state.attempts().notBefore();
        return state.issuedCommand() != null || (notBefore != null && at.isBefore(notBefore));
    }

    private void send(IssuedCommand.Purpose kind, Command command) {
        Attempts tries = state.attempts();
        CommandId id = new CommandId(state.id() + commandInfix() + (tries.given() + 1));
        state = state.withIssuedCommand(
                new IssuedCommand(id, kind), new Attempts(tries.given() + 1, tries.failed(), null));
        actions.add(new OperationAction.SendCommand<>(state.drone(), id, command));
    }

    /** Commands of different drones of a follow are different ones. */
    private String commandInfix() {
        int number = state.reliefOrNone().number();
        return number == 0 ? "-" : "-" + number + "-";
    }

    /** A command ended; what is done about it is decided at the next look. */
    void ended(FollowInput.CommandEnded ended) {
        IssuedCommand errand = state.issuedCommand();
        if (errand == null || !errand.command().equals(ended.command())) {
            return;
        }
        String why = ended.outcome().reason();
        Attempts tries = state.attempts();
        if (errand.kind() == IssuedCommand.Purpose.CLOUD_LOSS) {
            state = state.withIssuedCommand(null, new Attempts(tries.given(), 0, null));
            state = why == null ? state : state.withNotice(ended.at(), unpreparedNotice(why));
            return;
        }
        if (why == null) {
            // What is heard of the vehicle takes a moment to say the same.
            state = state.withIssuedCommand(
                    null, new Attempts(tries.given(), 0, ended.at().plusMillis(500)));
            return;
        }
        state = state.withIssuedCommand(
                null, new Attempts(tries.given(), tries.failed() + 1, ended.at().plus(PAUSE)));
        if (state.stage() == FollowStage.STARTING && state.attempts().failed() >= MOST_TRIES) {
            state = state.to(FollowStage.RETURNING, ended.at(), "It could not be started: " + why);
        } else {
            state = state.noted("It is tried again: " + why);
        }
    }

    private String unpreparedNotice(String why) {
        return state.order().chosen().name() + " could not be told to come home when the cloud is lost (" + why
                + "): it would then stay where it is until its battery is low.";
    }
}
