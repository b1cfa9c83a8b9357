package org.dronemap.core.virtual;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.junit.jupiter.api.Test;

class MissionSharesTest {
    private static final double DEGREE_METERS = 111_195;
    private static final Geodetic HOME = place(0, 0);

    private static Geodetic place(double north, double east) {
        double latitude = 47.4 + north / DEGREE_METERS;
        return new Geodetic(latitude, 8.5 + east / DEGREE_METERS / Math.cos(Math.toRadians(47.4)));
    }

    private static MissionItem waypoint(double north, double east, double hold) {
        return new MissionItem.Waypoint(place(north, east), Altitude.aboveHome(20), hold);
    }

    /** So many on a circle round home, one after the other. */
    private static Mission circle(int waypoints, double radius) {
        List<MissionItem> items = new ArrayList<>();
        for (int i = 0; i < waypoints; i++) {
            double angle = 2 * Math.PI * i / waypoints;
            items.add(waypoint(radius * Math.cos(angle), radius * Math.sin(angle), 0));
        }
        return new Mission(items);
    }

    private static List<MissionItem.Waypoint> waypoints(List<Mission> shares) {
        return shares.stream()
                .flatMap(share -> VirtualTour.of(share).waypoints().stream())
                .toList();
    }

    private static double flight(Mission share) {
        double meters = 0;
        Geodetic at = HOME;
        for (MissionItem.Waypoint waypoint : VirtualTour.of(share).waypoints()) {
            meters += Geodesy.distanceMeters(at, waypoint.point());
            at = waypoint.point();
        }
        return VirtualTour.of(share).landsThere() ? meters : meters + Geodesy.distanceMeters(at, HOME);
    }

    private static double longest(List<Mission> shares) {
        return shares.stream().mapToDouble(MissionSharesTest::flight).max().orElseThrow();
    }

    @Test
    void sharesAreAboutEquallyLongAndKeepTheOrder() {
        Mission mission = circle(12, 100);
        List<Mission> shares = MissionShares.of(mission, HOME, 3);
        assertThat(shares).hasSize(3).allMatch(share -> VirtualTour.fault(share).isEmpty());
        assertThat(shares)
                .extracting(share -> VirtualTour.of(share).waypoints().size())
                .containsExactly(4, 4, 4);
        assertThat(waypoints(shares)).isEqualTo(VirtualTour.of(mission).waypoints());
    }

    @Test
    void nobodyFliesMoreThanTheBestDivisionAsksFor() {
        Random random = new Random(4);
        for (int trial = 0; trial < 200; trial++) {
            List<MissionItem> items = new ArrayList<>();
            for (int i = 0; i < 2 + random.nextInt(8); i++) {
                items.add(waypoint(random.nextInt(400), random.nextInt(400), 0));
            }
            Mission mission = new Mission(items);
            int most = 1 + random.nextInt(4);
            List<Mission> shares = MissionShares.of(mission, HOME, most);
            assertThat(shares).hasSizeLessThanOrEqualTo(most);
            assertThat(waypoints(shares)).isEqualTo(items);
            assertThat(longest(shares)).isLessThanOrEqualTo(1.051 * best(items, most));
        }
    }

    /** By trying all. */
    private static double best(List<MissionItem> items, int most) {
        if (items.isEmpty()) {
            return 0;
        }
        double best = most == 1 ? flight(new Mission(items)) : Double.POSITIVE_INFINITY;
        for (int first = 1; most > 1 && first <= items.size(); first++) {
            double rest = best(items.subList(first, items.size()), most - 1);
            best = Math.min(best, Math.max(flight(new Mission(items.subList(0, first))), rest));
        }
        return best;
    }

    @Test
    void dronesThatWouldNotShortenTheLongestFlightStayDown() {
        List<MissionItem> farAndTogether =
                List.of(waypoint(1_000, 0, 0), waypoint(1_000, 10, 0), waypoint(1_000, 20, 0), waypoint(1_000, 30, 0));
        Mission mission = new Mission(farAndTogether);
        assertThat(MissionShares.of(mission, HOME, 4)).containsExactly(mission);
    }

    @Test
    void waitingCountsAsWay() {
        List<MissionItem> items = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            items.add(waypoint(100, 40 * i, i == 0 ? 120 : 0));
        }
        List<Mission> shares = MissionShares.of(new Mission(items), HOME, 2);
        assertThat(VirtualTour.of(shares.get(0)).waypoints()).containsExactly((MissionItem.Waypoint) items.get(0));
    }

    /** Where nobody has looked for a place to land, nobody lands. */
    @Test
    void allTakeOffAlikeButOnlyTheLastLandsWhereTheMissionDoes() {
        List<MissionItem> items = new ArrayList<>(List.of(new MissionItem.TakeOff(35)));
        items.addAll(circle(6, 100).items());
        items.add(new MissionItem.Land());
        List<Mission> shares = MissionShares.of(new Mission(items), HOME, 2);
        assertThat(shares)
                .hasSize(2)
                .allSatisfy(share -> assertThat(share.items().get(0)).isEqualTo(new MissionItem.TakeOff(35)));
        assertThat(shares)
                .extracting(share -> VirtualTour.of(share).landsThere())
                .containsExactly(false, true);
    }

    @Test
    void oneDroneFliesTheMissionAsItIs() {
        Mission mission = circle(5, 50);
        assertThat(MissionShares.of(mission, HOME, 1)).containsExactly(mission);
    }
}
