package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.LeaseAnswer;
import org.dronemap.core.lease.LeaseEvent;
import org.junit.jupiter.api.Test;

/** The process is stopped for a while, as by a paused virtual machine, and goes on: what was wanted before is not done then. */
class StandstillTest extends GuidedFlightTestBase {
    private static final Duration LONG = Duration.ofSeconds(20);

    /** On the lane: what is handed to it in the same turn waits behind. */
    private void inOneTurnWithStandstill(Runnable before) {
        link.lane().execute(() -> {
            before.run();
            stalling.stall(LONG);
        });
        time.settle();
    }

    private Outcome outcome(CommandRecord command) {
        until(() -> gate.find(command.id()).orElseThrow().outcome() != null);
        return gate.find(command.id()).orElseThrow().outcome();
    }

    @Test
    void aCommandThatWaitedIsNotSent() {
        inOneTurnWithStandstill(
                () -> assertThat(gate.submit(ANN, link.id(), id("first-001"), new Command.SetMode("LOITER"))
                                .outcome())
                        .isNull());

        assertThat(outcome(gate.find(id("first-001")).orElseThrow())).isInstanceOf(Outcome.TimedOut.class);
        assertThat(vehicle.performed).doesNotContain(new Command.SetMode("LOITER"));
    }

    @Test
    void aCommandUnderWayIsNotGoneOnWith() {
        CommandRecord sent = gate.submit(ANN, link.id(), id("first-001"), new Command.SetMode("LOITER"));
        until(() -> vehicle.performed.contains(new Command.SetMode("LOITER")));
        inOneTurnWithStandstill(() -> {});

        assertThat(outcome(sent))
                .isInstanceOfSatisfying(
                        Outcome.Unknown.class,
                        unknown -> assertThat(unknown.reason()).startsWith("The server stood still for 20 s"));
        assertThat(vehicle.cancelled).contains(sent.id());
    }

    @Test
    void aHolderWhoseSignsWereDueMeanwhileHasLostControl() {
        isCommandedBy(ANN);
        apply(new LeaseEvent.TakeControl("ann"));
        long epoch = control().epoch();
        inOneTurnWithStandstill(() -> {});

        assertThat(cloud.controls()
                        .apply(link.id(), new LeaseEvent.Heartbeat("ann", epoch))
                        .answer())
                .isInstanceOf(LeaseAnswer.Denied.class);
        until(() -> changes.contains(ControlChange.Kind.LOST));
        until(() -> vehicle.performed.contains(new Command.ReturnToLaunch()));
    }

    @Test
    void nobodySteersByWhatWasSaidBefore() {
        apply(new LeaseEvent.TakeControl("ann"));
        Setpoint forward = new Setpoint.Velocity(Setpoint.Frame.VEHICLE, 3, 0, 0, Setpoint.Facing.ANY);
        inOneTurnWithStandstill(() ->
                assertThat(cloud.setpoints().steer(ANN, link.id(), forward)).isEmpty());

        assertThat(vehicle.setpoints).doesNotContain(forward);
    }

    @Test
    void whatAPilotTookMeanwhileIsLeftAlone() {
        isCommandedBy(ANN);
        apply(new LeaseEvent.TakeControl("ann"));
        awaitTick();
        inOneTurnWithStandstill(() -> {});
        hear(new DroneEvent.ModeReported("LOITER", true));

        SteppedUntil.throughout(time, Duration.ofSeconds(10), vehicle.performed::isEmpty);
    }
}
