package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.operation.run.model.RunWaypoint.Report;
import org.dronemap.cognitive.operation.run.model.RunWaypoint.Report.Result;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.WaypointTask;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What is done at waypoints, what is told of it, and that nothing is done twice. */
class TaskReportsTest {
    private static final WaypointTask PHOTO = new WaypointTask.Photo();
    private static final WaypointTask SERVO = new WaypointTask.Servo(9, 1_900);
    private static final WaypointTask LOOK = new WaypointTask.Look(new Geodetic(47, 8), 400);
    private static final WaypointTask SENSORS = new WaypointTask.Sensors(5);

    private static RunTestBench fleet(int drones, int waypoints, long seed, WaypointTask... parts) {
        PlanningProblem plain = RunFixtures.problem(drones, waypoints, seed, false);
        List<Waypoint> places = plain.waypoints().stream()
                .map(waypoint -> doing(waypoint, parts))
                .toList();
        return RunFixtures.fleet(
                PlanningProblem.of(places, plain.crafts()),
                seed,
                RunOrder.ApprovalMode.AUTOMATIC,
                MissionCloudLossPolicy.RETURN_TO_LAUNCH);
    }

    private static Waypoint doing(Waypoint waypoint, WaypointTask... parts) {
        double seconds =
                List.of(parts).stream().mapToDouble(WaypointTask::seconds).sum();
        Task task = new Task(seconds, Set.of(), List.of(parts));
        return new Waypoint(waypoint.id(), waypoint.place(), task, waypoint.priority(), waypoint.window());
    }

    private static List<Report> reports(RunTestBench fleet) {
        return fleet.state.targets().stream()
                .flatMap(target -> target.reports().stream())
                .toList();
    }

    private static long photosAt(RunTestBench fleet, RunWaypoint target) {
        Geodetic place = target.waypoint().place().point();
        return fleet.vehicles.values().stream()
                .flatMap(vehicle -> vehicle.photos.stream())
                .filter(photo -> Geodesy.distanceMeters(photo, place) < 3)
                .count();
    }

    private static int photos(RunTestBench fleet) {
        return fleet.vehicles.values().stream()
                .mapToInt(vehicle -> vehicle.photos.size())
                .sum();
    }

    @Test
    void doesAllTasksAndTiesWhatCameOfThemToTheirWaypoints() {
        RunTestBench fleet = fleet(2, 6, 1, LOOK, PHOTO, SERVO, SENSORS);
        fleet.vehicles.values().forEach(vehicle -> vehicle.reading = 21.5);

        fleet.flyToTheEnd();

        assertThat(fleet.state.targets()).allSatisfy(target -> {
            assertThat(target.reports()).extracting(Report::part).containsExactly(0, 1, 2, 3);
            assertThat(target.reports()).allMatch(report -> report.result() == Result.DONE);
            assertThat(target.reports())
                    .allMatch(report ->
                            report.drone().equals(target.visits().get(0).drone()));
            assertThat(target.reports().get(1).words())
                    .startsWith("Photo " + target.reports().get(1).photo() + " at ");
            assertThat(target.reports().get(2).words()).isEqualTo("Output 9 is at 1900 µs.");
            assertThat(target.reports().get(3).words()).isEqualTo("temp 21.5.");
            assertThat(photosAt(fleet, target)).isOne();
        });
        assertThat(photos(fleet)).isEqualTo(6);
        assertThat(fleet.closest).isGreaterThan(9.9);
    }

    @Test
    void tellsTwoPhotosOfOneWaypointApart() {
        RunTestBench fleet = fleet(1, 2, 1, PHOTO, PHOTO);

        fleet.flyToTheEnd();

        assertThat(reports(fleet)).extracting(Report::photo).containsExactlyInAnyOrder(1, 2, 3, 4);
    }

    @Test
    void saysWhatIsNotKnownAndWhatThereIsNot() {
        RunTestBench fleet = fleet(1, 2, 1, PHOTO, SENSORS);
        fleet.vehicle(0).tellsPhotos = false;

        fleet.flyToTheEnd();

        assertThat(reports(fleet))
                .extracting(Report::result)
                .containsExactly(Result.NOT_KNOWN, Result.NOT_AVAILABLE, Result.NOT_KNOWN, Result.NOT_AVAILABLE);
        assertThat(photos(fleet)).isEqualTo(2);
    }

    /** New waypoints come while photos are taken, so that drones get other missions over them again and again. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void takesNoPhotoTwiceHoweverOftenPlansChange(long seed) {
        RunTestBench fleet = fleet(2, 8, seed, PHOTO, SERVO);
        fleet.vehicles.values().forEach(vehicle -> vehicle.tellsPhotos = seed % 2 == 0);
        List<String> added = new ArrayList<>();
        fleet.flyUntil(() -> fleet.vehicle(0).armed, 60);
        for (int i = 0; i < 8; i++) {
            int before = photos(fleet);
            fleet.flyUntil(() -> photos(fleet) > before || fleet.state.count(RunWaypoint.State.ASSIGNED) == 0, 900);
            fleet.fly(0.25 * (i % 4));
            if (fleet.state.isOver() || fleet.state.stopping()) {
                break;
            }
            TestVehicle near = fleet.vehicle(i % 2);
            String id = "n" + i;
            Waypoint waypoint = Waypoint.at(id, PlanningFixtures.place(near.east + 30 + i, near.north + 20, 440));
            fleet.wish(new RunInput.AddWaypoints(fleet.now, "olga", List.of(doing(waypoint, PHOTO))));
            added.add(id);
        }

        fleet.flyToTheEnd();

        assertThat(added).isNotEmpty();
        assertThat(fleet.state.counts().replans()).isGreaterThan(2);
        assertThat(fleet.state.targets()).allSatisfy(target -> {
            assertThat(target.state()).isEqualTo(RunWaypoint.State.VISITED);
            assertThat(photosAt(fleet, target)).as(target.id()).isOne();
            assertThat(target.report(0)).isPresent();
        });
        int parts = fleet.state.targets().stream()
                .mapToInt(target -> target.waypoint().task().parts().size())
                .sum();
        assertThat(reports(fleet)).hasSize(parts);
        assertThat(fleet.vehicles.values().stream()
                        .mapToInt(vehicle -> vehicle.moved.size())
                        .sum())
                .isEqualTo(8);
    }

    @Test
    void doesNotTakeThePhotoOfADroneAgainThatFailedAfterIt() {
        RunTestBench fleet = fleet(2, 8, 3, PHOTO, SENSORS);
        fleet.flyUntil(() -> !fleet.vehicle(0).photos.isEmpty(), 600);
        fleet.fly(1);
        RunWaypoint at = fleet.state.targets().stream()
                .filter(target -> photosAt(fleet, target) == 1
                        && target.id().equals(fleet.drone(0).orders().get(0)))
                .findFirst()
                .orElseThrow();
        assertThat(at.report(0)).map(Report::result).contains(Result.DONE);

        fleet.vehicle(0).falling = true;
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(8);
        assertThat(fleet.state.targets())
                .allSatisfy(target ->
                        assertThat(photosAt(fleet, target)).as(target.id()).isOne());
        RunWaypoint then = fleet.state.target(at.id()).orElseThrow();
        assertThat(Objects.requireNonNull(then.visits().get(0)).drone().value()).isEqualTo("d1");
        assertThat(then.report(1).orElseThrow().drone().value())
                .as("what was not done by then is the other's")
                .isEqualTo("d1");
    }
}
