package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.mavlink.procedure.TestWire;
import org.junit.jupiter.api.Test;

class PlaneReturnExchangesTest {
    private static final int FIXED_WING = 1;
    private static final int QUAD_PLANE = 22;
    private static final int AUTO = 10;
    private static final int GUIDED = 15;
    private static final int DO_SET_MODE = 176;
    private static final int DO_LAND_START = 189;
    private static final int ACCEPTED = 0;
    private static final int FAILED = 4;

    private final List<Integer> told = new ArrayList<>();

    /** {@code landing}: its mission has a landing sequence. */
    private AutopilotTestBench vehicle(int type, boolean landing) {
        AutopilotTestBench bench = new AutopilotTestBench(new Heartbeat(type, 3, 209, GUIDED, 4, 3));
        bench.wire.peer((wire, message) -> answer(bench, wire, message, landing, type));
        return bench;
    }

    private void answer(AutopilotTestBench bench, TestWire wire, Message message, boolean landing, int type) {
        if (!(message instanceof CommandLong command)) {
            return;
        }
        told.add(command.command());
        boolean obeys = command.command() != DO_LAND_START || landing;
        wire.answer(new CommandAck(command.command(), obeys ? ACCEPTED : FAILED, 0, 0, 255, 190));
        if (obeys) {
            int mode = command.command() == DO_LAND_START ? AUTO : (int) command.param2();
            Heartbeat now = new Heartbeat(type, 3, 209, mode, 4, 3);
            bench.status.heartbeat(now, AutopilotAdapter.of(now).modeName(now));
            wire.answer(now);
        }
    }

    @Test
    void landsByTheLandingSequenceOfItsMission() {
        AutopilotTestBench plane = vehicle(FIXED_WING, true);

        assertThat(plane.perform(new Command.ReturnToLaunch())).isInstanceOf(Outcome.Succeeded.class);
        assertThat(told).containsExactly(DO_LAND_START);
        assertThat(plane.status.inMode("AUTO")).isTrue();
        assertThat(plane.warnings).isEmpty();
    }

    @Test
    void fliesHomeWithoutOneAndSaysThatItCircles() {
        AutopilotTestBench plane = vehicle(FIXED_WING, false);

        assertThat(plane.perform(new Command.ReturnToLaunch())).isInstanceOf(Outcome.Succeeded.class);
        assertThat(told).containsExactly(DO_LAND_START, DO_SET_MODE);
        assertThat(plane.status.inMode("RTL")).isTrue();
        assertThat(plane.warnings).hasSize(1).allMatch(text -> text.contains("circles there"));
    }

    @Test
    void comesDownOnItsRotorsWhereItHasThem() {
        AutopilotTestBench plane = vehicle(QUAD_PLANE, false);

        assertThat(plane.perform(new Command.ReturnToLaunch())).isInstanceOf(Outcome.Succeeded.class);
        assertThat(told).containsExactly(DO_SET_MODE);
        assertThat(plane.status.inMode("QRTL")).isTrue();
    }
}
