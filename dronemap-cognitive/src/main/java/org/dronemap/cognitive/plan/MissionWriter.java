package org.dronemap.cognitive.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.LandingPlace;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionAbilities;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.mission.WaypointTask;

/** Converts a planned tour to the mission that its drone carries: all heights above sea level, but the take-off's. */
public final class MissionWriter {
    private static final double HIGHEST_TAKE_OFF_METERS = 500;
    private static final double LONGEST_HOLD_SECONDS = 3_600;
    /** What sums of seconds are off by. */
    private final Craft craft;

    private final VehicleKind kind;
    private final MissionAbilities takes;

    private final Function<String, Task> tasks;

    /** {@code tasks}: what is done at the waypoint with that id. */
    public MissionWriter(Craft craft, VehicleKind kind, Function<String, Task> tasks) {
        this.craft = craft;
        this.tasks = tasks;
        this.kind = kind;
        this.takes = PlannedItems.of(kind);
    }

    /**
     * A tour as a mission, which may have more items than one can hold.
     *
     * @param arrivals for each stop of the tour the number of the item, from 0, that is behind the drone when it is done
     * @param tasks which items do what of the waypoints' tasks
     * @param left what of them its drone cannot do in a mission, and so is left out alone
     */
    public record WrittenMission(
            List<MissionItem> items, List<Integer> arrivals, List<TaskItem> tasks, List<LeftTask> left) {
        public WrittenMission {
            tasks = List.copyOf(tasks);
            items = List.copyOf(items);
            arrivals = List.copyOf(arrivals);
            left = List.copyOf(left);
        }
    }

    /** A task that is not done at a waypoint, and the reason as a sentence. */
    public record LeftTask(String waypoint, String reason) {}

    /** Why no drone can carry it, as a sentence. */
    public Optional<String> fault(Tour tour) {
        int items = write(tour).items().size();
        if (items > Mission.MAX_ITEMS) {
            return Optional.of("The tour of the drone " + craft.id() + " takes " + items
                    + " items, and a mission holds " + Mission.MAX_ITEMS + ".");
        }
        double longest = 0;
        for (int stop = 0; stop < tour.stops().size(); stop++) {
            longest = Math.max(longest, hold(tour, stop));
        }
        return longest > LONGEST_HOLD_SECONDS
                ? Optional.of("The drone " + craft.id() + " would wait for " + Math.round(longest)
                        + " s at a waypoint, and a mission lets it wait for 3600 s.")
                : Optional.empty();
    }

    public WrittenMission write(Tour tour) {
        List<MissionItem> items = new ArrayList<>();
        List<Integer> arrivals = new ArrayList<>();
        List<TaskItem> done = new ArrayList<>();
        List<LeftTask> left = new ArrayList<>();
        List<TourLeg> ways = tour.ways();
        for (int number = 0; number < ways.size(); number++) {
            boolean last = number == ways.size() - 1;
            List<TimedPlace> fixes = ways.get(number).fixes();
            int begin = number == 0 ? begin(items, fixes, last) : 1;
            int end = last && craft.lands() ? fixes.size() - 1 : fixes.size();
            for (int i = begin; i < end; i++) {
                boolean arrives = !last && i == fixes.size() - 1;
                boolean stays = arrives && parts(tour, number).isEmpty();
                stay(items, fixes.get(i).place(), stays ? hold(tour, number) : 0);
            }
            if (!last) {
                left.addAll(left(tour, number));
                arrivals.add(arrive(items, done, tour, number));
            }
        }
        if (craft.lands()) {
            List<TimedPlace> home = tour.last().fixes();
            landing(home.get(home.size() - 1).place()).ifPresent(items::add);
        }
        return new WrittenMission(items, arrivals, done, left);
    }

    /** At a waypoint, for a time that is exact where the vehicle can wait so. */
    private void stay(List<MissionItem> items, Place place, double seconds) {
        boolean waits = !takes.supportsHold(seconds);
        items.add(waypoint(place, waits ? 0 : seconds));
        if (waits && takes.supports(MissionItem.Kind.WAIT)) {
            items.add(new MissionItem.Wait(seconds));
        }
    }

    /** Nothing for what drives: it is there already. */
    private Optional<MissionItem> landing(Place ground) {
        if (kind == VehicleKind.FIXED_WING) {
            return Optional.of(new MissionItem.ReturnToLaunch());
        }
        if (!takes.supports(MissionItem.Kind.LAND)) {
            return Optional.empty();
        }
        return Optional.of(
                takes.landing() == MissionAbilities.Landing.AT_PLACE
                        ? new MissionItem.Land(new LandingPlace(
                                ground.point(), new Altitude(ground.altitudeAmslMeters(), Altitude.Reference.AMSL)))
                        : new MissionItem.Land());
    }

    /** Of the task there what takes a vehicle that waits, where it does not; a photo is taken on the way past. */
    private List<LeftTask> left(Tour tour, int stop) {
        if (takes.supports(MissionItem.Kind.WAIT)) {
            return List.of();
        }
        String waypoint = tour.stops().get(stop).waypoint();
        boolean stays = !tasks.apply(waypoint).parts().isEmpty()
                ? parts(tour, stop).stream().anyMatch(WaypointTask.Sensors.class::isInstance)
                : hold(tour, stop) >= 1;
        return stays
                ? List.of(new LeftTask(
                        waypoint,
                        "The drone " + craft.id() + " does not wait at the waypoint " + waypoint
                                + ": a vehicle of its kind flies past."))
                : List.of();
    }

    private List<WaypointTask> parts(Tour tour, int stop) {
        return tasks.apply(tour.stops().get(stop).waypoint()).parts();
    }

    /**
     * What is done there, and the number of the item after which all is: a vehicle sets off as soon as it was told, so that
     * it is made to wait after each; one that cannot stand does it while it flies by.
     */
    private int arrive(List<MissionItem> items, List<TaskItem> done, Tour tour, int stop) {
        List<WaypointTask> parts = parts(tour, stop);
        double rest = hold(tour, stop);
        boolean looks = false;
        for (int part = 0; part < parts.size(); part++) {
            WaypointTask task = parts.get(part);
            looks |= task instanceof WaypointTask.Look;
            Optional<MissionItem> order = order(task);
            order.ifPresent(items::add);
            boolean last = part == parts.size() - 1;
            double seconds = last ? Math.max(rest, task.seconds()) : task.seconds();
            rest -= seconds;
            int item = order.isPresent() ? items.size() - 1 : items.size();
            boolean waits = takes.supports(MissionItem.Kind.WAIT);
            if (waits) {
                items.add(new MissionItem.Wait(seconds));
            }
            if (waits || order.isPresent()) {
                done.add(new TaskItem(item, tour.stops().get(stop).waypoint(), part));
            }
        }
        int arrival = items.size() - 1;
        if (looks) {
            items.add(new MissionItem.LookAhead());
        }
        return arrival;
    }

    private static Optional<MissionItem> order(WaypointTask task) {
        if (task instanceof WaypointTask.Photo) {
            return Optional.of(new MissionItem.TakePhoto());
        }
        if (task instanceof WaypointTask.Servo servo) {
            return Optional.of(new MissionItem.SetServo(servo.output(), servo.pulseMicros()));
        }
        return task instanceof WaypointTask.Look look
                ? Optional.of(new MissionItem.LookAt(
                        look.point(), new Altitude(look.altitudeAmslMeters(), Altitude.Reference.AMSL)))
                : Optional.empty();
    }

    /** With which fix it goes on after a take-off. */
    private int begin(List<MissionItem> items, List<TimedPlace> fixes, boolean last) {
        if (!craft.beginsWithTakeOff()) {
            return 1;
        }
        takeOff(items, fixes.get(1).place());
        return last ? 2 : Math.min(2, fixes.size() - 1);
    }

    /** Until its next way begins: its task, and what waiting keeps drones apart. */
    private static double hold(Tour tour, int stop) {
        return Math.max(
                0, tour.way(stop + 1).departsSeconds() - tour.stops().get(stop).arrivesSeconds());
    }

    private void takeOff(List<MissionItem> items, Place top) {
        double height = top.altitudeAmslMeters() - craft.homeAmslMeters();
        double climbed = Math.max(1, Math.min(HIGHEST_TAKE_OFF_METERS, height));
        items.add(new MissionItem.TakeOff(climbed));
        if (climbed != height) {
            // Straight up all the same.
            items.add(waypoint(top, 0));
        }
    }

    private static MissionItem waypoint(Place place, double holdSeconds) {
        return new MissionItem.Waypoint(
                place.point(), new Altitude(place.altitudeAmslMeters(), Altitude.Reference.AMSL), holdSeconds);
    }
}
