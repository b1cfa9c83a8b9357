package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.mission.MissionItemRequest;
import org.junit.jupiter.api.Test;

/** A ground vehicle, whose height above home means nothing. */
class RoverFlightTest {
    private static final Duration DRIVE = Duration.ofMinutes(1);

    private static LabDrone rover(Laboratory lab) {
        return lab.ready(lab.add(VehicleSpec.ROVER));
    }

    private static boolean stands(LabDrone rover) {
        return rover.craft().body().groundSpeed() < 0.1;
    }

    @Test
    void drivesToAPlaceAndComesHome() {
        try (Laboratory lab = new Laboratory(1)) {
            LabDrone rover = rover(lab);
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            Geodetic place = rover.place(40, 30);
            ann.does(rover, CommandRequests.setMode("GUIDED")).does(rover, CommandRequests.arm());
            ann.fliesTo(rover, place, 5);
            lab.until("it is there", DRIVE, () -> rover.distanceTo(place) < 1 && stands(rover));
            ann.does(rover, CommandRequests.returnToLaunch());
            lab.until("it is home", DRIVE, () -> rover.away() < 1 && stands(rover));
            assertThat(rover.craft().armed()).isTrue();
            ann.does(rover, CommandRequests.hold()).does(rover, CommandRequests.disarm());
            assertThat(rover.craft().armed()).isFalse();
        }
    }

    @Test
    void drivesAsSlowlyAsItIsToldAndStops() {
        try (Laboratory lab = new Laboratory(1)) {
            LabDrone rover = rover(lab);
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            ann.does(rover, CommandRequests.setMode("GUIDED")).does(rover, CommandRequests.arm());
            ann.fliesTo(rover, rover.place(100, 0), 0).does(rover, CommandRequests.changeSpeed(1));
            lab.until(
                    "it drives as slowly as it is told",
                    Duration.ofSeconds(30),
                    () -> Math.abs(rover.craft().body().groundSpeed() - 1) < 0.2);
            ann.does(rover, CommandRequests.hold());
            assertThat(rover.state().mode()).isEqualTo("HOLD");
            lab.until("it stands", DRIVE, () -> stands(rover));
            assertThat(rover.away()).isBetween(1.0, 90.0);
        }
    }

    @Test
    void neverFliesHoweverHighItIsAboveItsHome() {
        try (Laboratory lab = new Laboratory(1)) {
            LabDrone rover = rover(lab);
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            Geodetic here = rover.place(0, 0);
            ann.does(rover, CommandRequests.setMode("GUIDED")).does(rover, CommandRequests.arm());
            ann.does(
                    rover,
                    CommandRequests.setHome(here.latitudeDegrees(), here.longitudeDegrees(), rover.groundAmsl() - 5));
            lab.until("its height has followed", DRIVE, () -> heightAboveHome(rover) > 3);
            assertThat(rover.state().airborne()).isFalse();
            ann.does(rover, CommandRequests.disarm());
        }
    }

    private static double heightAboveHome(LabDrone rover) {
        Double height = Objects.requireNonNull(rover.state().position()).altitudeAboveHomeMeters();
        return height == null ? Double.NaN : height;
    }

    @Test
    void goesOnWithAPausedMissionWhereItWas() {
        try (Laboratory lab = new Laboratory(1)) {
            LabDrone rover = rover(lab);
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            List<MissionItem> items = List.of(
                    waypoint(rover.place(25, 0), 0),
                    waypoint(rover.place(25, 25), 0),
                    waypoint(rover.place(25, 50), 0),
                    new MissionItem.LookAt(rover.place(25, 0), Altitude.aboveHome(0)),
                    new MissionItem.TakePhoto(),
                    new MissionItem.SetServo(9, 1_500),
                    new MissionItem.LookAhead(),
                    waypoint(rover.place(5, 50), 2));
            ann.uploads(rover, items)
                    .does(rover, CommandRequests.setMode("GUIDED"))
                    .startsMission(rover);
            lab.until(
                    "it has reached the first",
                    DRIVE,
                    () -> rover.state().mission().reached().contains(0));
            lab.until("it drives on", DRIVE, () -> rover.distanceTo(rover.place(25, 0)) > 8);
            ann.does(rover, CommandRequests.pauseMission());
            lab.until("it stands", DRIVE, () -> stands(rover));
            long since = lab.time().nanos();
            ann.does(rover, CommandRequests.startMission(null));
            lab.until("it is at the last", Duration.ofMinutes(3), () -> rover.distanceTo(rover.place(5, 50)) < 4);
            lab.until(
                    "its mission is complete",
                    DRIVE,
                    () -> rover.state().mission().complete());
            assertThat(rover.track().nearestOverGround(rover.place(25, 0), since))
                    .isGreaterThan(7);
            assertThat(rover.vehicle().autopilot().payload().words()).contains("pictures 1");
            ann.does(rover, CommandRequests.disarm()).does(rover, CommandRequests.clearMission());
            assertThat(rover.state().mission().items()).isEmpty();
        }
    }

    private static MissionItem waypoint(Geodetic place, double seconds) {
        return new MissionItem.Waypoint(place, Altitude.aboveHome(0), seconds);
    }

    @Test
    void drivesAMissionToItsEnd() {
        try (Laboratory lab = new Laboratory(1)) {
            LabDrone rover = rover(lab);
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            List<Geodetic> corners = List.of(rover.place(30, 0), rover.place(30, 30));
            List<MissionItem> items = Stream.concat(
                            corners.stream().map(corner ->
                                    (MissionItem) new MissionItem.Waypoint(corner, Altitude.aboveHome(5), 0)),
                            Stream.of(new MissionItem.ReturnToLaunch()))
                    .toList();
            ann.does(rover, CommandRequests.uploadMission(MissionItemRequest.of(items)))
                    .does(rover, CommandRequests.setMode("HOLD"))
                    .does(rover, CommandRequests.arm())
                    .does(rover, CommandRequests.startMission(null));
            for (Geodetic corner : corners) {
                lab.until("it is at the next corner", DRIVE, () -> rover.distanceTo(corner) < 3.5);
            }
            lab.until("it is home", DRIVE, () -> rover.away() < 1 && stands(rover));
            lab.until("it says that all is done", DRIVE, () -> rover.isTold("Mission Complete"));
            assertThat(rover.craft().armed()).isTrue();
        }
    }

    @Test
    void refusesToTakeOffAndToLand() {
        try (Laboratory lab = new Laboratory(1)) {
            LabDrone rover = rover(lab);
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            assertThat(ann.refusal(rover, CommandRequests.takeOff(10.0)))
                    .isEqualTo("This vehicle (ArduRover) cannot take off.");
            assertThat(ann.refusal(rover, CommandRequests.land())).isEqualTo("This vehicle (ArduRover) cannot land.");
        }
    }
}
