package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.SetFence;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionCurrent;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.mavlink.message.MissionRequestList;
import org.dronemap.mavlink.message.MissionSetCurrent;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamValue;
import org.dronemap.proxy.mavlink.procedure.TestWire;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A mission that leaves the vehicle's own fence is warned of when it comes aboard and when it is started. */
class OwnFenceWarningsTest {
    private static final int DISARMED = 81;
    private static final int ARMED = 209;
    private static final int COPTER = 2;
    private static final int PLANE = 1;
    private static final int ROVER = 10;
    private static final int SUB = 12;
    private static final int DO_SET_MODE = 176;
    private static final int REAL32 = 9;
    private static final int FENCE = 1;
    private static final int HEIGHT = 1;
    private static final int CIRCLE = 2;
    private static final int AREAS = 4;
    private static final int FLOOR = 8;
    private static final Geodetic HOME = new Geodetic(46, 7);
    private static final Command START = new Command.StartMission(MissionCloudLossPolicy.CONTINUE);
    private static final MissionItem NEAR = at(46.0005, 7, 20);
    private static final MissionItem FAR = at(46.003, 7, 20);

    private final Map<String, Float> parameters = new TreeMap<>();
    private final List<MissionItemInt> fence = new ArrayList<>();
    private final List<MissionItemInt> taken = new ArrayList<>();
    private int type = COPTER;
    private int expected;

    private static MissionItem at(double latitude, double longitude, double meters) {
        return new MissionItem.Waypoint(new Geodetic(latitude, longitude), Altitude.aboveHome(meters), 0);
    }

    private AutopilotTestBench vehicle(int baseMode, MissionItem... mission) {
        AutopilotTestBench bench = new AutopilotTestBench(new Heartbeat(type, 3, baseMode, 4, 4, 3));
        bench.status.home(460_000_000, 70_000_000, 410);
        bench.status.position(new Position(HOME, 410.0, 0.0));
        bench.status.missionRead(MissionCodec.toWire(
                List.of(mission),
                bench.wire.target(),
                bench.status,
                new MissionCodec.Form(true, 0f, 0, 0, VehicleType.kind(type))));
        bench.wire.peer((wire, message) -> answer(bench, wire, message));
        return bench;
    }

    private void answer(AutopilotTestBench bench, TestWire wire, Message message) {
        if (message instanceof ParamRequestRead asked && parameters.containsKey(asked.paramId())) {
            wire.answer(new ParamValue(asked.paramId(), parameters.get(asked.paramId()), REAL32, 4, 0));
        } else if (message instanceof MissionSetCurrent) {
            wire.answer(new MissionCurrent(1, 2, 0, 0));
        } else if (message instanceof CommandLong asked) {
            wire.answer(new CommandAck(asked.command(), 0, 0, 0, 255, 190));
            if (asked.command() == DO_SET_MODE) {
                Heartbeat now = new Heartbeat(type, 3, ARMED, (long) asked.param2(), 4, 3);
                bench.status.heartbeat(now, AutopilotAdapter.of(now).modeName(now));
                wire.answer(now);
            }
        } else {
            transfer(wire, message);
        }
    }

    private void transfer(TestWire wire, Message message) {
        if (message instanceof MissionRequestList asked) {
            wire.answer(new MissionCount(255, 190, held(asked.missionType()).size(), asked.missionType()));
        } else if (message instanceof MissionRequestInt asked) {
            wire.answer(held(asked.missionType()).get(asked.seq()));
        } else if (message instanceof MissionCount count) {
            taken.clear();
            expected = count.count();
            wire.answer(new MissionRequestInt(255, 190, 0, 0));
        } else if (message instanceof MissionItemInt item) {
            taken.add(item);
            wire.answer(
                    taken.size() < expected
                            ? new MissionRequestInt(255, 190, taken.size(), 0)
                            : new MissionAck(255, 190, 0, 0));
        }
    }

    private List<MissionItemInt> held(int missionType) {
        return missionType == FENCE ? fence : taken;
    }

    private void fence(int kinds) {
        parameters.putAll(Map.of("FENCE_ENABLE", 1f, "FENCE_TYPE", (float) kinds, "FENCE_RADIUS", 90f));
        parameters.putAll(Map.of("FENCE_ALT_MAX", 60f, "FENCE_ALT_MIN", 10f));
        parameters.putAll(Map.of("FENCE_TOTAL", (float) fence.size(), "FENCE_OPTIONS", 0f));
    }

    private void areas(AutopilotTestBench bench, FenceArea... areas) {
        fence.addAll(FenceCodec.fenceToWire(new SetFence(List.of(areas), null), bench.wire.target()));
        fence(AREAS);
    }

    private static List<String> warnings(AutopilotTestBench bench, Command command) {
        assertThat(bench.perform(command)).isInstanceOf(Outcome.Succeeded.class);
        return bench.warnings.stream()
                .filter(warning -> warning.contains("own fence"))
                .toList();
    }

    @ParameterizedTest
    @ValueSource(ints = {COPTER, PLANE, ROVER, SUB})
    void namesTheItemsBeyondTheCircleAtTheStart(int vehicle) {
        type = vehicle;
        fence(CIRCLE);

        assertThat(warnings(vehicle(ARMED, NEAR, FAR, new MissionItem.LookAhead(), FAR), START))
                .containsExactly("The mission leaves the vehicle's own fence, where its FENCE_ACTION says what it"
                        + " does. Item 2 is 334 m from its home, and its own fence ends at FENCE_RADIUS 90 m."
                        + " Outside, too: item 4.");
    }

    @Test
    void namesThemWhenTheMissionComesAboardOnTheGround() {
        fence(CIRCLE);

        assertThat(warnings(vehicle(DISARMED), new Command.UploadMission(new Mission(List.of(NEAR, FAR)))))
                .singleElement()
                .asString()
                .contains("Item 2 is 334 m from its home");
    }

    @Test
    void namesHeightsAlsoOfTheTakeOff() {
        fence(HEIGHT);

        assertThat(warnings(vehicle(ARMED, new MissionItem.TakeOff(70), NEAR), START))
                .singleElement()
                .asString()
                .endsWith("Item 1 is 70 m above its home, and its own fence ends at FENCE_ALT_MAX 60 m.");
    }

    @Test
    void takeOffAndLandingMayBeBelowTheFloor() {
        fence(FLOOR);

        assertThat(warnings(vehicle(ARMED, new MissionItem.TakeOff(5), NEAR, new MissionItem.Land()), START))
                .isEmpty();
        assertThat(warnings(vehicle(ARMED, at(46, 7, 5)), START)).hasSize(1);
    }

    @Test
    void namesWhatLiesOutsideAnAreaAndTheWayThatLeavesOne() {
        AutopilotTestBench outside = vehicle(ARMED, NEAR, FAR);
        areas(outside, new FenceArea.Circle(true, HOME, 100));
        assertThat(warnings(outside, START))
                .singleElement()
                .asString()
                .endsWith("Item 2 lies outside of an area that its own fence keeps it in.");

        fence.clear();
        AutopilotTestBench through = vehicle(ARMED, NEAR, at(46.0005, 7.002, 20));
        areas(
                through,
                new FenceArea.Polygon(
                        false,
                        List.of(
                                new Geodetic(46.0004, 7.001),
                                new Geodetic(46.0006, 7.001),
                                new Geodetic(46.0005, 7.0011))));
        assertThat(warnings(through, START))
                .singleElement()
                .asString()
                .endsWith("Item 2 is reached by a way that enters an area that its own fence keeps it out of.");
    }

    @Test
    void oneOfSeveralAreasIsEnoughWhereTheVehicleSaysSo() {
        FenceArea[] both = {
            new FenceArea.Circle(true, HOME, 100), new FenceArea.Circle(true, new Geodetic(46.003, 7), 300)
        };
        AutopilotTestBench vehicle = vehicle(ARMED, NEAR, FAR);
        areas(vehicle, both);
        parameters.put("FENCE_OPTIONS", 2f);
        assertThat(warnings(vehicle, START)).isEmpty();

        parameters.put("FENCE_OPTIONS", 0f);
        assertThat(warnings(vehicle(ARMED, NEAR, FAR), START)).hasSize(1);
    }

    @Test
    void saysNothingOfAFenceThatIsOffOrOfOneThatIsKept() {
        fence(CIRCLE | HEIGHT | AREAS | FLOOR);
        assertThat(warnings(vehicle(ARMED, NEAR), START)).isEmpty();

        parameters.put("FENCE_ENABLE", 0f);
        assertThat(warnings(vehicle(ARMED, NEAR, FAR), START)).isEmpty();

        parameters.clear();
        assertThat(warnings(vehicle(ARMED, NEAR, FAR), START)).isEmpty();
    }
}
