package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.Attitude;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Gps;
import org.dronemap.core.drone.GpsFix;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.Position;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.HighLatency;
import org.dronemap.mavlink.message.HighLatency2;
import org.dronemap.mavlink.message.HomePosition;
import org.junit.jupiter.api.Test;

/** Vehicles that say everything in one message, as over a satellite. */
class HighLatencyTest {
    private static final int ARDUPILOT = 3;
    private static final int PX4 = 12;

    private static final HighLatency OLD = new HighLatency(
            0xD1,
            5,
            2,
            -150,
            250,
            27_000,
            40,
            0,
            471_234_567,
            -81_234_567,
            612,
            620,
            11,
            11,
            9,
            -2,
            14,
            3,
            77,
            20,
            20,
            0,
            2,
            100);

    private final List<DroneEvent> events = new ArrayList<>();

    private TelemetryTranslator vehicle(Heartbeat first, Message... before) {
        TelemetryTranslator translator =
                new TelemetryTranslator(AutopilotAdapter.of(first), new VehicleStatus(2, 0), events::add);
        hear(translator, first);
        for (Message message : before) {
            hear(translator, message);
        }
        events.clear();
        return translator;
    }

    private static void hear(TelemetryTranslator translator, Message message) {
        translator.received(VehicleFrames.of(1, message), 5_000_000_000L);
    }

    private static HighLatency2 summary(int autopilot, int customMode, int custom0) {
        return new HighLatency2(
                1,
                2,
                autopilot,
                customMode,
                471_234_567,
                -81_234_567,
                612,
                620,
                135,
                90,
                10,
                30,
                60,
                60,
                45,
                20,
                30,
                5,
                5,
                20,
                7,
                41,
                4,
                0,
                custom0,
                0,
                0);
    }

    @Test
    void ofPx4MovesEverything() {
        TelemetryTranslator px4 = vehicle(
                new Heartbeat(2, PX4, 209, 4L << 16 | 4L << 24, 4, 3),
                new HomePosition(471_000_000, -81_000_000, 600_000, 0, 0, 0, new float[4], 0, 0, 0, 0),
                new GlobalPositionInt(0, 471_000_001, -81_000_001, 630_000, 30_000, 0, 0, 0, 0));
        hear(px4, summary(PX4, 5 << 8 | 4, -128));
        assertThat(events)
                .contains(
                        new DroneEvent.ModeReported("RTL", null),
                        new DroneEvent.PositionReported(
                                new Position(new Geodetic(47.1234567, -8.1234567), 612.0, 12.0)),
                        new DroneEvent.MotionReported(new Motion(9.0, 12.0, null, 270.0)),
                        new DroneEvent.BatteryReported(new Battery(41, null, null)),
                        new DroneEvent.MissionCurrentReported(4, null));
    }

    @Test
    void ofArduPilotTellsAsWellWhetherItIsArmed() {
        TelemetryTranslator copter = vehicle(new Heartbeat(2, ARDUPILOT, 81, 4, 3, 3));
        hear(copter, summary(ARDUPILOT, 6, (byte) 0xD1));
        assertThat(events)
                .contains(
                        new DroneEvent.ModeReported("RTL", true),
                        new DroneEvent.PhaseReported(null),
                        new DroneEvent.MissionCurrentReported(3, null));
        events.clear();
        hear(copter, summary(ARDUPILOT, 6, 0x51));
        assertThat(events)
                .contains(
                        new DroneEvent.ModeReported("RTL", false), new DroneEvent.PhaseReported(FlightPhase.ON_GROUND));
    }

    @Test
    void theOldOneTellsTheSame() {
        TelemetryTranslator copter = vehicle(new Heartbeat(2, ARDUPILOT, 81, 4, 3, 3));
        hear(copter, OLD);
        assertThat(events)
                .contains(
                        new DroneEvent.ModeReported("LOITER", true),
                        new DroneEvent.PhaseReported(FlightPhase.IN_AIR),
                        new DroneEvent.PositionReported(
                                new Position(new Geodetic(47.1234567, -8.1234567), 612.0, null)),
                        new DroneEvent.MotionReported(new Motion(9.0, 11.0, null, 270.0)),
                        new DroneEvent.AttitudeReported(new Attitude(-1.5, 2.5, 270)),
                        new DroneEvent.GpsReported(new Gps(GpsFix.THREE_D, 14, null)),
                        new DroneEvent.BatteryReported(new Battery(77, null, null)),
                        new DroneEvent.MissionCurrentReported(1, null));
    }

    @Test
    void whatTheOldOneLeavesOpenIsUnknown() {
        TelemetryTranslator copter = vehicle(new Heartbeat(2, ARDUPILOT, 81, 4, 3, 3));
        int none = Short.MAX_VALUE;
        hear(
                copter,
                new HighLatency(
                        0x51,
                        4,
                        0,
                        none,
                        none,
                        36_000,
                        0,
                        0,
                        471_234_567,
                        -81_234_567,
                        none,
                        0,
                        255,
                        255,
                        255,
                        0,
                        255,
                        255,
                        255,
                        0,
                        0,
                        0,
                        0,
                        255));
        assertThat(events)
                .contains(
                        new DroneEvent.PhaseReported(FlightPhase.ON_GROUND),
                        new DroneEvent.PositionReported(new Position(new Geodetic(47.1234567, -8.1234567), null, null)),
                        new DroneEvent.MotionReported(new Motion(null, null, null, null)),
                        new DroneEvent.AttitudeReported(null),
                        new DroneEvent.MissionCurrentReported(null, null))
                .doesNotHaveAnyElementsOfTypes(DroneEvent.BatteryReported.class);
    }

    @Test
    void aHomeThatWasTakenBackIsUnknown() {
        TelemetryTranslator copter = vehicle(new Heartbeat(2, ARDUPILOT, 81, 4, 3, 3));
        hear(copter, new HomePosition(471_000_000, 81_000_000, 600_000, 0, 0, 0, new float[4], 0, 0, 0, 0));
        hear(copter, new HomePosition(0, 0, 0, 0, 0, 0, new float[4], 0, 0, 0, 0));
        assertThat(events)
                .containsExactly(
                        new DroneEvent.HomeReported(new Home(new Geodetic(47.1, 8.1), 600)),
                        new DroneEvent.HomeReported(null));
    }
}
