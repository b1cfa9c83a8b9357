package org.dronemap.core.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.junit.jupiter.api.Test;

class MissionWarningsTest {
    private static final Geodetic DRONE = new Geodetic(47, 8);

    private static MissionItem at(double latitude, double altitude) {
        return new MissionItem.Waypoint(new Geodetic(latitude, 8), Altitude.aboveHome(altitude), 0);
    }

    /** With a take-off in front, so that the first waypoint is item 2. */
    private static List<String> doubts(MissionItem... waypoints) {
        List<MissionItem> items = new ArrayList<>(List.of(new MissionItem.TakeOff(20)));
        items.addAll(List.of(waypoints));
        return MissionWarnings.about(new Mission(items), DRONE);
    }

    @Test
    void saysNothingAboutAnOrdinaryMission() {
        assertThat(doubts(at(47.01, 20), at(47.05, 499))).isEmpty();
    }

    @Test
    void namesTheWaypointThatIsFarAway() {
        assertThat(doubts(at(47.01, 20), at(47.1, 20))).containsExactly("Item 3 is 11.12 km away from the drone.");
        assertThat(doubts(at(47.1, 20), at(47.12, 20)))
                .containsExactly("2 waypoints are more than 10 km away from the drone; item 3 is 13.34 km away.");
    }

    @Test
    void namesALongLegAndALongWay() {
        assertThat(doubts(at(47.01, 20), at(47.5, 20)))
                .contains("From item 2 to item 3 it is 54.49 km.", "The whole way is 54.49 km.");
    }

    @Test
    void namesOddAltitudesAboveHomeOnly() {
        MissionItem amsl = new MissionItem.Waypoint(DRONE, new Altitude(2_000, Altitude.Reference.AMSL), 0);

        assertThat(doubts(at(47.01, -5), at(47.01, 800), amsl))
                .containsExactly("Item 2 is at -5 m, lower than home.", "Item 3 is 800 m above home.");
    }

    @Test
    void asksAboutNoDistanceWhileThePlaceOfTheDroneIsUnknown() {
        assertThat(MissionWarnings.about(new Mission(List.of(at(60, 20))), null))
                .isEmpty();
        assertThat(MissionWarnings.about(new Geodetic(60, 8), null)).isEmpty();
        assertThat(MissionWarnings.about(new Geodetic(47.2, 8), DRONE))
                .containsExactly("The place is 22.24 km away from the drone.");
    }
}
