package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.ZoneFixtures;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.zone.ZoneFeature;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** No-fly zones of the cloud: what is refused, what flies round them, and what happens in flight. */
class ZoneFlightTest {
    private final Laboratory lab = new Laboratory(1);
    private final LabDrone copter = lab.copter();
    private final Pilot chief = lab.pilot("chief", Role.SUPERVISOR);

    @AfterEach
    void close() {
        lab.close();
    }

    private String put(ZoneFeature zone) {
        return Objects.requireNonNull(
                lab.server().zones().add(chief.principal(), zone).id());
    }

    private CommandRequest mission(Geodetic... places) {
        List<MissionItem> items = new ArrayList<>();
        for (Geodetic place : places) {
            items.add(new MissionItem.Waypoint(place, Altitude.aboveHome(10), 0));
        }
        return CommandRequests.uploadMission(MissionItemRequest.of(items));
    }

    private CommandRequest goTo(double north, double east) {
        Geodetic place = copter.place(north, east);
        return CommandRequests.goTo(place.latitudeDegrees(), place.longitudeDegrees(), 10.0);
    }

    private double north() {
        return copter.craft().body().position().north();
    }

    /** The newest command that the zones gave, once it has ended. */
    private Optional<CommandView> bySafety() {
        return chief.commandsOf(copter).stream()
                .filter(command -> command.face().equals("safety") && command.outcome() != null)
                .findFirst();
    }

    @Test
    void aMissionThroughAZoneIsRefusedAndOneRoundItFlies() {
        put(ZoneFixtures.box(copter, 30, 60, 20, null, null));

        // The take-off, put in front by the server, is item 1.
        assertThat(chief.refusalByGate(copter, mission(copter.place(90, 0), copter.place(90, 40))))
                .isEqualTo("The way from item 1 to item 2 enters the no-fly zone “School” after 30 m.");
        assertThat(copter.wire().traffic().down(0, MissionCount.ID))
                .as("something of it was sent")
                .isEmpty();

        chief.does(copter, mission(copter.place(0, 50), copter.place(90, 50), copter.place(90, 0)))
                .takesOff(copter, 10)
                .does(copter, CommandRequests.startMission(null));
        int last = Objects.requireNonNull(copter.state().mission().items()).size() - 1;
        lab.until(
                "it is round",
                Duration.ofMinutes(2),
                () -> copter.state().mission().reached().contains(last));
        assertThat(copter.distanceTo(copter.place(90, 0))).isLessThan(3);

        assertThat(chief.refusalByGate(copter, goTo(0, 0))).contains("enters the no-fly zone “School” after 30 m");
        chief.does(copter, CommandRequests.returnToLaunch());
        lab.until(
                "who returns through it is warned",
                Duration.ofSeconds(5),
                () -> copter.isTold("It returns all the same, but"));
        lab.until("it landed", Duration.ofMinutes(2), copter::isDown);
        lab.until(
                "the server knows",
                Duration.ofSeconds(2),
                () -> Boolean.FALSE.equals(copter.state().armed()));
    }

    @Test
    void aBreachIsWarnedOfBeforeAndActedOn() {
        chief.takesOff(copter, 10);
        chief.does(copter, goTo(400, 0));
        // Put in its way while it flies: nothing but the watch in flight can stop it now.
        lab.until("it is on its way", Duration.ofSeconds(20), () -> north() > 5);
        put(ZoneFixtures.box(copter, 150, 300, 50, "hold", null));

        lab.until("it is warned", Duration.ofSeconds(60), () -> copter.isTold("If it goes on like this it enters"));
        assertThat(north()).as("the warning came with the breach").isLessThan(150);
        lab.until("it is inside", Duration.ofSeconds(60), () -> north() >= 150);
        lab.until("it is told to hold", Duration.ofSeconds(1), () -> copter.isTold("is told: hold"));
        CommandView held = lab.until("it holds", Duration.ofSeconds(5), this::bySafety);

        assertThat(held.type()).isEqualTo("hold");
        assertThat(held.by()).isEqualTo("zones");
        assertThat(Objects.requireNonNull(held.outcome()).result()).isEqualTo("succeeded");
        lab.until(
                "it stands", Duration.ofSeconds(10), () -> copter.craft().body().groundSpeed() < 0.5);
        assertThat(north()).isBetween(150.0, 175.0);
        assertThat(chief.refusalByGate(copter, goTo(400, 0))).contains("begins inside the no-fly zone “School”");
        chief.does(copter, CommandRequests.returnToLaunch());
        lab.until("it landed", Duration.ofMinutes(3), copter::isDown);
    }

    @Test
    void aZoneThatIsPutOverADroneSendsItHome() {
        chief.takesOff(copter, 10);
        lab.until("it is up", Duration.ofSeconds(30), () -> copter.height() > 9);

        put(ZoneFixtures.box(copter, -40, 40, 40, "returnToLaunch", 5.0));

        CommandView sent = lab.until("it is sent home", Duration.ofSeconds(5), this::bySafety);
        assertThat(sent.type()).isEqualTo("returnToLaunch");
        lab.until("it landed", Duration.ofMinutes(2), copter::isDown);
    }
}
