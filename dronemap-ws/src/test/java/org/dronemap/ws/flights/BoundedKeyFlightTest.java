package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.key.AccessKeyArea;
import org.dronemap.ws.key.AccessKeyRequest;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.problem.InvalidInput;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** An access key for an area and heights, on a drone that flies. */
class BoundedKeyFlightTest {
    private static final double CIRCLE_METERS = 150;
    private static final double CEILING_METERS = 30;
    private static final int REPOSITION = 192;
    private static final String BEYOND = "leaves the bounds of this access key after";
    private static final String CEILING = "over the ceiling of the bounds of this access key at 30 m above home";

    private static AccessKeyRequest key(
            LabDrone copter, @Nullable Double radius, @Nullable Double ceiling, @Nullable List<String> operations) {
        Geodetic home = copter.place(0, 0);
        AccessKeyArea area = radius == null
                ? null
                : new AccessKeyArea.Point(List.of(home.longitudeDegrees(), home.latitudeDegrees()), radius);
        return new AccessKeyRequest(
                "field",
                null,
                operations == null ? null : operations.stream().toList(),
                null,
                area,
                null,
                ceiling,
                null,
                null);
    }

    private static CommandRequest goTo(LabDrone copter, double north, double height) {
        Geodetic place = copter.place(north, 0);
        return CommandRequests.goTo(place.latitudeDegrees(), place.longitudeDegrees(), height);
    }

    private static CommandRequest mission(LabDrone copter, double... norths) {
        List<MissionItem> items = new ArrayList<>();
        for (double north : norths) {
            items.add(new MissionItem.Waypoint(copter.place(north, 0), Altitude.aboveHome(10), 0));
        }
        return CommandRequests.uploadMission(MissionItemRequest.of(items));
    }

    /** It was told to go somewhere. */
    private static boolean wasSentSomewhere(LabDrone copter) {
        return copter.wire().traffic().down(0, SetPositionTargetGlobalInt.ID, CommandInt.ID).stream()
                .anyMatch(heard -> heard.frame().messageId() != CommandInt.ID
                        || CommandInt.decode(heard.frame()).command() == REPOSITION);
    }

    @Test
    void whatABoundedKeyCommandsStaysInItsAreaAndHeights() {
        try (Laboratory lab = new Laboratory(1)) {
            LabDrone copter = lab.copter();
            Pilot field = lab.pilot("ann", Role.OPERATOR)
                    .withKey(key(copter, CIRCLE_METERS, CEILING_METERS, List.of("view", "plan", "command")));
            // Never wider: not the area, not the heights; what is left out is inherited.
            assertThatThrownBy(() -> field.withKey(key(copter, CIRCLE_METERS + 1, null, null)))
                    .isInstanceOfSatisfying(
                            InvalidInput.class,
                            wrong -> assertThat(wrong.field()).isEqualTo("area"));
            assertThatThrownBy(() -> field.withKey(key(copter, null, CEILING_METERS + 1, null)))
                    .isInstanceOfSatisfying(
                            InvalidInput.class,
                            wrong -> assertThat(wrong.field()).isEqualTo("ceiling"));
            Pilot near = field.withKey(key(copter, 60.0, null, null));

            takesOffBelowTheCeiling(lab, copter, field);
            refusesWhatLeavesTheBounds(copter, field, near);

            field.does(copter, goTo(copter, 100, 10));
            assertThat(wasSentSomewhere(copter)).isTrue();
            lab.until("it is out of the child's reach", Duration.ofSeconds(60), () -> copter.away() > 65);
            field.does(copter, mission(copter, 50, 120));
            // Whoever was let in further may go on; the child may still call it home.
            near.does(copter, CommandRequests.returnToLaunch());
            lab.until("it landed", Duration.ofMinutes(2), copter::isDown);
        }
    }

    private static void takesOffBelowTheCeiling(Laboratory lab, LabDrone copter, Pilot field) {
        field.does(copter, CommandRequests.setMode("GUIDED")).does(copter, CommandRequests.arm());
        assertThat(field.refusalByGate(copter, CommandRequests.takeOff(40.0))).contains(CEILING);
        field.does(copter, CommandRequests.takeOff(10.0));
        lab.until("it is up", Duration.ofSeconds(30), () -> copter.height() > 9);
    }

    private static void refusesWhatLeavesTheBounds(LabDrone copter, Pilot field, Pilot near) {
        assertThat(field.refusalByGate(copter, goTo(copter, 200, 10))).contains(BEYOND);
        assertThat(near.refusalByGate(copter, goTo(copter, 100, 10))).contains(BEYOND);
        // Inherited from the key that it was made with.
        assertThat(near.refusalByGate(copter, goTo(copter, 20, 40))).contains(CEILING);
        assertThat(field.refusalByGate(copter, mission(copter, 50, 200, 20))).contains(BEYOND);
        assertThat(copter.wire().traffic().down(0, MissionCount.ID)).isEmpty();
        assertThat(wasSentSomewhere(copter)).isFalse();
    }
}
