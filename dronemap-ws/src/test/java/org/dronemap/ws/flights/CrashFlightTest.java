package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.SecondGroundStation;
import org.dronemap.ws.mission.MissionItemRequest;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The server killed in mid-mission, and what it says when it is back. */
class CrashFlightTest {
    private static final long RTL = 6;
    private static final double METERS = 10;
    /** So soon after a restart all is shown again. */
    private static final Duration RETURN = Duration.ofSeconds(15);

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);
    private final LabDrone copter = lab.copter();
    private final List<Geodetic> corners = List.of(copter.place(25, 0), copter.place(25, 25), copter.place(0, 25));

    @AfterEach
    void close() {
        lab.close();
    }

    /** It has just begun a mission of three waypoints. */
    private void isInMission(String onCloudLoss) {
        ann.takesOff(copter, METERS);
        lab.until("it hovers", Duration.ofSeconds(30), () -> copter.height() > METERS - 1);
        List<MissionItem> items = corners.stream()
                .<MissionItem>map(corner -> new MissionItem.Waypoint(corner, Altitude.aboveHome(METERS), 0))
                .toList();
        ann.does(copter, CommandRequests.uploadMission(MissionItemRequest.of(items)))
                .does(copter, CommandRequests.startMission(onCloudLoss));
        lab.until(
                "it heads for the first waypoint",
                Duration.ofSeconds(10),
                () -> Objects.equals(copter.state().mission().current(), 1));
        lab.goOn(Duration.ofSeconds(1));
    }

    private void isBackWithMission() {
        lab.startServer();
        lab.until(
                "it is back and its mission was read",
                RETURN,
                () -> copter.known()
                        .filter(state -> state.link().state() == LinkState.LIVE
                                && state.mission().items() != null)
                        .isPresent());
    }

    private Stream<String> texts() {
        return copter.state().messages().stream().map(said -> said.text());
    }

    @Test
    void afterACrashTheItemThatTheVehicleFliesIsShown() {
        isInMission("continue");
        var drone = copter.id();

        lab.crashServer();
        lab.until("it passed two corners", Duration.ofSeconds(60), () -> copter.distanceTo(corners.get(1)) < 2);
        lab.goOn(Duration.ofSeconds(1));
        isBackWithMission();

        assertThat(copter.id()).isEqualTo(drone);
        assertThat(copter.state().mission().items()).hasSize(4);
        assertThat(copter.state().mode()).isEqualTo("AUTO");
        lab.until(
                "it is shown to head for the last",
                Duration.ofSeconds(5),
                () -> Objects.equals(copter.state().mission().current(), 3));
        lab.until(
                "it is said",
                Duration.ofSeconds(5),
                () -> texts().anyMatch(text -> text.contains("flew on from item 2")));
        lab.until("it flies on", Duration.ofSeconds(60), () -> copter.distanceTo(corners.get(2)) < 2);
    }

    @Test
    void afterACrashAMissionThatWasFlownMeanwhileIsSaidToBe() {
        isInMission("continue");

        lab.crashServer();
        lab.until("it was at the last corner", Duration.ofSeconds(60), () -> copter.distanceTo(corners.get(2)) < 1);
        lab.goOn(Duration.ofSeconds(5));
        isBackWithMission();

        lab.until(
                "it is said",
                Duration.ofSeconds(5),
                () -> texts().anyMatch(text -> text.contains("flew its mission to the end")));
    }

    @Test
    void afterACrashAVehicleThatWasToReturnIsShownToHaveReturned() {
        isInMission("rtl");
        var drone = copter.id();

        lab.crashServer();
        lab.until(
                "it returns",
                Duration.ofSeconds(30),
                () -> copter.vehicle().autopilot().heartbeat().customMode() == RTL);
        isBackWithMission();

        assertThat(copter.id()).isEqualTo(drone);
        assertThat(copter.state().mission().items()).hasSize(4);
        assertThat(copter.state().mode()).isEqualTo("RTL");
        lab.until("it is home", Duration.ofMinutes(2), copter::isDown);
        assertThat(copter.away()).isLessThan(2);
    }

    @Test
    void afterACrashAMissionOfSomebodyElseIsNoticed() {
        isInMission(null);
        lab.crashServer();
        Geodetic north = copter.place(22, 0);
        SecondGroundStation other = lab.otherStation(copter, List.of(copter.place(0, 0), north, north), 12);
        lab.until("it took the mission of somebody else", Duration.ofSeconds(30), other::isDone);

        isBackWithMission();

        lab.until("it is noticed", RETURN, () -> copter.state().mission().notice() != null);
        assertThat(copter.state().mission().items()).hasSize(2);
        assertThat(copter.state().mission().notice()).contains("2 items instead of 4");
    }
}
