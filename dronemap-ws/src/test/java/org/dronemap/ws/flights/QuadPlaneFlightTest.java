package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.LandingPlace;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.WingedSpecs;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A QuadPlane, which climbs and lands on lift motors and flies ways on its wings. */
class QuadPlaneFlightTest {
    private static final double CLIMB_METERS = 15;
    private static final double METERS = 40;
    private static final Duration WAY = Duration.ofMinutes(3);
    private static final Duration FLIGHT = Duration.ofMinutes(6);

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);
    private final LabDrone quadplane = lab.ready(lab.add(WingedSpecs.QUADPLANE));
    private final Geodetic north = quadplane.place(300, 0);

    @AfterEach
    void close() {
        lab.close();
    }

    private void takesOff() {
        ann.takesOff(quadplane, CLIMB_METERS);
        lab.until("it is up", WAY, () -> quadplane.height() > CLIMB_METERS - 1);
    }

    private void isDownAtHome() {
        lab.until("it is down", FLIGHT, quadplane::isDown);
        assertThat(quadplane.away()).isLessThan(15);
    }

    @Test
    void fliesByCommandsAndComesHome() {
        assertThat(quadplane.state().identification().kind()).isEqualTo(VehicleKind.VTOL);
        takesOff();
        ann.fliesTo(quadplane, north, METERS);
        lab.until("it is there", WAY, () -> quadplane.distanceTo(north) < 120);
        ann.does(quadplane, CommandRequests.hold());
        assertThat(quadplane.state().mode()).isEqualTo("QLOITER");
        ann.does(quadplane, CommandRequests.returnToLaunch());
        isDownAtHome();
    }

    @Test
    void landsWhereItIs() {
        takesOff();
        ann.does(quadplane, CommandRequests.land());
        assertThat(quadplane.state().mode()).isEqualTo("QLAND");
        isDownAtHome();
    }

    @Test
    void fliesAMissionAndLandsAtItsEnd() {
        ann.uploads(
                        quadplane,
                        List.of(
                                new MissionItem.TakeOff(METERS),
                                new MissionItem.Waypoint(north, Altitude.aboveHome(METERS), 0),
                                new MissionItem.Land(LandingPlace.levelWithHome(quadplane.place(0, 0)))))
                .does(quadplane, CommandRequests.setMode("GUIDED"))
                .startsMission(quadplane);
        lab.until("it climbs", WAY, () -> quadplane.height() > METERS / 2);
        isDownAtHome();
        assertThat(quadplane.track().nearestOverGround(north, 0)).isLessThan(120);
    }

    @Test
    void aMissionThatReturnsCirclesAtHomeAndComesDownWhenItIsTold() {
        ann.uploads(
                        quadplane,
                        List.of(
                                new MissionItem.TakeOff(METERS),
                                new MissionItem.Waypoint(north, Altitude.aboveHome(METERS), 0),
                                new MissionItem.ReturnToLaunch()))
                .does(quadplane, CommandRequests.setMode("GUIDED"))
                .startsMission(quadplane);
        lab.until("it climbs", WAY, () -> quadplane.height() > METERS / 2);
        ann.does(quadplane, CommandRequests.pauseMission());
        lab.until("it stays", WAY, () -> "QLOITER".equals(quadplane.state().mode()));
        ann.does(quadplane, CommandRequests.startMission(null));
        lab.until(
                "its mission sends it home",
                FLIGHT,
                () -> "RTL".equals(quadplane.state().mode()));
        assertThat(quadplane.track().nearestOverGround(north, 0)).isLessThan(120);
        assertThat(quadplane.craft().armed()).isTrue();
        ann.does(quadplane, CommandRequests.returnToLaunch());
        isDownAtHome();
    }
}
