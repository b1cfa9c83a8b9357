package org.dronemap.proxy.outlet;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.ControlStatus;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Ground stations that know MAVLink's operator control: who has it, asks for it, gets it and keeps it. */
class OperatorControlTest {
    private static final int CONTROL = 32_100;
    private static final int ACCEPTED = 0;
    private static final int DENIED = 2;
    private static final int FAILED = 4;

    private final OutletTestBench house = new OutletTestBench();

    OperatorControlTest() throws IOException {}

    @AfterEach
    void close() throws IOException {
        house.close();
    }

    @Test
    void whoAsksForFreeControlHasItAndEverybodyIsToldWho() {
        OutletTestBench.Station ann = house.new Station("ann", 254);
        OutletTestBench.Station eve = house.new Station("eve", 255);
        awaitStatus(ann, ControlStatus.SYSTEM_MANAGER | ControlStatus.TAKEOVER_ALLOWED, 0);
        assertThat(asks(ann, 1, 0)).isEqualTo(ACCEPTED);
        assertThat(house.control().isHeldBy("ann")).isTrue();
        assertThat(tenure().explicit()).isTrue();
        awaitStatus(ann, ControlStatus.SYSTEM_MANAGER, 254);
        // To her station it is somebody else: not herself, not a vehicle.
        awaitStatus(eve, ControlStatus.SYSTEM_MANAGER, 254);
        assertThat(asks(ann, 0, 0)).isEqualTo(ACCEPTED);
        assertThat(house.control().tenure()).isNull();
        awaitStatus(ann, ControlStatus.SYSTEM_MANAGER | ControlStatus.TAKEOVER_ALLOWED, 0);
    }

    @Test
    void whoAsksTheHolderIsRefusedUntilTheHolderLetsGo() {
        OutletTestBench.Station ann = house.new Station("ann", 255);
        OutletTestBench.Station bob = house.new Station("bob", 253);
        assertThat(asks(ann, 1, 0)).isEqualTo(ACCEPTED);
        assertThat(asks(bob, 1, 0)).isEqualTo(FAILED);
        house.await(() -> !ann.of(CommandLong.ID).isEmpty(), "she is not asked");
        CommandLong question = CommandLong.decode(ann.of(CommandLong.ID).get(0));
        assertThat(question.targetSystem()).isEqualTo(255);
        assertThat(question.param1()).isEqualTo(1);
        assertThat(question.param4()).isEqualTo(254);
        ann.awaitText("bob asks for control: through a ground station.");
        assertThat(house.control().isHeldBy("ann")).isTrue();

        assertThat(asks(ann, 1, 1)).isEqualTo(ACCEPTED);
        assertThat(house.control().isHeldBy("bob")).isTrue();
        awaitStatus(bob, ControlStatus.SYSTEM_MANAGER, 253);
        awaitStatus(ann, ControlStatus.SYSTEM_MANAGER, 254);
        bob.awaitText("ann gave you control.");
        assertThat(asks(ann, 0, 0)).isEqualTo(DENIED);
    }

    @Test
    void heartbeatsKeepWhatWasTakenAndNothingElseDoes() {
        OutletTestBench.Station ann = house.new Station("ann", 255);
        OutletTestBench.Station other = house.new Station("ann", 252);
        assertThat(asks(ann, 1, 0)).isEqualTo(ACCEPTED);
        long before = tenure().renewedNanos();
        // A heartbeat at the moment of the take would keep nothing that anybody could see.
        house.letPass(Duration.ofMillis(300));
        other.says(OutletTestBench.GROUND);
        assertThat(asks(other, 2, 0)).isEqualTo(DENIED);
        assertThat(tenure().renewedNanos()).isEqualTo(before);
        ann.says(OutletTestBench.GROUND);
        house.await(() -> tenure().renewedNanos() > before, "the heartbeat keeps nothing");
        // What another window took is its own to keep.
        house.control(new LeaseEvent.TakeControl("ann"));
        assertThat(asks(ann, 1, 0)).isEqualTo(ACCEPTED);
        assertThat(house.control().isHeldBy("ann")).isTrue();
    }

    @Test
    void aSecondRequestOfTheHolderDoesNotEndWhatTheFirstBegan() {
        OutletTestBench.Station ann = house.new Station("ann", 255);
        assertThat(asks(ann, 1, 0)).isEqualTo(ACCEPTED);
        long epoch = house.control().epoch();
        assertThat(asks(ann, 1, 0)).isEqualTo(ACCEPTED);
        assertThat(house.control().epoch()).isEqualTo(epoch);
    }

    @Test
    void whoMayOnlyLookHasNoControl() {
        OutletTestBench.Station eve = house.new Station("eve", 255);
        assertThat(asks(eve, 1, 0)).isEqualTo(DENIED);
        eve.awaitText("Your role may not have control of it.");
        assertThat(asks(eve, 0, 0)).isEqualTo(DENIED);
        assertThat(house.control().tenure()).isNull();
    }

    private Lease tenure() {
        return Objects.requireNonNull(house.control().tenure());
    }

    /** The result of asking for control, or of giving it back. */
    private static int asks(OutletTestBench.Station station, int action, int allowTakeover) {
        CommandLong question = new CommandLong(1, 1, CONTROL, 0, action, allowTakeover, 10, 0, 0, 0, 0);
        return CommandAck.decode(station.answer(CommandAck.ID, question)).result();
    }

    private void awaitStatus(OutletTestBench.Station station, int flags, int inControl) {
        ControlStatus wanted = new ControlStatus(flags, inControl);
        house.await(() -> wanted.equals(last(station)), wanted + " is not told");
    }

    /** Null when nothing was told yet. */
    private static ControlStatus last(OutletTestBench.Station station) {
        List<Frame> told = station.of(ControlStatus.ID);
        return told.isEmpty() ? null : ControlStatus.decode(told.get(told.size() - 1));
    }
}
