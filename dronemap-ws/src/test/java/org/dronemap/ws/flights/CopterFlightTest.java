package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** An ArduCopter under the commands and the missions of a person. */
class CopterFlightTest {
    private static final double METERS = 12;
    private static final Duration WAY = Duration.ofMinutes(1);
    private static final Duration FLIGHT = Duration.ofMinutes(4);

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);

    @AfterEach
    void close() {
        lab.close();
    }

    private LabDrone flying() {
        LabDrone copter = lab.copter();
        ann.takesOff(copter, METERS);
        lab.until("it is up", WAY, () -> copter.height() > METERS - 0.5);
        return copter;
    }

    private static MissionItem waypoint(Geodetic place, double seconds) {
        return new MissionItem.Waypoint(place, Altitude.aboveHome(METERS), seconds);
    }

    private void isAt(LabDrone copter, Geodetic place) {
        lab.until("it is there", WAY, () -> copter.distanceTo(place) < 2);
    }

    private CommandView.OutcomeView refusal(LabDrone copter) {
        return Objects.requireNonNull(ann.outcome(copter, CommandRequests.arm()).outcome());
    }

    @Test
    void armedTooEarlyItNamesWhatItWaitsForAndArmsOnceItIsReady() {
        LabDrone copter = lab.add(VehicleSpec.COPTER.readyAfter(30));
        lab.until(
                "what it can do is known",
                WAY,
                () -> copter.known()
                        .filter(state -> state.capabilities().known())
                        .isPresent());
        ann.does(copter, CommandRequests.setMode("STABILIZE"));

        assertThat(refusal(copter).result()).isEqualTo("refused");
        assertThat(refusal(copter).reason()).contains("rm: ").doesNotContain("tilt alignment");

        lab.ready(copter);
        ann.does(copter, CommandRequests.setMode("GUIDED")).does(copter, CommandRequests.arm());
        assertThat(copter.craft().armed()).isTrue();
        ann.does(copter, CommandRequests.disarm());
        assertThat(copter.isDown()).isTrue();
        assertThat(copter.state().identification().vehicle()).isEqualTo("ArduCopter");
    }

    @Test
    void fliesByCommandsAndComesHome() {
        LabDrone copter = flying();
        ann.fliesTo(copter, copter.place(30, 0), METERS);
        isAt(copter, copter.place(30, 0));
        ann.does(copter, CommandRequests.turn(90));
        ann.fliesTo(copter, copter.place(60, 30), METERS).does(copter, CommandRequests.hold());
        assertThat(copter.state().mode()).isEqualTo("BRAKE");
        ann.does(copter, CommandRequests.takePicture()).does(copter, CommandRequests.setRelay(0, "on"));
        assertThat(copter.vehicle().autopilot().payload().words()).isEqualTo("pictures 1 relays on: 0");
        ann.does(copter, CommandRequests.returnToLaunch());
        lab.until("it is down", FLIGHT, copter::isDown);
        assertThat(copter.away()).isLessThan(3);
    }

    @Test
    void fliesAsFastAsItIsToldAndLandsWhereItIs() {
        LabDrone copter = flying();
        ann.fliesTo(copter, copter.place(400, 0), METERS);
        for (double speed : new double[] {3, 8}) {
            ann.does(copter, CommandRequests.changeSpeed(speed));
            lab.until(
                    "it flies at " + speed + " m/s",
                    Duration.ofSeconds(30),
                    () -> Math.abs(copter.craft().body().groundSpeed() - speed) < 0.5);
        }
        ann.does(copter, CommandRequests.land());
        double there = copter.away();
        lab.until("it is down", FLIGHT, copter::isDown);
        assertThat(copter.away()).isBetween(there - 1, there + 20);
    }

    @Test
    void fliesAMissionWithEveryTaskAndArmsAgainInAnotherMode() {
        LabDrone copter = lab.copter();
        Geodetic near = copter.place(30, 0);
        Geodetic far = copter.place(60, 30);
        List<MissionItem> items = List.of(
                new MissionItem.TakeOff(METERS),
                new MissionItem.LookAt(near, Altitude.aboveHome(0)),
                waypoint(near, 3),
                new MissionItem.TakePhoto(),
                new MissionItem.SetServo(9, 1_500),
                new MissionItem.Wait(2),
                new MissionItem.LookAhead(),
                new MissionItem.Waypoint(far, new Altitude(500, Altitude.Reference.AMSL), 0),
                new MissionItem.ReturnToLaunch());
        ann.uploads(copter, items);
        assertThat(copter.state().mission().items())
                .extracting(MissionItem::kind)
                .isEqualTo(items.stream().map(MissionItem::kind).toList());
        ann.does(copter, CommandRequests.setMode("GUIDED")).startsMission(copter);
        lab.until("it is armed", WAY, () -> copter.craft().armed());
        lab.until("it is down", FLIGHT, copter::isDown);
        assertThat(copter.track().nearest(near, copter.groundAmsl() + METERS)).isLessThan(2);
        assertThat(copter.track().nearest(far, 500)).isLessThan(3);
        assertThat(copter.vehicle().autopilot().payload().words()).contains("pictures 1");

        lab.until(
                "its rest is known",
                WAY,
                () -> Boolean.FALSE.equals(copter.state().armed()));
        assertThat(refusal(copter).reason()).contains("change its mode to GUIDED");
        ann.does(copter, CommandRequests.setMode("GUIDED"))
                .does(copter, CommandRequests.arm())
                .does(copter, CommandRequests.disarm())
                .does(copter, CommandRequests.clearMission());
        assertThat(copter.state().mission().items()).isEmpty();
    }

    @Test
    void goesOnWithAPausedMissionWhereItWas() {
        LabDrone copter = lab.copter();
        List<MissionItem> way = List.of(
                new MissionItem.TakeOff(METERS),
                waypoint(copter.place(30, 0), 0),
                waypoint(copter.place(30, 30), 0),
                waypoint(copter.place(30, 60), 0),
                waypoint(copter.place(30, 90), 0),
                new MissionItem.Land());
        ann.uploads(copter, way).does(copter, CommandRequests.setMode("GUIDED")).startsMission(copter);
        lab.until(
                "it has reached the second",
                FLIGHT,
                () -> copter.state().mission().reached().contains(2));
        ann.does(copter, CommandRequests.pauseMission());
        lab.until("it stands", WAY, () -> copter.craft().body().groundSpeed() < 0.2);
        long since = lab.time().nanos();
        ann.does(copter, CommandRequests.startMission(null));
        lab.until("it is down", FLIGHT, copter::isDown);
        assertThat(copter.track().nearestOverGround(copter.place(30, 0), since)).isGreaterThan(20);
        assertThat(copter.distanceTo(copter.place(30, 90))).isLessThan(3);
    }
}
