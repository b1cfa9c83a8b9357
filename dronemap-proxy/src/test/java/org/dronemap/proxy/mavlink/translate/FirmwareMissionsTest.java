package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.LandingPlace;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionAbilities;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.FirmwareMissionVehicle;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Each kind of item on each kind of vehicle of ArduPilot: known to the firmware and held as sent, or refused before. */
class FirmwareMissionsTest {
    private static final int COPTER = 2;
    private static final int PLANE = 1;
    private static final int ROVER = 10;
    private static final int VTOL = 20;
    private static final Geodetic FIELD = new Geodetic(47.4, 8.5);
    /** 445 m north of it. */
    private static final MissionItem BEFORE =
            new MissionItem.Waypoint(new Geodetic(47.404, 8.5), Altitude.aboveHome(40), 0);

    private static final MissionItem LAND_AT = new MissionItem.Land(LandingPlace.levelWithHome(FIELD));

    static Stream<Arguments> vehiclesAndItems() {
        List<MissionItem> items = List.of(
                new MissionItem.TakeOff(20),
                BEFORE,
                new MissionItem.Waypoint(FIELD, new Altitude(512.25, Altitude.Reference.AMSL), 0),
                new MissionItem.Waypoint(FIELD, Altitude.aboveHome(30), 7),
                new MissionItem.Waypoint(FIELD, Altitude.aboveHome(30), 7.4),
                new MissionItem.ReturnToLaunch(),
                new MissionItem.Land(),
                LAND_AT,
                new MissionItem.Land(new LandingPlace(FIELD, Altitude.aboveHome(-12))),
                new MissionItem.Wait(2.5),
                new MissionItem.TakePhoto(),
                new MissionItem.SetServo(9, 1_900),
                new MissionItem.LookAt(FIELD, Altitude.aboveHome(3)),
                new MissionItem.LookAt(FIELD, new Altitude(480, Altitude.Reference.AMSL)),
                new MissionItem.LookAhead());
        return Stream.of(COPTER, PLANE, ROVER, VTOL)
                .flatMap(type -> items.stream().map(item -> Arguments.of(type, item)));
    }

    @ParameterizedTest
    @MethodSource("vehiclesAndItems")
    void isHeldAsItWasSentOrRefusedBefore(int type, MissionItem item) {
        Mission mission = new Mission(List.of(BEFORE, item));
        boolean taken = abilities(type).fault(mission).isEmpty();
        FirmwareMissionVehicle vehicle = new FirmwareMissionVehicle(type == PLANE || type == VTOL);

        Outcome outcome = upload(type, vehicle, mission);

        assertThat(abilities(type).supports(MissionItem.Kind.WAYPOINT)).isTrue();
        if (taken) {
            assertThat(outcome).isEqualTo(new Outcome.Succeeded());
            assertThat(MissionCodec.fromWire(vehicle.memory.held, 1)).isEqualTo(mission.items());
        }
    }

    @Test
    void refusesBeforeWhatAVehicleWouldTakeAndNotDo() {
        assertThat(refused(COPTER)).containsExactly("Waypoint 7.4");
        assertThat(refused(ROVER)).containsExactly("TakeOff", "Waypoint 7.4", "Land", "Land", "Land");
        assertThat(refused(PLANE)).containsExactly("Waypoint 7.0", "Waypoint 7.4", "Land", "Wait");
        assertThat(refused(VTOL)).containsExactly("Waypoint 7.0", "Waypoint 7.4", "Wait");
    }

    private static List<String> refused(int type) {
        return vehiclesAndItems()
                .filter(each -> each.get()[0].equals(type))
                .map(each -> (MissionItem) each.get()[1])
                .filter(item -> abilities(type)
                        .fault(new Mission(List.of(BEFORE, item)))
                        .isPresent())
                .map(item -> item.getClass().getSimpleName()
                        + (item instanceof MissionItem.Waypoint waypoint ? " " + waypoint.holdSeconds() : ""))
                .toList();
    }

    @Test
    void looksWithTheItemThatEveryFirmwareOfArduPilotKnows() {
        FirmwareMissionVehicle vehicle = new FirmwareMissionVehicle(false);
        Mission mission = new Mission(
                List.of(BEFORE, new MissionItem.LookAt(FIELD, Altitude.aboveHome(3)), new MissionItem.LookAhead()));

        assertThat(upload(COPTER, vehicle, mission)).isEqualTo(new Outcome.Succeeded());

        assertThat(vehicle.memory.held.subList(2, 4))
                .extracting(MissionItemInt::command, MissionItemInt::x, MissionItemInt::y, MissionItemInt::z)
                .containsExactly(
                        org.assertj.core.groups.Tuple.tuple(201, 474_000_000, 85_000_000, 3f),
                        org.assertj.core.groups.Tuple.tuple(201, 0, 0, 0f));
    }

    @Test
    void takesAPlaneOffWithAPitchAndBringsItDownAtThePlace() {
        FirmwareMissionVehicle vehicle = new FirmwareMissionVehicle(true);

        assertThat(upload(PLANE, vehicle, new Mission(List.of(new MissionItem.TakeOff(40), BEFORE, LAND_AT))))
                .isEqualTo(new Outcome.Succeeded());

        assertThat(vehicle.memory.held.get(1))
                .returns(22, MissionItemInt::command)
                .returns(15f, MissionItemInt::param1);
        assertThat(vehicle.memory.held.get(3))
                .returns(21, MissionItemInt::command)
                .returns(474_000_000, MissionItemInt::x)
                .returns(85_000_000, MissionItemInt::y);
    }

    @Test
    void landsAVehicleThatHoversWithoutMakingItGlide() {
        FirmwareMissionVehicle vehicle = new FirmwareMissionVehicle(true);

        assertThat(upload(VTOL, vehicle, new Mission(List.of(BEFORE, LAND_AT)))).isEqualTo(new Outcome.Succeeded());

        assertThat(vehicle.memory.held.get(2))
                .returns(85, MissionItemInt::command)
                .returns(474_000_000, MissionItemInt::x);
    }

    /** What a ground station wrote is not written otherwise without a word. */
    @Test
    void saysWhatOfAGroundStationsItemItWouldChange() {
        assertThat(loss(PLANE, 22, 10, 0))
                .contains("has a pitch of 10.0 degrees; the cloud lets planes take off with 15");
        assertThat(loss(PLANE, 22, 15, 0)).isEmpty();
        assertThat(loss(COPTER, 22, 0, 0)).isEmpty();
        assertThat(loss(VTOL, 21, 0, 0)).contains("by NAV_VTOL_LAND only");
        assertThat(loss(VTOL, 85, 0, 0)).isEmpty();
        assertThat(loss(PLANE, 85, 0, 0)).contains("by NAV_LAND only");
        assertThat(loss(PLANE, 21, 25, 0)).contains("settings that the cloud would lose");
        assertThat(loss(COPTER, 21, 0, 1)).as("as the vehicle itself tells it").isEmpty();
        assertThat(loss(COPTER, 201, 3, 0)).isEmpty();
    }

    private static String loss(int type, int command, float first, float fourth) {
        return AutopilotAdapter.of(heartbeat(type))
                .missionItemLoss(new MissionItemInt(
                        1, 1, 1, 3, command, 0, 1, first, 0, 0, fourth, 474_000_000, 85_000_000, 20, 0))
                .orElse("");
    }

    private static MissionAbilities abilities(int type) {
        return AutopilotAdapter.of(heartbeat(type)).capabilities().missions();
    }

    private static Outcome upload(int type, FirmwareMissionVehicle vehicle, Mission mission) {
        AutopilotTestBench bench = new AutopilotTestBench(heartbeat(type));
        bench.wire.peer(vehicle::take);
        Outcome outcome = bench.perform(new Command.UploadMission(mission));
        assertThat(outcome).isNotNull();
        return outcome;
    }

    private static Heartbeat heartbeat(int type) {
        return new Heartbeat(type, 3, 81, 0, 3, 3);
    }
}
