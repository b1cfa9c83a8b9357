package org.dronemap.proxy.mavlink.procedure;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.command.Outcome;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.ParamValue;
import org.junit.jupiter.api.Test;

class ParameterChangeTest {
    private final TestWire wire = new TestWire();
    private float value = 0;

    /** Answers reads and writes of one parameter of the given type. */
    private void vehicle(TestWire w, Message message, int type) {
        if (message instanceof ParamSet set) {
            value = set.paramValue();
        }
        w.answer(new ParamValue("FS_OPTIONS", value, type, 1, 0));
    }

    private ParameterUpdateExchange change(boolean bytewise) {
        return new ParameterUpdateExchange(
                wire.target(), new ParameterUpdateExchange.Wanted("FS_OPTIONS", old -> old | 2, bytewise));
    }

    @Test
    void addsABitToAnArduPilotParameter() {
        value = 17;
        wire.peer((w, message) -> vehicle(w, message, 4));

        assertThat(wire.runWhole(change(false))).isEqualTo(new Outcome.Succeeded());
        assertThat(value).isEqualTo(19f);
    }

    @Test
    void leavesAParameterAloneThatIsRight() {
        value = 19;
        wire.peer((w, message) -> vehicle(w, message, 4));

        assertThat(wire.runWhole(change(false))).isEqualTo(new Outcome.Succeeded());
        assertThat(wire.sent(ParamSet.class)).isEmpty();
    }

    @Test
    void writesPx4IntegersAsTheirBits() {
        value = Float.intBitsToFloat(1);
        wire.peer((w, message) -> vehicle(w, message, 6));

        assertThat(wire.runWhole(change(true))).isEqualTo(new Outcome.Succeeded());
        assertThat(Float.floatToRawIntBits(value)).isEqualTo(3);
    }

    @Test
    void givesUpSoonOnAVehicleThatDoesNotKnowIt() {
        long before = wire.now();

        assertThat(wire.runWhole(change(false))).isInstanceOf(Outcome.TimedOut.class);
        assertThat(wire.now() - before).isLessThan(2_000_000_000L);
    }

    @Test
    void saysWhenTheVehicleDoesNotTakeTheValue() {
        wire.peer((w, message) -> w.answer(new ParamValue("FS_OPTIONS", 0, 4, 1, 0)));

        assertThat(wire.runWhole(change(false)))
                .isEqualTo(new Outcome.Failed("The vehicle did not take FS_OPTIONS = 2."));
    }
}
