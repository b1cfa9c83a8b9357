package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LinkTap;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.mission.MissionItemRequest;
import org.junit.jupiter.api.Test;

/** The same flight with PX4 and over MAVLink 1. */
class OtherAutopilotsTest {
    private static final double HEIGHT = 12;
    private static final int NAV_TAKEOFF = 22;
    private static final int DO_REPOSITION = 192;

    /** Arms, takes off, goes somewhere, flies a mission, comes home. */
    private static void fly(Laboratory lab, LabDrone drone) {
        Pilot ann = lab.pilot("ann", Role.OPERATOR);
        List<Geodetic> corners = List.of(drone.place(20, 0), drone.place(20, 20), drone.place(0, 20));
        ann.does(drone, CommandRequests.arm()).does(drone, CommandRequests.takeOff(HEIGHT));
        lab.until("it hovers", Duration.ofSeconds(60), () -> drone.height() > HEIGHT - 1 && above(drone) > HEIGHT - 1);
        ann.fliesTo(drone, corners.get(0), HEIGHT);
        lab.until(
                "it is where it was told to go",
                Duration.ofSeconds(60),
                () -> drone.distanceTo(corners.get(0)) < 2 && saidAway(drone, corners.get(0)) < 2);
        assertThat(drone.height()).isBetween(HEIGHT - 1, HEIGHT + 1);
        List<MissionItem> items = new ArrayList<>();
        corners.forEach(corner -> items.add(new MissionItem.Waypoint(corner, Altitude.aboveHome(HEIGHT), 0)));
        ann.does(drone, CommandRequests.uploadMission(MissionItemRequest.of(items)))
                .does(drone, CommandRequests.startMission(null));
        int last = drone.state().mission().items().size() - 1;
        for (Geodetic corner : corners) {
            lab.until("it is at the next corner", Duration.ofSeconds(60), () -> drone.distanceTo(corner) < 2);
            assertThat(drone.height()).isBetween(HEIGHT - 1, HEIGHT + 1);
        }
        lab.until("the last item is reached", Duration.ofSeconds(60), () -> reached(drone, last));
        // Not every vehicle says it: MAVLink 1 has no field for it.
        lab.until("the mission is over", Duration.ofSeconds(30), () -> isOver(drone));
        assertThat(reached(drone, last)).as("what was reached stays so").isTrue();
        ann.does(drone, CommandRequests.hold()).does(drone, CommandRequests.returnToLaunch());
        lab.until(
                "it landed and disarmed",
                Duration.ofSeconds(150),
                () -> drone.isDown() && Boolean.FALSE.equals(drone.state().armed()));
        assertThat(above(drone)).isLessThan(1);
        assertThat(drone.height()).isLessThan(1);
        assertThat(drone.away()).isLessThan(2);
    }

    private static boolean reached(LabDrone drone, int item) {
        return drone.state().mission().reached().contains(item);
    }

    private static boolean isOver(LabDrone drone) {
        var phase = drone.state().mission().phase();
        return phase == null || phase.name().equals("COMPLETE");
    }

    private static double above(LabDrone drone) {
        Double above = drone.state().position().altitudeAboveHomeMeters();
        return above == null ? 0 : above;
    }

    private static double saidAway(LabDrone drone, Geodetic place) {
        return Geodesy.distanceMeters(drone.state().position().point(), place);
    }

    @Test
    void px4FliesByItsOwnCommands() {
        try (Laboratory lab = new Laboratory(1)) {
            LabDrone px4 = lab.ready(lab.add(VehicleSpec.PX4));
            assertThat(px4.state().identification().autopilot()).isEqualTo("PX4");
            LinkTap tap = px4.wire().tap();

            fly(lab, px4);

            List<Integer> orders = Stream.concat(
                            tap.told(CommandLong.ID, CommandLong::decode).stream()
                                    .map(CommandLong::command),
                            tap.told(CommandInt.ID, CommandInt::decode).stream().map(CommandInt::command))
                    .toList();
            assertThat(orders).contains(NAV_TAKEOFF, DO_REPOSITION);
            assertThat(tap.told(SetPositionTargetGlobalInt.ID, SetPositionTargetGlobalInt::decode))
                    .as("that is ArduPilot's way")
                    .isEmpty();
        }
    }

    @Test
    void mavlink1CarriesAFlight() {
        try (Laboratory lab = new Laboratory(1)) {
            LabDrone old = lab.add(VehicleSpec.COPTER.ofMavlink1());
            LinkTap tap = old.wire().tap();
            lab.ready(old);

            fly(lab, old);

            assertThat(tap.all()).isNotEmpty().allMatch(heard -> heard.frame().version() == 1);
        }
    }
}
