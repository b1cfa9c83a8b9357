package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.mavlink.message.ExtendedSysState;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.mavlink.procedure.TestWire;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A rover on a hill, and one that says by itself that it flies, is not in the air. */
class GroundVehicleTelemetryTest {
    private static final int ARMED = 209;
    private static final int ACTIVE = 4;
    private static final int LANDED_STATE_IN_AIR = 2;

    private final TestWire wire = new TestWire();
    private final List<DroneEvent> events = new ArrayList<>();

    /** {@code autopilot}: 3 ArduPilot, 12 PX4; {@code type}: 2 quadrotor, 10 rover, 11 boat, 12 submarine. */
    @ParameterizedTest
    @CsvSource({"3, 10, false", "12, 10, false", "3, 11, false", "12, 12, false", "12, 2, true"})
    void fliesOnlyWithWingsOrRotors(int autopilot, int type, boolean flies) {
        Heartbeat heartbeat = new Heartbeat(type, autopilot, ARMED, 0, ACTIVE, 3);
        VehicleStatus status = new VehicleStatus(type, 0);
        TelemetryTranslator translator = new TelemetryTranslator(AutopilotAdapter.of(heartbeat), status, events::add);

        translator.received(wire.frame(heartbeat), wire.now());
        translator.received(
                wire.frame(new GlobalPositionInt(0, 460_000_000, 70_000_000, 530_000, 14_000, 0, 0, 0, 0)), wire.now());
        translator.received(wire.frame(new ExtendedSysState(0, LANDED_STATE_IN_AIR)), wire.now());

        assertThat(status.airborne()).isEqualTo(flies);
        assertThat(events.contains(new DroneEvent.PhaseReported(FlightPhase.IN_AIR)))
                .isEqualTo(flies);
    }
}
