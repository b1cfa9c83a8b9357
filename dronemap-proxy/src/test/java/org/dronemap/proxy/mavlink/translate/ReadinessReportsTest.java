package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.EkfStatusReport;
import org.dronemap.mavlink.message.SysStatus;
import org.dronemap.proxy.mavlink.procedure.TestWire;
import org.junit.jupiter.api.Test;

/** A copter from power-up, as ArduCopter tells it: its checks pass in a pilot's mode before it knows where it is. */
class ReadinessReportsTest {
    private static final long PREARM = 0x1000_0000L;
    /** Attitude, velocities and height; the position is held constant as none is known. */
    private static final int WITHOUT_POSITION = 167;

    private static final int WITH_POSITION = 831;

    private final TestWire wire = new TestWire();
    private final List<DroneEvent> news = new ArrayList<>();
    private final TelemetryTranslator translator = new TelemetryTranslator(
            AutopilotAdapter.of(AutopilotTestBench.ARDUCOPTER), new VehicleStatus(2, 0), news::add);

    private void says(Message message) {
        translator.received(wire.frame(message), 0);
    }

    private void checks(boolean known, boolean pass) {
        says(new SysStatus(known ? PREARM : 0, 0, pass ? PREARM : 0, 0, 12_600, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0));
    }

    private void estimator(int flags) {
        says(new EkfStatusReport(flags, 0.1f, 0.1f, 0.1f, 0.1f, 0f, 0f));
    }

    /** As told last; empty: as not known. */
    private Optional<Boolean> ready() {
        return news.stream()
                .filter(DroneEvent.ReadinessReported.class::isInstance)
                .map(DroneEvent.ReadinessReported.class::cast)
                .reduce((first, later) -> later)
                .map(DroneEvent.ReadinessReported::readyToArm);
    }

    @Test
    void isNotReadyBeforeItKnowsWhereItIsThoughItsChecksPass() {
        estimator(WITHOUT_POSITION);
        checks(true, true);
        assertThat(ready()).contains(false);

        estimator(WITH_POSITION);
        assertThat(ready()).contains(true);

        estimator(WITHOUT_POSITION);
        assertThat(ready()).contains(false);
    }

    @Test
    void isNotReadyWhileItsChecksFailThoughItKnowsWhereItIs() {
        estimator(WITH_POSITION);
        checks(true, false);

        assertThat(ready()).contains(false);
    }

    @Test
    void goesByTheChecksOfAVehicleThatTellsNothingOfItsEstimator() {
        checks(true, true);

        assertThat(ready()).contains(true);
    }

    @Test
    void saysNothingOfAVehicleWithoutChecks() {
        estimator(WITHOUT_POSITION);
        checks(false, false);

        assertThat(ready()).isEmpty();
    }
}
