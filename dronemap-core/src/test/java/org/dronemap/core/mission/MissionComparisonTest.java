package org.dronemap.core.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.junit.jupiter.api.Test;

class MissionComparisonTest {
    private static final MissionItem CLIMB = new MissionItem.TakeOff(20);
    private static final MissionItem HERE = waypoint(47.1234567, 8.7654321, 20);
    private static final MissionItem HOME = new MissionItem.ReturnToLaunch();

    @Test
    void forgivesTheRoundingOfTheWire() {
        MissionItem rounded = waypoint(47.12345671, 8.76543209, 20.000001);

        assertThat(MissionComparison.difference(List.of(CLIMB, HERE), List.of(CLIMB, rounded)))
                .isEmpty();
    }

    @Test
    void seesAMovedWaypointAndNamesItsNumber() {
        MissionItem moved = waypoint(47.12346, 8.7654321, 20);

        assertThat(MissionComparison.difference(List.of(CLIMB, HERE, HOME), List.of(CLIMB, moved, HOME)))
                .contains("item 2 differs");
    }

    @Test
    void seesAnotherAltitudeReference() {
        MissionItem amsl = new MissionItem.Waypoint(
                new Geodetic(47.1234567, 8.7654321), new Altitude(20, Altitude.Reference.AMSL), 0);

        assertThat(MissionComparison.difference(List.of(HERE), List.of(amsl))).contains("item 1 differs");
    }

    @Test
    void seesAnotherPlaceOfALanding() {
        MissionItem here = new MissionItem.Land();
        MissionItem field = new MissionItem.Land(LandingPlace.levelWithHome(new Geodetic(47.1234567, 8.7654321)));
        MissionItem rounded = new MissionItem.Land(LandingPlace.levelWithHome(new Geodetic(47.1234568, 8.7654321)));
        MissionItem moved = new MissionItem.Land(LandingPlace.levelWithHome(new Geodetic(47.12346, 8.7654321)));

        assertThat(MissionComparison.difference(List.of(field), List.of(rounded)))
                .isEmpty();
        assertThat(MissionComparison.difference(List.of(field), List.of(moved))).contains("item 1 differs");
        assertThat(MissionComparison.difference(List.of(field), List.of(here))).contains("item 1 differs");
        assertThat(MissionComparison.difference(List.of(here), List.of(here))).isEmpty();
    }

    @Test
    void seesMissingItemsAndOtherKinds() {
        assertThat(MissionComparison.difference(List.of(CLIMB, HERE, HOME), List.of(HERE, CLIMB)))
                .contains("2 items instead of 3; items 1, 2 differ");
    }

    @Test
    void countsASingleItemAsOne() {
        assertThat(MissionComparison.difference(List.of(CLIMB, HERE), List.of(CLIMB)))
                .contains("1 item instead of 2");
    }

    private static MissionItem waypoint(double latitude, double longitude, double altitude) {
        return new MissionItem.Waypoint(new Geodetic(latitude, longitude), Altitude.aboveHome(altitude), 0);
    }
}
