package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.drone.Battery;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;
import org.dronemap.mavlink.message.BatteryStatus;
import org.dronemap.mavlink.message.SysStatus;
import org.dronemap.proxy.mavlink.procedure.TestWire;
import org.junit.jupiter.api.Test;

class TelemetryDecoderTest {
    private static final int REMAINING_IN_SYS_STATUS = 30;
    private static final int REMAINING_IN_BATTERY_STATUS = 35;

    private final TestWire wire = new TestWire();
    /** All zeros but one byte, which is 110. */
    private Frame withCharge(int messageId, int length, int at) {
        return wire.frame(new Message() {
            @Override
            public int messageId() {
                return messageId;
            }

            @Override
            public void write(PayloadWriter out) {
                for (int i = 0; i < length; i++) {
                    out.u8(i == at ? 110 : 0);
                }
            }
        });
    }

    @Test
    void takesAChargeOfMoreThanEverythingForUnknown() {
        SysStatus system = SysStatus.decode(withCharge(SysStatus.ID, 31, REMAINING_IN_SYS_STATUS));
        BatteryStatus battery = BatteryStatus.decode(withCharge(BatteryStatus.ID, 36, REMAINING_IN_BATTERY_STATUS));
        assertThat(system.batteryRemaining()).isEqualTo(110);
        assertThat(battery.batteryRemaining()).isEqualTo(110);

        assertThat(new TelemetryDecoder().battery(system).map(Battery::percent)).isEmpty();
        assertThat(new TelemetryDecoder().battery(battery).map(Battery::percent))
                .isEmpty();
    }
}
