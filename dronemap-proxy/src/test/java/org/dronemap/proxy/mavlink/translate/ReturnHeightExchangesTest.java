package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.SetReturnHeight;
import org.dronemap.core.drone.ReturnHeight;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.ParamValue;
import org.dronemap.proxy.mavlink.procedure.TestWire;
import org.junit.jupiter.api.Test;

class ReturnHeightExchangesTest {
    private static final Outcome DONE = new Outcome.Succeeded();
    private static final int INT32 = 6;
    private static final int REAL32 = 9;

    private float held;
    private int type = INT32;
    private boolean obeys = true;
    private String name = "RTL_ALT";

    private AutopilotTestBench bench(Heartbeat heartbeat) {
        AutopilotTestBench bench = new AutopilotTestBench(heartbeat);
        bench.wire.peer(this::vehicle);
        return bench;
    }

    private void vehicle(TestWire wire, Message message) {
        if (message instanceof ParamSet set && set.paramId().equals(name)) {
            held = obeys ? set.paramValue() : held;
            wire.answer(new ParamValue(set.paramId(), held, type, 900, 1));
        } else if (message instanceof ParamRequestRead question
                && question.paramId().equals(name)) {
            wire.answer(new ParamValue(question.paramId(), held, type, 900, 1));
        }
    }

    @Test
    void tellsWhatWasSetBeforeAndPutsItBack() {
        held = 1_500;
        AutopilotTestBench copter = bench(AutopilotTestBench.ARDUCOPTER);

        assertThat(copter.perform(new SetReturnHeight(51, true))).isEqualTo(DONE);
        assertThat(held).isEqualTo(5_100);
        assertThat(copter.news).containsExactly(new DroneEvent.ReturnHeightSet(new ReturnHeight(51, 15)));

        assertThat(copter.perform(new SetReturnHeight(15, false))).isEqualTo(DONE);
        assertThat(held).isEqualTo(1_500);
    }

    @Test
    void knowsThatNewerCoptersCountItInMetres() {
        held = 15.5f;
        type = REAL32;
        name = "RTL_ALT_M";
        AutopilotTestBench copter = bench(AutopilotTestBench.ARDUCOPTER);

        assertThat(copter.perform(new SetReturnHeight(51, true))).isEqualTo(DONE);
        assertThat(held).isEqualTo(51);
        assertThat(copter.news).containsExactly(new DroneEvent.ReturnHeightSet(new ReturnHeight(51, 15.5)));

        assertThat(copter.perform(new SetReturnHeight(15.5, false))).isEqualTo(DONE);
        assertThat(held).isEqualTo(15.5f);
        assertThat(copter.wire.sent(ParamSet.class))
                .allMatch(set -> set.paramId().equals("RTL_ALT_M"));
    }

    @Test
    void leavesWhatIsSetHigherInMetres() {
        held = 90;
        type = REAL32;
        name = "RTL_ALT_M";
        AutopilotTestBench copter = bench(AutopilotTestBench.ARDUCOPTER);

        assertThat(copter.perform(new SetReturnHeight(51, true))).isEqualTo(DONE);

        assertThat(held).isEqualTo(90);
        assertThat(copter.news).containsExactly(new DroneEvent.ReturnHeightSet(new ReturnHeight(90, 90)));
    }

    @Test
    void saysSoWhereTheVehicleTellsNoHeight() {
        name = "NONE";
        AutopilotTestBench copter = bench(AutopilotTestBench.ARDUCOPTER);

        assertThat(copter.perform(new SetReturnHeight(51, true))).isInstanceOf(Outcome.TimedOut.class);
        assertThat(copter.news).isEmpty();
    }

    @Test
    void leavesWhatIsSetHigher() {
        held = 9_000;
        AutopilotTestBench copter = bench(AutopilotTestBench.ARDUCOPTER);

        assertThat(copter.perform(new SetReturnHeight(51, true))).isEqualTo(DONE);

        assertThat(held).isEqualTo(9_000);
        assertThat(copter.news).containsExactly(new DroneEvent.ReturnHeightSet(new ReturnHeight(90, 90)));
    }

    @Test
    void knowsHowPx4CallsIt() {
        held = 60;
        type = REAL32;
        name = "RTL_RETURN_ALT";
        AutopilotTestBench copter = bench(AutopilotTestBench.PX4);

        assertThat(copter.perform(new SetReturnHeight(72, true))).isEqualTo(DONE);

        assertThat(held).isEqualTo(72);
        assertThat(copter.wire.sent(ParamSet.class))
                .allMatch(set -> set.paramId().equals("RTL_RETURN_ALT"));
    }

    @Test
    void failsWhereTheVehicleKeepsWhatItHad() {
        held = 1_500;
        obeys = false;
        AutopilotTestBench copter = bench(AutopilotTestBench.ARDUCOPTER);

        assertThat(copter.perform(new SetReturnHeight(51, true))).isInstanceOf(Outcome.Failed.class);
        assertThat(copter.news).isEmpty();
    }

    @Test
    void refusesForVehiclesThatComeHomeAnotherWay() {
        AutopilotTestBench rover = bench(new Heartbeat(10, 3, 81, 0, 3, 3));

        assertThat(rover.perform(new SetReturnHeight(51, true))).isInstanceOf(Outcome.Refused.class);
        assertThat(rover.wire.sent()).isEmpty();
    }
}
