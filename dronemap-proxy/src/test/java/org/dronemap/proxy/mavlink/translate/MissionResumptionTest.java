package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.MissionCurrent;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionSetCurrent;
import org.dronemap.proxy.mavlink.procedure.TestWire;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Where a mission that is started goes on: by how far the vehicle says that it is, not by its height. */
class MissionResumptionTest {
    private static final int ARDUPILOT = 3;
    private static final int PX4 = 12;
    private static final int ROVER = 10;
    private static final int QUADROTOR = 2;
    private static final int HOLD = 4;
    private static final int AUTO = 10;
    private static final int COMPLETE = 5;
    private static final int ITEMS = 6;
    private static final int DO_SET_MODE = 176;
    private static final Command START = new Command.StartMission(MissionCloudLossPolicy.CONTINUE);
    private static final Command ANEW = new Command.StartMission(MissionCloudLossPolicy.CONTINUE, true);

    private static AutopilotTestBench vehicle(int type, int autopilot, long mode) {
        AutopilotTestBench bench = new AutopilotTestBench(new Heartbeat(type, autopilot, 209, mode, 4, 3));
        bench.wire.peer((wire, message) -> answer(bench, wire, message, type, autopilot));
        bench.status.missionRead(List.of(item(0), item(1), item(2), item(3), item(4), item(5)));
        return bench;
    }

    private static AutopilotTestBench rover() {
        return vehicle(ROVER, ARDUPILOT, HOLD);
    }

    private static MissionItemInt item(int seq) {
        return new MissionItemInt(1, 1, seq, 3, 16, 0, 1, 0f, 0f, 0f, 0f, 460_000_000 + seq, 70_000_000, 0f, 0);
    }

    private static void answer(AutopilotTestBench bench, TestWire wire, Message message, int type, int autopilot) {
        if (message instanceof MissionSetCurrent asked) {
            int seq = autopilot == ARDUPILOT ? Math.max(1, asked.seq()) : asked.seq();
            bench.status.current(seq, 0);
            wire.answer(new MissionCurrent(seq, ITEMS, 0, 0));
        } else if (message instanceof CommandLong command) {
            wire.answer(new CommandAck(command.command(), 0, 0, 0, 255, 190));
            if (command.command() == DO_SET_MODE) {
                long mode = autopilot == ARDUPILOT
                        ? (long) command.param2()
                        : (long) command.param2() << 16 | (long) command.param3() << 24;
                Heartbeat now = new Heartbeat(type, autopilot, 209, mode, 4, 3);
                bench.status.heartbeat(now, AutopilotAdapter.of(now).modeName(now));
                wire.answer(now);
            }
        }
    }

    private static List<Integer> sentTo(AutopilotTestBench bench, Command command) {
        assertThat(bench.perform(command)).isInstanceOf(Outcome.Succeeded.class);
        return bench.wire.sent(MissionSetCurrent.class).stream()
                .map(MissionSetCurrent::seq)
                .toList();
    }

    /** Also boats and submarines, of either autopilot; {@code mode}: one that waits. */
    @ParameterizedTest
    @CsvSource({"10, 3, 4", "11, 3, 4", "12, 3, 16", "10, 12, 50593792"})
    void goesOnWhereItWasPausedThoughItIsNotInTheAir(int type, int autopilot, long mode) {
        AutopilotTestBench bench = vehicle(type, autopilot, mode);
        bench.status.current(3, 0);

        assertThat(sentTo(bench, START)).isEmpty();
    }

    @Test
    void goesOnOnAHillAsWell() {
        AutopilotTestBench rover = rover();
        rover.status.position(new Position(new Geodetic(46, 7), 540.0, 15.0));
        rover.status.current(3, 0);

        assertThat(sentTo(rover, START)).isEmpty();
    }

    @Test
    void goesOnAfterItsFirstItemWasReached() {
        AutopilotTestBench rover = rover();
        rover.status.current(1, 0);
        rover.status.reached(1);

        assertThat(sentTo(rover, START)).isEmpty();
    }

    @Test
    void beginsWhatWasNeverBegun() {
        AutopilotTestBench rover = rover();
        rover.status.current(1, 0);

        assertThat(sentTo(rover, START)).containsExactly(0);
    }

    @Test
    void beginsAgainWhatIsOver() {
        AutopilotTestBench rover = rover();
        rover.status.current(5, 0);
        rover.status.reached(5);
        assertThat(sentTo(rover, START)).containsExactly(1);

        AutopilotTestBench other = rover();
        other.status.current(4, COMPLETE);
        assertThat(sentTo(other, START)).containsExactly(1);
    }

    @Test
    void beginsWithTheFirstItemOfAnotherMission() {
        AutopilotTestBench rover = rover();
        rover.status.current(3, 0);
        rover.status.missionReplaced();
        assertThat(sentTo(rover, START)).containsExactly(1);

        rover.status.current(3, 0);
        assertThat(sentTo(rover, START))
                .as("the same mission, driven meanwhile")
                .containsExactly(1);
    }

    @Test
    void beginsAnewWhenToldSo() {
        AutopilotTestBench rover = rover();
        rover.status.current(3, 0);

        assertThat(sentTo(rover, ANEW)).containsExactly(1);
    }

    @Test
    void flyersBeginWithTheirTakeOffOnTheGroundAndGoOnInTheAir() {
        AutopilotTestBench landed = vehicle(QUADROTOR, PX4, 50_593_792);
        landed.status.current(3, 0);
        assertThat(sentTo(landed, START)).containsExactly(0);

        AutopilotTestBench flying = vehicle(QUADROTOR, PX4, 50_593_792);
        flying.status.position(new Position(new Geodetic(46, 7), 540.0, 15.0));
        flying.status.current(3, 0);
        assertThat(sentTo(flying, START)).isEmpty();

        AutopilotTestBench copter = vehicle(QUADROTOR, ARDUPILOT, AUTO);
        copter.status.position(new Position(new Geodetic(46, 7), 540.0, 15.0));
        copter.status.current(3, 0);
        copter.status.missionReplaced();
        assertThat(sentTo(copter, START))
                .as("another mission, given to it in the air")
                .containsExactly(1);
    }
}
