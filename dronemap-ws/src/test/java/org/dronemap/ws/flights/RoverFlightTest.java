package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
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
        }
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
    void refusesToTakeOff() {
        try (Laboratory lab = new Laboratory(1)) {
            LabDrone rover = rover(lab);
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            assertThat(ann.refusal(rover, CommandRequests.takeOff(10.0)))
                    .isEqualTo("This vehicle (ArduRover) cannot take off.");
        }
    }
}
