package org.dronemap.cognitive.operation.dispatch;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.operation.dispatch.DispatchInput.Look;
import org.dronemap.cognitive.operation.dispatch.DispatchLeg.IssuedCommand;
import org.dronemap.cognitive.operation.dispatch.DispatchLeg.IssuedCommand.Purpose;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.SetReturnOnCloudLoss;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.operation.OperationAction;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.separation.GiveWay;

/** Chooses the commands for one drone of a dispatch, one at a time: make ready, arm, take off, go there, come home. */
final class LegCommands {
    /** So little below its height a drone counts as up. */
    private static final double RISEN_METERS = 3;

    private final OperationId dispatch;
    private final Instant startingSince;
    private final DispatchOrder order;
    private final List<OperationAction<DispatchInput>> actions = new ArrayList<>();
    private DispatchLeg leg;

    LegCommands(DispatchState state, DispatchLeg leg) {
        this.dispatch = state.id();
        this.order = state.order();
        this.startingSince = state.since();
        this.leg = leg;
    }

    DispatchLeg leg() {
        return leg;
    }

    List<OperationAction<DispatchInput>> actions() {
        return actions;
    }

    /** It has climbed to its height, and does what it is told. */
    boolean isUp(Look look) {
        Double height = look.place().heightMeters();
        return look.flight().airborne()
                && look.flight().guided()
                && leg.issued() == null
                && height != null
                && height >= order.heightMeters() - RISEN_METERS;
    }

    /** The next command on its way up. */
    void start(Look look, Instant at) {
        if (isBusy(at)) {
            return;
        }
        if (leg.attempts().given() == 0) {
            send(Purpose.CLOUD_LOSS, new SetReturnOnCloudLoss());
        } else if (!look.flight().guided() && look.flight().orders() != null) {
            send(Purpose.MODE, new Command.SetMode(look.flight().orders()));
        } else if (!look.flight().armed()) {
            if (look.giveWay() == null && !at.isBefore(startingSince.plus(GiveWay.SHOWN_AFTER))) {
                send(Purpose.ARM, new Command.Arm());
            }
        } else if (!look.flight().airborne()) {
            send(Purpose.TAKE_OFF, new Command.TakeOff(order.heightMeters()));
        }
    }

    /** To the place where it is wanted, told once. */
    void go(Instant at) {
        if (!leg.going() && !isBusy(at)) {
            send(Purpose.GO_TO, new Command.GoTo(order.place(), Altitude.aboveHome(order.heightMeters())));
        }
    }

    /** Home, until it is down with its motors off. */
    void home(Look look, Instant at) {
        if (isBusy(at) || look.standsAside()) {
            return;
        }
        if (!look.flight().airborne()) {
            send(Purpose.DISARM, new Command.Disarm(false));
        } else if (!look.flight().homing()) {
            send(Purpose.HOME, new Command.ReturnToLaunch());
        }
    }

    private boolean isBusy(Instant at) {
        Instant notBefore = leg.attempts().notBefore();
        return leg.issued() != null || (notBefore != null && at.isBefore(notBefore));
    }

    private void send(Purpose purpose, Command command) {
        CommandId id = new CommandId(
                dispatch + "-" + leg.number() + "-" + (leg.attempts().given() + 1));
        leg = leg.giving(new IssuedCommand(id, purpose));
        actions.add(new OperationAction.SendCommand<>(leg.drone(), id, command));
    }
}
