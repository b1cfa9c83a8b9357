package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.SetReturnOnCloudLoss;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.ParamValue;
import org.dronemap.proxy.mavlink.procedure.TestWire;
import org.junit.jupiter.api.Test;

class CloudLossExchangesTest {
    private static final Outcome DONE = new Outcome.Succeeded();
    private static final int INT8 = 2;
    private static final int INT32 = 6;

    private float held;
    private int type = INT8;

    private AutopilotTestBench bench(Heartbeat heartbeat) {
        AutopilotTestBench bench = new AutopilotTestBench(heartbeat);
        bench.wire.peer(this::vehicle);
        return bench;
    }

    private void vehicle(TestWire wire, Message message) {
        if (message instanceof ParamSet set) {
            held = set.paramValue();
            wire.answer(new ParamValue(set.paramId(), held, type, 900, 1));
        } else if (message instanceof ParamRequestRead question) {
            wire.answer(new ParamValue(question.paramId(), held, type, 900, 1));
        }
    }

    @Test
    void hasACopterComeHomeThatWouldStay() {
        AutopilotTestBench copter = bench(AutopilotTestBench.ARDUCOPTER);

        assertThat(copter.perform(new SetReturnOnCloudLoss())).isEqualTo(DONE);

        assertThat(held).isEqualTo(1);
        assertThat(copter.wire.sent(ParamSet.class))
                .allMatch(set -> set.paramId().equals("FS_GCS_ENABLE"));
    }

    @Test
    void leavesWhatItsOwnerChose() {
        held = 5;
        AutopilotTestBench copter = bench(AutopilotTestBench.ARDUCOPTER);

        assertThat(copter.perform(new SetReturnOnCloudLoss())).isEqualTo(DONE);

        assertThat(held).isEqualTo(5);
        assertThat(copter.wire.sent(ParamSet.class)).isEmpty();
    }

    @Test
    void knowsHowPx4CallsIt() {
        held = Float.intBitsToFloat(1);
        type = INT32;
        AutopilotTestBench copter = bench(AutopilotTestBench.PX4);

        assertThat(copter.perform(new SetReturnOnCloudLoss())).isEqualTo(DONE);

        assertThat(Float.floatToRawIntBits(held)).isEqualTo(2);
        assertThat(copter.wire.sent(ParamSet.class))
                .allMatch(set -> set.paramId().equals("NAV_DLL_ACT"));
    }

    @Test
    void saysSoWhereTheVehicleTellsNothing() {
        AutopilotTestBench copter = new AutopilotTestBench(AutopilotTestBench.ARDUCOPTER);

        assertThat(copter.perform(new SetReturnOnCloudLoss())).isInstanceOf(Outcome.TimedOut.class);
    }

    @Test
    void refusesForVehiclesThatComeHomeAnotherWay() {
        AutopilotTestBench rover = bench(new Heartbeat(10, 3, 81, 0, 3, 3));

        assertThat(rover.perform(new SetReturnOnCloudLoss())).isInstanceOf(Outcome.Refused.class);
        assertThat(rover.wire.sent()).isEmpty();
    }
}
