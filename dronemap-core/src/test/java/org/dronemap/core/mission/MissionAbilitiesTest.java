package org.dronemap.core.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.MissionAbilities.Hold;
import org.dronemap.core.mission.MissionAbilities.Landing;
import org.dronemap.core.mission.MissionItem.Kind;
import org.junit.jupiter.api.Test;

class MissionAbilitiesTest {
    private static final MissionAbilities PLANE =
            MissionAbilities.ALL.without(Kind.WAIT).with(Hold.NONE).with(Landing.APPROACH);
    private static final MissionAbilities COPTER = MissionAbilities.ALL.with(Hold.WHOLE_SECONDS);
    private static final Geodetic FIELD = new Geodetic(47.4, 8.5);
    /** 445 m north of it. */
    private static final Geodetic BEFORE = new Geodetic(47.404, 8.5);

    @Test
    void namesTheItemThatTheVehicleDoesNotFlyAndWhatItFlies() {
        Mission mission = mission(waypoint(BEFORE, 30, 0), new MissionItem.Wait(5));

        assertThat(sentence(PLANE, mission))
                .isEqualTo(
                        "Item 2 (wait): this vehicle (ArduPlane) does not fly such an item in a mission; it flies"
                                + " take off, waypoint, return to launch, land, take a photo, set a servo, look at, look ahead.");
        assertThat(PLANE.fault(mission)).get().satisfies(fault -> {
            assertThat(fault.index()).isEqualTo(1);
            assertThat(fault.field()).isEqualTo("type");
        });
        assertThat(COPTER.fault(mission)).isEmpty();
    }

    @Test
    void saysWhichSecondsItWaitsAtAWaypoint() {
        Mission split = mission(new MissionItem.TakeOff(10), waypoint(BEFORE, 30, 7.4));

        assertThat(sentence(COPTER, split))
                .isEqualTo("Item 2 (waypoint): this vehicle (ArduPlane) waits for whole seconds at a waypoint;"
                        + " \"holdSeconds\" must be whole seconds, 0 to 3600, not 7.4.");
        assertThat(sentence(PLANE, mission(waypoint(BEFORE, 30, 7))))
                .isEqualTo("Item 1 (waypoint): this vehicle (ArduPlane) does not wait at a waypoint; \"holdSeconds\""
                        + " must be 0, not 7.0.");
        assertThat(COPTER.fault(mission(waypoint(BEFORE, 30, 3_600)))).isEmpty();
        assertThat(MissionAbilities.ALL.fault(split)).isEmpty();
    }

    @Test
    void letsAFixedWingLandOnlyOnAWayDownToAPlace() {
        assertThat(sentence(PLANE, mission(waypoint(BEFORE, 30, 0), new MissionItem.Land())))
                .isEqualTo("Item 2 (land): this vehicle (ArduPlane) lands on a straight way down to a place; give the"
                        + " landing a latitude and a longitude and put before it a waypoint, at least 100 m from its"
                        + " place, at least 10 m above its ground, and 6 times as far away as it is high, or end with"
                        + " return to launch, after which it circles over its home.");
        assertThat(sentence(PLANE, mission(new MissionItem.TakeOff(50), land(Altitude.aboveHome(0)))))
                .contains("put before it a waypoint");
        assertThat(PLANE.fault(
                        mission(waypoint(BEFORE, 30, 0), new MissionItem.LookAhead(), land(Altitude.aboveHome(0)))))
                .isEmpty();
        assertThat(COPTER.fault(mission(new MissionItem.Land()))).isEmpty();
    }

    @Test
    void refusesAWayDownThatIsTooSteepTooShortOrNotComparable() {
        assertThat(sentence(PLANE, mission(waypoint(BEFORE, 90, 0), land(Altitude.aboveHome(0)))))
                .endsWith("and the waypoint before it is 445 m away and 90 m high.");
        assertThat(sentence(PLANE, mission(waypoint(BEFORE, 90, 0), land(Altitude.aboveHome(85)))))
                .endsWith("445 m away and 5 m high.");
        assertThat(sentence(PLANE, mission(waypoint(new Geodetic(47.4008, 8.5), 12, 0), land(Altitude.aboveHome(0)))))
                .endsWith("89 m away and 12 m high.");
        assertThat(sentence(PLANE, mission(waypoint(BEFORE, 30, 0), land(new Altitude(430, Altitude.Reference.AMSL)))))
                .endsWith("both above home or both above sea level.");
    }

    @Test
    void letsAVehicleThatHoversOnlyAtTheEndLandAtAPlace() {
        MissionAbilities vtol = MissionAbilities.ALL.with(Landing.AT_PLACE);

        assertThat(sentence(vtol, mission(new MissionItem.Land())))
                .isEqualTo("Item 1 (land): this vehicle (ArduPlane) lands at a place; give the landing a latitude and a"
                        + " longitude, or end with return to launch.");
        assertThat(vtol.fault(mission(land(Altitude.aboveHome(0))))).isEmpty();
    }

    private static Mission mission(MissionItem... items) {
        return new Mission(List.of(items));
    }

    private static MissionItem land(Altitude ground) {
        return new MissionItem.Land(new LandingPlace(FIELD, ground));
    }

    private static MissionItem waypoint(Geodetic point, double altitude, double seconds) {
        return new MissionItem.Waypoint(point, Altitude.aboveHome(altitude), seconds);
    }

    private static String sentence(MissionAbilities vehicle, Mission mission) {
        return vehicle.fault(mission)
                .map(fault -> fault.sentence(mission, "ArduPlane"))
                .orElse("");
    }
}
