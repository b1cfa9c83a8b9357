package org.dronemap.cognitive.operation.run.model;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import org.dronemap.cognitive.plan.MissionWriter;
import org.dronemap.cognitive.plan.TaskItem;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.plan.TourStop;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.stored.Stored;

/**
 * One drone's mission in a mission run, with the tour that it flies and which of its items do which tasks.
 *
 * @param number of all of the run
 * @param tour on a clock whose zero is {@code zero}
 * @param arrivals for each stop of the tour the number of the mission's item that is behind the drone when it is done
 * @param tasks which items do what of the waypoints' tasks
 */
@Stored(names = "number tour mission arrivals tasks zero")
public record Sortie(
        int number, Tour tour, Mission mission, List<Integer> arrivals, List<TaskItem> tasks, Instant zero) {
    private static final double NANOS = 1e9;

    public Sortie {
        arrivals = List.copyOf(arrivals);
        tasks = List.copyOf(tasks);
    }

    /** {@code kin}: with the craft as it stands in the problem that the tour was made for. */
    public static Sortie of(int number, RunDrone.Profile kin, Tour tour, Instant zero, Function<String, Task> tasks) {
        MissionWriter.WrittenMission written = new MissionWriter(kin.craft(), kin.kind(), tasks).write(tour);
        return new Sortie(number, tour, new Mission(written.items()), written.arrivals(), written.tasks(), zero);
    }

    /** The same without those items; how long it stays is left as it is. */
    public Sortie sparing(Predicate<TaskItem> done) {
        List<TaskItem> spared = tasks.stream().filter(done).toList();
        if (spared.isEmpty()) {
            return this;
        }
        List<Integer> numbers = spared.stream().map(TaskItem::item).toList();
        List<MissionItem> items = new ArrayList<>(mission.items());
        numbers.stream().sorted(Comparator.reverseOrder()).forEach(number -> items.remove(number.intValue()));
        UnaryOperator<Integer> moved = item ->
                item - (int) numbers.stream().filter(number -> number < item).count();
        return new Sortie(
                number,
                tour,
                new Mission(items),
                arrivals.stream().map(moved).toList(),
                tasks.stream()
                        .filter(task -> !spared.contains(task))
                        .map(task -> new TaskItem(moved.apply(task.item()), task.waypoint(), task.part()))
                        .toList(),
                zero);
    }

    /** Which waypoints are done when so many items are behind the drone. */
    public List<String> done(int passed) {
        int stops = (int) arrivals.stream().filter(item -> item < passed).count();
        return tour.stops().subList(0, stops).stream().map(TourStop::waypoint).toList();
    }

    /** Which are not. */
    public List<String> ahead(int passed) {
        return tour.stops().stream()
                .skip(done(passed).size())
                .map(TourStop::waypoint)
                .toList();
    }

    public boolean leadsTo(String waypoint, int passed) {
        return ahead(passed).contains(waypoint);
    }

    /** The same mission, where passing that waypoint's place counts for nothing any more. */
    public Sortie without(String waypoint) {
        List<TourStop> stops = new ArrayList<>();
        List<Integer> items = new ArrayList<>();
        for (int stop = 0; stop < arrivals.size(); stop++) {
            if (!tour.stops().get(stop).waypoint().equals(waypoint)) {
                stops.add(tour.stops().get(stop));
                items.add(arrivals.get(stop));
            }
        }
        return new Sortie(
                number,
                new Tour(tour.drone(), stops, tour.last(), tour.usedJoules()),
                mission,
                items,
                tasks.stream().filter(task -> !task.waypoint().equals(waypoint)).toList(),
                zero);
    }

    /** The same mission with what is ahead at newer times: {@code later} has just those stops. */
    public Sortie retimed(Tour later, Instant newZero, int passed) {
        int done = done(passed).size();
        return new Sortie(number, later, mission, arrivals.subList(done, arrivals.size()), tasks, newZero);
    }

    public Sortie at(Instant newZero) {
        return new Sortie(number, tour, mission, arrivals, tasks, newZero);
    }

    /** As it was planned, or as much later as it departs. */
    public Sortie departingAt(Instant moment) {
        Duration late = Duration.between(moment(tour.departsSeconds()), moment);
        return late.isNegative() ? this : at(zero.plus(late));
    }

    /** The waypoint that an item belongs to; empty: it is of the take-off or the way home. */
    public Optional<String> waypointOf(int item) {
        MissionItem.Kind kind = mission.items().get(item).kind();
        boolean after = kind == MissionItem.Kind.LOOK_AHEAD;
        boolean own = kind == MissionItem.Kind.TAKE_OFF
                || kind == MissionItem.Kind.LAND
                || kind == MissionItem.Kind.RETURN_TO_LAUNCH;
        for (int stop = 0; stop < arrivals.size() && !own; stop++) {
            if (arrivals.get(stop) >= (after ? item - 1 : item)) {
                return Optional.of(tour.stops().get(stop).waypoint());
            }
        }
        return Optional.empty();
    }

    /** When it is to be there; empty: it is none of its stops. */
    public Optional<Instant> due(String waypoint) {
        return tour.stops().stream()
                .filter(stop -> stop.waypoint().equals(waypoint))
                .findFirst()
                .map(stop -> moment(stop.arrivesSeconds()));
    }

    public Instant moment(double seconds) {
        return zero.plusNanos((long) (seconds * NANOS));
    }
}
