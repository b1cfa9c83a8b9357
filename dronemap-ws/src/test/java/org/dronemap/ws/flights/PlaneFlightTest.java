package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.LandingPlace;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.control.ControlRequest;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.WingedSpecs;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** An ArduPlane, which cannot stop in the air, under the commands and the missions of a person. */
class PlaneFlightTest {
    private static final Duration CLIMB = Duration.ofMinutes(1);
    private static final Duration WAY = Duration.ofMinutes(3);
    private static final Duration SOON = Duration.ofSeconds(40);
    private static final double METERS = 60;
    /** It circles at 80 m (WP_LOITER_RAD), and a quarter wider as a real one does. */
    private static final double ROUND_METERS = 130;

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);
    private final LabDrone plane = lab.ready(lab.add(WingedSpecs.PLANE));
    private final Geodetic north = plane.place(600, 0);
    private final Geodetic east = plane.place(600, 500);

    @AfterEach
    void close() {
        lab.close();
    }

    private static MissionItem waypoint(Geodetic place) {
        return new MissionItem.Waypoint(place, Altitude.aboveHome(METERS), 0);
    }

    private void isHome() {
        lab.until("it is home", WAY, () -> plane.away() < 130 && plane.height() > 95);
        lab.throughout("it circles there", Duration.ofMinutes(1), () -> plane.away() < 140 && plane.height() > 90);
        assertThat(plane.craft().armed()).isTrue();
    }

    /** Two rounds, with its holder at the page: without a sign it would be called home. */
    private void circlesAtEast() {
        long epoch = ann.takesControl(plane).epoch();
        for (int fives = 0; fives < 16; fives++) {
            ann.controls(plane, new ControlRequest.Heartbeat(epoch));
            lab.throughout(
                    "it circles there",
                    Duration.ofSeconds(5),
                    () -> plane.distanceTo(east) < ROUND_METERS && Math.abs(plane.height() - METERS) < 10);
        }
        assertThat(plane.state().mode()).isEqualTo("GUIDED");
        ann.releases(plane.id().value());
    }

    @Test
    void itTakesOffByItsModeAndCirclesAtHomeWhenItReturns() {
        assertThat(plane.state().identification().vehicle()).startsWith("ArduPlane");
        ann.does(plane, CommandRequests.setMode("TAKEOFF")).does(plane, CommandRequests.arm());
        lab.until("it is up", CLIMB, () -> plane.height() > 45);

        ann.does(plane, CommandRequests.returnToLaunch());
        isHome();
    }

    @Test
    void itFliesByCommandsOnceAMissionHasBroughtItUp() {
        ann.uploads(plane, List.of(new MissionItem.TakeOff(METERS), waypoint(north), new MissionItem.ReturnToLaunch()))
                .startsMission(plane);
        lab.until("it is up", CLIMB, () -> plane.height() > 40);

        ann.fliesTo(plane, east, METERS);
        lab.until("it is there", WAY, () -> plane.distanceTo(east) < ROUND_METERS);
        circlesAtEast();
        ann.does(plane, CommandRequests.changeSpeed(15));
        lab.until(
                "it flies as slowly as it is told",
                SOON,
                () -> Math.abs(plane.craft().body().airSpeed(plane.craft().wind()) - 15) < 1);
        ann.does(plane, CommandRequests.hold());
        assertThat(plane.state().mode()).isEqualTo("LOITER");
        ann.does(plane, CommandRequests.setMode("CIRCLE"));
        ann.does(plane, CommandRequests.returnToLaunch());
        isHome();
    }

    @Test
    void itFliesAMissionWithEveryTaskAndLandsAtItsEnd() {
        List<MissionItem> items = List.of(
                new MissionItem.TakeOff(METERS),
                waypoint(north),
                new MissionItem.TakePhoto(),
                new MissionItem.SetServo(9, 1_500),
                new MissionItem.LookAt(north, Altitude.aboveHome(0)),
                waypoint(east),
                new MissionItem.LookAhead(),
                new MissionItem.Land(LandingPlace.levelWithHome(plane.place(0, 0))));
        ann.uploads(plane, items).startsMission(plane);
        lab.until("it climbs", CLIMB, () -> plane.height() > 30);
        ann.does(plane, CommandRequests.pauseMission());
        lab.until("it circles", SOON, () -> "LOITER".equals(plane.state().mode()));
        lab.goOn(SOON);
        long since = lab.time().nanos();
        ann.does(plane, CommandRequests.startMission(null));
        lab.until("it has landed", Duration.ofMinutes(7), plane::isDown);

        assertThat(plane.away()).isLessThan(150);
        assertThat(plane.height()).isBetween(-1.0, 1.0);
        assertThat(plane.track().nearestOverGround(north, since)).isLessThan(90);
        assertThat(plane.track().nearestOverGround(east, since)).isLessThan(90);
        assertThat(plane.vehicle().autopilot().payload().words()).contains("pictures 1");
        lab.until(
                "its rest is known",
                SOON,
                () -> Boolean.FALSE.equals(plane.state().armed()));
        ann.does(plane, CommandRequests.clearMission());
        assertThat(plane.state().mission().items()).isEmpty();
        fliesAgain();
    }

    /** It is not armed where its mission has landed it. */
    private void fliesAgain() {
        ann.does(plane, CommandRequests.setMode("GUIDED"));
        assertThat(ann.outcome(plane, CommandRequests.arm()).outcome())
                .extracting(CommandView.OutcomeView::reason)
                .asString()
                .contains("change its mode to MANUAL first");
        ann.does(plane, CommandRequests.setMode("MANUAL")).does(plane, CommandRequests.arm());
        assertThat(plane.craft().armed()).isTrue();
    }

    @Test
    void whatItCannotIsRefusedWithTheWayOut() {
        for (var command : List.of(CommandRequests.takeOff(30.0), CommandRequests.land())) {
            assertThat(ann.refusal(plane, command)).contains("by a mission");
        }
        assertThat(ann.refusal(plane, CommandRequests.turn(90))).contains("cannot turn");
    }
}
