package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.TreeMap;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamValue;
import org.dronemap.mavlink.message.Statustext;
import org.dronemap.proxy.mavlink.procedure.TestWire;
import org.junit.jupiter.api.Test;

/** What a vehicle refuses is told with what is known of why, and with what can be done instead. */
class RefusalsWithAWayOutTest {
    private static final int DISARMED = 81;
    private static final int ARMED = 209;
    private static final int RTL = 6;
    private static final int PLANE_AUTO = 10;
    private static final int CRITICAL = 2;
    private static final int GUIDED = 4;
    private static final int FAILED = 4;
    private static final int REAL32 = 9;
    private static final int HOME_E7 = 460_000_000;
    private static final Command FAR = goTo(46.003, 20);

    private final Map<String, Float> parameters = new TreeMap<>();

    private static Command goTo(double latitude, double meters) {
        return new Command.GoTo(new Geodetic(latitude, 7), Altitude.aboveHome(meters));
    }

    /** An ArduCopter in that mode that refuses everything. */
    private AutopilotTestBench copter(int baseMode, int mode) {
        AutopilotTestBench bench = new AutopilotTestBench(new Heartbeat(2, 3, baseMode, mode, 4, 3));
        bench.wire.peer(this::refuse);
        bench.status.home(HOME_E7, 70_000_000, 410);
        return bench;
    }

    private void refuse(TestWire wire, Message message) {
        if (message instanceof CommandLong asked) {
            wire.answer(new CommandAck(asked.command(), FAILED, 0, 0, 255, 190));
        } else if (message instanceof CommandInt asked) {
            wire.answer(new CommandAck(asked.command(), FAILED, 0, 0, 255, 190));
        } else if (message instanceof ParamRequestRead asked && parameters.containsKey(asked.paramId())) {
            wire.answer(new ParamValue(asked.paramId(), parameters.get(asked.paramId()), REAL32, 4, 0));
        }
    }

    private void fence(float enabled, float type) {
        parameters.putAll(Map.of("FENCE_ENABLE", enabled, "FENCE_TYPE", type, "FENCE_RADIUS", 90f));
        parameters.put("FENCE_ALT_MAX", 60f);
    }

    @Test
    void namesTheModeInWhichItIsArmed() {
        Outcome outcome = copter(DISARMED, RTL).perform(new Command.Arm());

        assertThat(outcome.code()).isEqualTo(OutcomeCode.MODE_DOES_NOT_ARM);
        assertThat(outcome.reason()).endsWith(" It is not armed in RTL; change its mode to GUIDED first.");
    }

    @Test
    void doesNotBlameTheModeWhereItMayBeArmed() {
        Outcome outcome = copter(DISARMED, GUIDED).perform(new Command.Arm());

        assertThat(outcome.code()).isEqualTo(OutcomeCode.VEHICLE_FAILED);
        assertThat(outcome.reason()).doesNotContain("mode");
    }

    @Test
    void saysHowAPlaneFliesAgainThatItsMissionHasLanded() {
        AutopilotTestBench bench = new AutopilotTestBench(new Heartbeat(1, 3, 89, PLANE_AUTO, 4, 3));
        bench.wire.peer((wire, message) -> {
            if (message instanceof CommandLong) {
                wire.answer(new Statustext(CRITICAL, "Arm: In landing sequence", 0, 0));
            }
            refuse(wire, message);
        });

        Outcome outcome = bench.perform(new Command.Arm());

        assertThat(outcome.code()).isEqualTo(OutcomeCode.MODE_DOES_NOT_ARM);
        assertThat(outcome.reason()).contains("In landing sequence", "change its mode to MANUAL first");
    }

    @Test
    void namesTheCircleOfItsOwnFence() {
        fence(1, 7);

        assertThat(copter(ARMED, GUIDED).perform(FAR)).satisfies(outcome -> {
            assertThat(outcome.code()).isEqualTo(OutcomeCode.FENCE_FORBIDS);
            assertThat(outcome.reason())
                    .endsWith("The place is 334 m from its home, and its own fence ends at FENCE_RADIUS 90 m.");
        });
    }

    @Test
    void namesTheHeightOfItsOwnFence() {
        fence(1, 1);

        assertThat(copter(ARMED, GUIDED).perform(goTo(46, 75)).reason())
                .endsWith("The place is 75 m above its home, and its own fence ends at FENCE_ALT_MAX 60 m.");
    }

    @Test
    void comparesAHeightAboveTheSeaWithItsHome() {
        fence(1, 1);
        Command high = new Command.GoTo(new Geodetic(46, 7), new Altitude(480, Altitude.Reference.AMSL));
        Command low = new Command.GoTo(new Geodetic(46, 7), new Altitude(465, Altitude.Reference.AMSL));

        assertThat(copter(ARMED, GUIDED).perform(high).reason()).contains("The place is 70 m above its home");
        assertThat(copter(ARMED, GUIDED).perform(low).code()).isEqualTo(OutcomeCode.VEHICLE_FAILED);
    }

    @Test
    void blamesNoPartOfTheFenceThatItsTypeLeavesOut() {
        fence(1, 2);
        assertThat(copter(ARMED, GUIDED).perform(goTo(46, 75)).code()).isEqualTo(OutcomeCode.VEHICLE_FAILED);

        fence(1, 1);
        assertThat(copter(ARMED, GUIDED).perform(FAR).code()).isEqualTo(OutcomeCode.VEHICLE_FAILED);
    }

    @Test
    void saysThatItHasAreasWhereNothingElseIsInTheWay() {
        fence(1, 7);

        assertThat(copter(ARMED, GUIDED).perform(goTo(46, 20)).reason()).contains("read its fence");
    }

    /** Areas are on by default (FENCE_TYPE 7), also on a vehicle that has none. */
    @Test
    void blamesNoAreasWhereThereAreNone() {
        fence(1, 7);
        parameters.put("FENCE_TOTAL", 0f);

        assertThat(copter(ARMED, GUIDED).perform(goTo(46, 20)).code()).isEqualTo(OutcomeCode.VEHICLE_FAILED);
    }

    @Test
    void namesTheFloorOfItsOwnFence() {
        fence(1, 8);
        parameters.put("FENCE_ALT_MIN", 10f);

        assertThat(copter(ARMED, GUIDED).perform(goTo(46, 5)).reason())
                .endsWith("The place is 5 m above its home, and its own fence begins at FENCE_ALT_MIN 10 m.");
    }

    @Test
    void blamesNoFenceThatIsOffOrNotThere() {
        fence(0, 7);
        assertThat(copter(ARMED, GUIDED).perform(FAR).code()).isEqualTo(OutcomeCode.VEHICLE_FAILED);

        parameters.clear();
        assertThat(copter(ARMED, GUIDED).perform(FAR).code()).isEqualTo(OutcomeCode.VEHICLE_FAILED);
    }
}
