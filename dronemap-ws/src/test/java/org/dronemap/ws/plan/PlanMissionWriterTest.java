package org.dronemap.ws.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.cognitive.plan.TimedPlace;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.plan.TourLeg;
import org.dronemap.cognitive.plan.TourStop;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Performance;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.mission.MissionItemRequest;
import org.junit.jupiter.api.Test;

/** Tours as missions: heights, holds, and what lies between. */
class PlanMissionWriterTest {
    private static final double HOME_METERS = 488;
    private static final Geodetic HOME = new Geodetic(47, 8);
    private static final Geodetic FAR = new Geodetic(47.01, 8);

    private static PlanMissionWriter missions(VehicleKind kind) {
        Craft craft = Craft.atHome(new DroneId("d1"), new Place(HOME, HOME_METERS), Performance.of(kind));
        return new PlanMissionWriter(craft, kind, waypoint -> Task.FLY_THROUGH);
    }

    private static TimedPlace fix(Geodetic point, double meters, double seconds) {
        return new TimedPlace(new Place(point, meters), seconds);
    }

    private static Tour tour(double top, double leaves, TimedPlace... toStop) {
        TourLeg way = new TourLeg(List.of(toStop), 1);
        TimedPlace stop = toStop[toStop.length - 1];
        TourLeg back = new TourLeg(
                List.of(
                        fix(stop.place().point(), top, leaves),
                        fix(HOME, top, leaves + 100),
                        fix(HOME, HOME_METERS, leaves + 200)),
                1);
        return new Tour(new DroneId("d1"), List.of(new TourStop("w", way, way.arrivesSeconds(), leaves, 1)), back, 2);
    }

    private static Tour plain(double top, double leaves) {
        return tour(top, leaves, fix(HOME, HOME_METERS, 0), fix(HOME, top, 10), fix(FAR, top, 100));
    }

    @Test
    void keepHeightsAboveTheSeaAndTakeOffAboveHome() {
        List<MissionItemRequest> items = missions(VehicleKind.MULTICOPTER).items(plain(518, 107));

        assertThat(items).hasSize(4);
        assertThat(items.get(0)).isEqualTo(new MissionItemRequest.TakeOff(30.0));
        assertThat(waypoint(items, 1).altitude()).isEqualTo(518);
        assertThat(waypoint(items, 1).altitudeReference()).isEqualTo("amsl");
        assertThat(waypoint(items, 1).holdSeconds()).isEqualTo(7);
        assertThat(waypoint(items, 2).latitude()).isEqualTo(47);
        assertThat(waypoint(items, 2).holdSeconds()).isZero();
        assertThat(items.get(3)).isEqualTo(new MissionItemRequest.Land(null, null, null, null));
    }

    private static MissionItemRequest.Waypoint waypoint(List<MissionItemRequest> items, int index) {
        return (MissionItemRequest.Waypoint) items.get(index);
    }

    @Test
    void visitAWaypointStraightAboveTheStart() {
        List<MissionItemRequest> items =
                missions(VehicleKind.MULTICOPTER).items(tour(518, 15, fix(HOME, HOME_METERS, 0), fix(HOME, 518, 10)));

        assertThat(waypoint(items, 1).latitude()).isEqualTo(47);
        assertThat(waypoint(items, 1).holdSeconds()).isEqualTo(5);
    }

    @Test
    void climbStraightUpAlsoWhereATakeOffCannotGoSoHigh() {
        List<MissionItemRequest> items = missions(VehicleKind.MULTICOPTER).items(plain(1_288, 100));

        assertThat(items.get(0)).isEqualTo(new MissionItemRequest.TakeOff(500.0));
        assertThat(waypoint(items, 1).altitude()).isEqualTo(1_288);
        assertThat(waypoint(items, 1).latitude()).isEqualTo(47);
    }

    @Test
    void leaveTheLandingOfAnAeroplaneToItself() {
        List<MissionItemRequest> items = missions(VehicleKind.FIXED_WING).items(plain(588, 100));

        assertThat(items.get(items.size() - 1)).isEqualTo(new MissionItemRequest.ReturnToLaunch());
    }

    /** A copter cuts the seconds of a waypoint to whole ones, and waits exactly by an item of its own. */
    @Test
    void waitAsLongAsPlannedWhereAWaypointCannotSayIt() {
        List<MissionItemRequest> items = missions(VehicleKind.MULTICOPTER).items(plain(518, 106.5));

        assertThat(waypoint(items, 1).holdSeconds()).isZero();
        assertThat(items.get(2)).isEqualTo(new MissionItemRequest.Wait(6.5));
    }

    @Test
    void makeNothingWaitThatFliesPastOrLandThatDrives() {
        assertThat(missions(VehicleKind.FIXED_WING).items(plain(588, 107)))
                .noneMatch(MissionItemRequest.Wait.class::isInstance)
                .allMatch(item -> !(item instanceof MissionItemRequest.Waypoint waypoint)
                        || Double.valueOf(0).equals(waypoint.holdSeconds()));
        assertThat(missions(VehicleKind.ROVER).items(plain(518, 107)))
                .noneMatch(MissionItemRequest.Land.class::isInstance)
                .last()
                .isInstanceOf(MissionItemRequest.Waypoint.class);
        assertThat(missions(VehicleKind.VTOL).items(plain(518, 107)))
                .last()
                .isEqualTo(new MissionItemRequest.Land(47.0, 8.0, HOME_METERS, "amsl"));
    }

    @Test
    void areFaultyWhereAMissionCannotHoldThem() {
        assertThat(missions(VehicleKind.MULTICOPTER).fault(plain(518, 3_700))).isEmpty();
        assertThat(missions(VehicleKind.MULTICOPTER).fault(plain(518, 3_701)))
                .hasValue("The drone d1 would wait for 3601 s at a waypoint, and a mission lets it wait for 3600 s.");
    }
}
