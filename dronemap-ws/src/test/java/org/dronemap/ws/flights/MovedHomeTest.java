package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.Home;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.key.AccessKeyRequest;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.zone.ZoneFeature;
import org.dronemap.ws.zone.ZoneGeometry;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** No bound of heights moves with a home that somebody moves: zones, keys, and what is watched in flight. */
class MovedHomeTest {
    private static final String AUTOPILOTS = "org.dronemap.ws.lab.VehicleSpec#autopilots";
    private static final double CEILING_METERS = 50;
    private static final double RAISED_METERS = 100;

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);
    private final Pilot chief = lab.pilot("chief", Role.SUPERVISOR);

    @AfterEach
    void close() {
        lab.close();
    }

    private LabDrone drone(VehicleSpec kit) {
        return lab.ready(lab.add(kit));
    }

    private void ceiling(LabDrone drone) {
        Geodetic middle = drone.place(0, 0);
        lab.server()
                .zones()
                .add(
                        chief.principal(),
                        new ZoneFeature(
                                "Feature",
                                null,
                                new ZoneGeometry.Point(List.of(middle.longitudeDegrees(), middle.latitudeDegrees())),
                                new ZoneFeature.ZoneProperties(
                                        "Field",
                                        "inclusion",
                                        1_000.0,
                                        null,
                                        CEILING_METERS,
                                        "home",
                                        null,
                                        drone.id().value(),
                                        null,
                                        null,
                                        "hold",
                                        null,
                                        null)));
    }

    private void takesOff(LabDrone drone, VehicleSpec kit) {
        if (!kit.isPx4()) {
            ann.does(drone, CommandRequests.setMode("GUIDED"));
        }
        ann.does(drone, CommandRequests.arm()).does(drone, CommandRequests.takeOff(20.0));
        lab.until("it is up", Duration.ofMinutes(1), () -> up(drone) > 19);
    }

    /** Above the ground that it left. */
    private static double up(LabDrone drone) {
        return drone.craft().body().position().up();
    }

    private static double homeAmsl(LabDrone drone) {
        return drone.craft().home().altitudeAmsl();
    }

    private static CommandRequest raisedHome(LabDrone drone) {
        Geodetic here = drone.place(0, 0);
        return CommandRequests.setHome(
                here.latitudeDegrees(), here.longitudeDegrees(), homeAmsl(drone) + RAISED_METERS);
    }

    private void raiseHome(LabDrone drone) {
        double wanted = homeAmsl(drone) + RAISED_METERS;
        ann.does(drone, raisedHome(drone));
        lab.until("it is known", Duration.ofSeconds(30), () -> {
            Home home = drone.state().home();
            return home != null && Math.abs(home.altitudeAmslMeters() - wanted) < 1;
        });
        lab.goOn(Duration.ofSeconds(2));
    }

    private static CommandRequest goTo(LabDrone drone, double height) {
        Geodetic place = drone.place(60, 0);
        return CommandRequests.goTo(place.latitudeDegrees(), place.longitudeDegrees(), height);
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void aHomeIsNotRaisedWhereAZoneIsMeasuredFromIt(VehicleSpec kit) {
        LabDrone drone = drone(kit);
        ceiling(drone);
        double before = homeAmsl(drone);

        assertThat(ann.refusalByGate(drone, raisedHome(drone))).contains("at that height only");
        takesOff(drone, kit);
        assertThat(ann.refusalByGate(drone, raisedHome(drone))).contains("at that height only");
        assertThat(ann.refusalByGate(drone, CommandRequests.setHome())).contains("at that height only");

        assertThat(homeAmsl(drone)).isEqualTo(before);
        Geodetic beside = drone.place(10, 0);
        ann.does(drone, CommandRequests.setHome(beside.latitudeDegrees(), beside.longitudeDegrees(), before));
        ann.does(drone, goTo(drone, CEILING_METERS));
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void aCeilingStaysWhereItIsWhenHomeWasRaisedBeforeTheStart(VehicleSpec kit) {
        LabDrone drone = drone(kit);
        raiseHome(drone);
        ceiling(drone);

        assertThat(ann.refusalByGate(
                        drone,
                        CommandRequests.uploadMission(MissionItemRequest.of(List.of(
                                new MissionItem.TakeOff(40),
                                new MissionItem.Waypoint(drone.place(60, 0), Altitude.aboveHome(40), 0))))))
                .contains("over the ceiling of");
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void aCeilingStaysWhereItIsWhenHomeWasRaisedInTheAirAndAfterACrash(VehicleSpec kit) {
        LabDrone drone = drone(kit);
        takesOff(drone, kit);
        raiseHome(drone);
        ceiling(drone);

        assertThat(ann.refusalByGate(drone, goTo(drone, 40)))
                .contains("140 m above home, over the ceiling of")
                .contains("at 50 m above home");
        lab.crashServer();
        lab.startServer();
        lab.until("it is heard", Duration.ofSeconds(30), () -> drone.state().home() != null && !drone.isLost());
        lab.goOn(Duration.ofSeconds(2));
        assertThat(ann.refusalByGate(drone, goTo(drone, 40))).contains("over the ceiling of");
        ann.does(drone, goTo(drone, 40 - RAISED_METERS));
        assertThat(up(drone)).isLessThan(CEILING_METERS);
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void theBoundsOfAKeyStayWhereTheyAre(VehicleSpec kit) {
        LabDrone drone = drone(kit);
        Pilot field =
                ann.withKey(new AccessKeyRequest("field", null, null, null, null, null, CEILING_METERS, null, null));
        takesOff(drone, kit);
        raiseHome(drone);

        assertThat(field.refusalByGate(drone, goTo(drone, 40)))
                .contains("over the ceiling of the bounds of this access key");
        assertThat(field.refusalByGate(drone, raisedHome(drone))).contains("home cannot be moved");
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void whatIsWatchedInFlightIsMeasuredFromTheGround(VehicleSpec kit) {
        LabDrone drone = drone(kit);
        takesOff(drone, kit);
        ann.does(drone, goTo(drone, 90));
        lab.until("it is high", Duration.ofMinutes(2), () -> up(drone) > 85);
        raiseHome(drone);

        ceiling(drone);

        lab.until("it is told to hold", Duration.ofSeconds(10), () -> drone.isTold("is told: hold"));
    }
}
