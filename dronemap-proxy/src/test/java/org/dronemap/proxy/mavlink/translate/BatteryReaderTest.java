package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import org.dronemap.core.drone.Battery;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;
import org.dronemap.mavlink.message.BatteryStatus;
import org.dronemap.mavlink.message.SysStatus;
import org.dronemap.proxy.mavlink.procedure.TestWire;
import org.junit.jupiter.api.Test;

class BatteryReaderTest {
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

        assertThat(new BatteryReader().received(system, 0).map(Battery::percent))
                .isEmpty();
        assertThat(new BatteryReader().received(battery, 0).map(Battery::percent))
                .isEmpty();
    }

    private static BatteryStatus status(int id, int function, int percent, int centiamps, int[] cells, int... more) {
        int[] ten = new int[10];
        Arrays.fill(ten, 65_535);
        System.arraycopy(cells, 0, ten, 0, cells.length);
        return new BatteryStatus(
                id, function, 1, 0, ten, centiamps, -1, -1, percent, 0, 0, Arrays.copyOf(more, 4), 0, 0);
    }

    private static SysStatus system(int percent, int millivolts, int centiamps) {
        return new SysStatus(0, 0, 0, 0, millivolts, centiamps, percent, 0, 0, 0, 0, 0, 0, 0, 0, 0);
    }

    private static int[] cells(int count, int millivolts) {
        int[] all = new int[count];
        Arrays.fill(all, millivolts);
        return all;
    }

    @Test
    void cellsBeyondTheTenthCountToo() {
        BatteryReader reader = new BatteryReader();
        assertThat(reader.received(status(0, 0, 80, 500, cells(10, 4_000), 4_000, 4_000, 65_535, 0), 0))
                .contains(new Battery(80, 48.0, 5.0));
    }

    @Test
    void whatSysStatusCannotCarryIsTakenFromTheOther() {
        BatteryReader reader = new BatteryReader();
        reader.received(status(0, 0, 80, 500, new int[] {65_534, 10_466}), 0);
        assertThat(reader.received(system(80, 76_000 - 65_536, 500), 0)).contains(new Battery(80, 76.0, 5.0));
        assertThat(reader.received(system(80, 65_535, 500), 0)).contains(new Battery(80, 76.0, 5.0));
    }

    @Test
    void unknownAfterKnownIsUnknown() {
        BatteryReader reader = new BatteryReader();
        reader.received(system(70, 15_000, 1_200), 0);
        assertThat(reader.received(system(-1, 65_535, -1), 1_000)).contains(new Battery(null, null, null));
        reader.received(status(0, 0, 64, 300, cells(4, 3_900)), 2_000);
        assertThat(reader.received(system(-1, 0, -1), 3_000)).contains(new Battery(64, 15.6, 3.0));
        assertThat(reader.received(status(0, 0, -1, -1, cells(0, 0)), 4_000)).contains(new Battery(null, null, null));
    }

    @Test
    void whatStoppedComingFillsNothingIn() {
        BatteryReader reader = new BatteryReader();
        reader.received(status(0, 0, 64, 300, cells(4, 3_900)), 0);
        assertThat(reader.received(system(-1, 65_535, -1), 9_000_000_000L)).contains(new Battery(64, 15.6, 3.0));
        assertThat(reader.received(system(-1, 65_535, -1), 11_000_000_000L)).contains(new Battery(null, null, null));
    }

    @Test
    void whatComesSeldomCountsAsLongAsItsWayOfComing() {
        BatteryReader reader = new BatteryReader();
        reader.received(status(0, 0, 64, 300, cells(4, 3_900)), 0);
        reader.received(status(0, 0, 63, 300, cells(4, 3_900)), 60_000_000_000L);
        assertThat(reader.received(system(-1, 65_535, -1), 230_000_000_000L)).contains(new Battery(63, 15.6, 3.0));
        assertThat(reader.received(system(-1, 65_535, -1), 250_000_000_000L)).contains(new Battery(null, null, null));
    }

    @Test
    void noMoreBatteriesAreKeptThanAVehicleHas() {
        BatteryReader reader = new BatteryReader();
        for (int id = 0; id < 16; id++) {
            assertThat(reader.received(status(id, 0, 80, 500, cells(4, 4_000)), 0))
                    .isPresent();
        }
        assertThat(reader.received(status(16, 0, 80, 500, cells(4, 4_000)), 0)).isEmpty();
        assertThat(reader.received(status(15, 0, 70, 500, cells(4, 4_000)), 0))
                .get()
                .satisfies(battery -> assertThat(battery.further())
                        .hasSize(15)
                        .last()
                        .isEqualTo(new Battery.Further(15, 70, 16.0, 5.0)));
    }

    @Test
    void furtherBatteriesAreToldBesideTheMainOne() {
        BatteryReader reader = new BatteryReader();
        reader.received(status(0, 0, 80, 500, cells(4, 4_000)), 0);
        Battery.Further second = new Battery.Further(1, 20, 14.0, null);
        assertThat(reader.received(status(1, 0, 20, -1, cells(4, 3_500)), 0))
                .contains(new Battery(80, 16.0, 5.0, List.of(second)));
        assertThat(reader.received(system(79, 15_900, 490), 0)).contains(new Battery(79, 15.9, 4.9, List.of(second)));
    }

    @Test
    void oneBeyondTheFirstThatTellsOtherValuesThanSysStatusIsAnotherOne() {
        BatteryReader reader = new BatteryReader();
        reader.received(system(80, 16_000, 500), 0);
        assertThat(reader.received(status(1, 0, 20, 100, cells(4, 3_500)), 0))
                .contains(new Battery(80, 16.0, 5.0, List.of(new Battery.Further(1, 20, 14.0, 1.0))));
        assertThat(reader.received(status(1, 0, 78, 100, cells(4, 3_900)), 0)).contains(new Battery(80, 16.0, 5.0));
        assertThat(reader.received(status(2, 0, -1, -1, cells(2, 4_000)), 0))
                .contains(new Battery(80, 16.0, 5.0, List.of(new Battery.Further(2, null, 8.0, null))));
    }

    @Test
    void theMainOneKeepsItInTheAir() {
        BatteryReader reader = new BatteryReader();
        reader.received(status(0, 4, 99, -1, cells(3, 4_000)), 0);
        assertThat(reader.received(status(3, 2, 50, -1, cells(6, 3_700)), 0))
                .contains(new Battery(50, 22.2, null, List.of(new Battery.Further(0, 99, 12.0, null))));
    }
}
