package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.LandingPlace;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.ScriptedPeer;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.problem.InvalidInput;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What a vehicle would take and not fly as it is written is refused by item and field, and nothing is sent. */
class MissionItemsOfVehiclesTest {
    private static final int ARDUPILOT = 3;
    private static final int PLANE = 1;
    private static final int COPTER = 2;
    private static final int ROVER = 10;
    private static final Geodetic FIELD = new Geodetic(47.4, 8.5);
    private static final MissionItem BEFORE =
            new MissionItem.Waypoint(new Geodetic(47.404, 8.5), Altitude.aboveHome(40), 0);

    private final Laboratory lab = new Laboratory(1);
    private int peers;
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);

    @AfterEach
    void close() {
        lab.close();
    }

    @Test
    void aPlaneThatShallLandWhereItIsIsRefusedWithTheWayOut() {
        refuses(
                PLANE,
                new MissionItem.Land(),
                "items[1].latitude",
                "Item 2 (land): this vehicle (ArduPlane) lands on a straight way down to a place");
    }

    @Test
    void secondsThatAVehicleDoesNotKeepAreRefused() {
        refuses(
                COPTER,
                new MissionItem.Waypoint(FIELD, Altitude.aboveHome(30), 4.2),
                "items[1].holdSeconds",
                "\"holdSeconds\" must be whole seconds, 0 to 3600, not 4.2.");
        refuses(
                PLANE,
                new MissionItem.Waypoint(FIELD, Altitude.aboveHome(30), 4),
                "items[1].holdSeconds",
                "\"holdSeconds\" must be 0, not 4.0.");
    }

    @Test
    void itemsThatAVehicleWouldSkipAreRefused() {
        refuses(PLANE, new MissionItem.Wait(5), "items[1].type", "Item 2 (wait)");
        refuses(ROVER, new MissionItem.TakeOff(5), "items[1].type", "Item 2 (take off)");
        refuses(
                ROVER,
                new MissionItem.Land(LandingPlace.levelWithHome(FIELD)),
                "items[1].type",
                "this vehicle (ArduRover) does not fly such an item in a mission");
    }

    private void refuses(int type, MissionItem item, String field, String words) {
        List<Integer> received = new ArrayList<>();
        ScriptedPeer peer = lab.peer(
                ++peers,
                ScriptedPeer.Kind.vehicle(type, ARDUPILOT),
                (vehicle, frame) -> received.add(frame.messageId()));
        lab.until(
                "what it can do is known",
                Duration.ofSeconds(20),
                () -> peer.known().filter(state -> state.capabilities().known()).isPresent());

        assertThatThrownBy(() ->
                        ann.give(peer, CommandRequests.uploadMission(MissionItemRequest.of(List.of(BEFORE, item)))))
                .isInstanceOfSatisfying(InvalidInput.class, refused -> {
                    assertThat(refused.field()).isEqualTo(field);
                    assertThat(refused.sentence()).contains(words);
                });
        lab.goOn(Duration.ofSeconds(5));
        assertThat(received).isNotEmpty().doesNotContain(MissionCount.ID);
    }
}
