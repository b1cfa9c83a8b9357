package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.operation.run.model.RunWaypoint.Report;
import org.dronemap.cognitive.operation.run.model.RunWaypoint.Report.Result;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.plan.TaskItem;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.drone.PayloadState;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.WaypointTask;
import org.jspecify.annotations.Nullable;

/** Tracks by what drones report which waypoint tasks of a mission run are done, so that none is done twice. */
final class TaskReports {
    /** What a drone says later is not said of this task. */
    private static final Duration LATEST = Duration.ofSeconds(10);
    /** A photo's own message may come before the word that its item is passed. */
    private static final Duration EARLIEST = Duration.ofSeconds(5);
    /** Once it is held, till it has said how far it came. */
    private static final Duration UNTIL_TOLD = Duration.ofMillis(1_500);

    private static final double NEAR_METERS = 15;
    private static final int SAME_PULSE_MICROS = 15;

    private TaskReports() {}

    /** What its mission's items say, by how many are behind it. */
    static void update(RunTransition draft, RunDrone drone, DroneObservation look) {
        Sortie sortie = drone.sortie();
        if (sortie == null) {
            return;
        }
        for (TaskItem task : sortie.tasks()) {
            RunWaypoint target = draft.target(task.waypoint());
            boolean reserved =
                    target.visits().stream().anyMatch(visit -> !visit.drone().equals(drone.id()))
                            || target.state() == RunWaypoint.State.CANCELLED;
            if (!reserved) {
                ObservedTask seen = new ObservedTask(draft, drone, task, look.payload());
                seen.report(target)
                        .filter(report -> !Optional.of(report).equals(target.report(task.part())))
                        .ifPresent(report -> draft.put(target.with(report)));
            }
        }
    }

    /** One task of one drone, as far as it is seen now. */
    private record ObservedTask(RunTransition draft, RunDrone drone, TaskItem task, PayloadState payload) {
        Optional<Report> report(RunWaypoint target) {
            Report before = target.report(task.part()).orElse(null);
            boolean others = before != null && !before.drone().equals(drone.id());
            boolean settled = before != null && isSettled(before);
            if (others || settled) {
                return Optional.empty();
            }
            WaypointTask part = target.waypoint().task().parts().get(task.part());
            if (part instanceof WaypointTask.Photo) {
                return photo(target, before);
            }
            if (part instanceof WaypointTask.Sensors) {
                return sensors(before);
            }
            if (drone.passed() <= task.item()) {
                return Optional.empty();
            }
            return Optional.of(
                    part instanceof WaypointTask.Servo servo
                            ? servo(servo, before)
                            : result(Result.DONE, before, "It says that it turned there."));
        }

        private boolean isSettled(Report before) {
            boolean late = Duration.between(before.at(), draft.now()).compareTo(LATEST) > 0;
            return before.result() == Result.DONE || (late && before.result() != Result.UNDER_WAY);
        }

        private Optional<Report> photo(RunWaypoint target, @Nullable Report before) {
            PayloadState.Photo photo = payload.photo();
            if (photo != null && isOf(target, photo, before)) {
                Geodetic point = photo.point();
                String where = point == null
                        ? ""
                        : String.format(
                                Locale.ROOT, " at %.6f, %.6f", point.latitudeDegrees(), point.longitudeDegrees());
                return Optional.of(new Report(
                        task.part(),
                        drone.id(),
                        Result.DONE,
                        photo.receivedAt(),
                        photo.number(),
                        "Photo " + photo.number() + where + "."));
            }
            return drone.passed() <= task.item()
                    ? Optional.empty()
                    : Optional.of(result(Result.NOT_KNOWN, before, "It was told to, and told of no photo."));
        }

        private boolean isOf(RunWaypoint target, PayloadState.Photo photo, @Nullable Report before) {
            Instant since = before == null ? draft.now() : before.at();
            Geodetic point = photo.point();
            Place place = target.waypoint().place();
            boolean there = point == null
                    ? drone.passed() > task.item()
                    : Geodesy.distanceMeters(point, place.point()) < NEAR_METERS;
            boolean heads = drone.passed() > task.item()
                    || drone.orders().stream().findFirst().equals(Optional.of(target.id()));
            return there && heads && photo.receivedAt().isAfter(since.minus(EARLIEST)) && !isOfAnotherTask(photo);
        }

        /** It came of another task. */
        private boolean isOfAnotherTask(PayloadState.Photo photo) {
            return draft.targets().stream()
                    .flatMap(any -> any.reports().stream())
                    .anyMatch(report ->
                            report.drone().equals(drone.id()) && Objects.equals(report.photo(), photo.number()));
        }

        private Report servo(WaypointTask.Servo servo, @Nullable Report before) {
            List<Integer> outputs = payload.outputs();
            int pulse = servo.output() <= outputs.size() ? outputs.get(servo.output() - 1) : 0;
            if (pulse == 0) {
                return result(Result.NOT_KNOWN, before, "It was told to, and tells nothing of that output.");
            }
            boolean there = Math.abs(pulse - servo.pulseMicros()) <= SAME_PULSE_MICROS;
            return result(
                    there ? Result.DONE : Result.NOT_KNOWN,
                    before,
                    "Output " + servo.output() + (there ? " is at " : " was told to move, and is at ") + pulse
                            + " µs.");
        }

        private Optional<Report> sensors(@Nullable Report before) {
            if (drone.passed() < task.item()) {
                return Optional.empty();
            }
            if (drone.passed() == task.item()) {
                return Optional.of(result(Result.UNDER_WAY, before, "It stays for it."));
            }
            if (before == null || before.result() != Result.UNDER_WAY) {
                return before == null
                        ? Optional.of(result(Result.NOT_KNOWN, null, "It was there while it was not heard."))
                        : Optional.empty();
            }
            String readings = payload.readings().stream()
                    .filter(reading -> !reading.receivedAt().isBefore(before.at()))
                    .map(reading -> reading.name() + " " + number(reading.value()))
                    .collect(Collectors.joining(", "));
            return Optional.of(
                    readings.isEmpty()
                            ? new Report(
                                    task.part(),
                                    drone.id(),
                                    Result.NOT_AVAILABLE,
                                    draft.now(),
                                    null,
                                    "No reading was heard from it there.")
                            : new Report(task.part(), drone.id(), Result.DONE, draft.now(), null, readings + "."));
        }

        private static String number(double value) {
            return String.format(Locale.ROOT, "%.3f", value).replaceAll("\\.?0+$", "");
        }

        private Report result(Result result, @Nullable Report before, String words) {
            return new Report(task.part(), drone.id(), result, before == null ? draft.now() : before.at(), null, words);
        }
    }

    /** Whether it is to be left out: it may have been done, and is not to be done twice. */
    static boolean isSkipped(RunTransition draft, TaskItem task) {
        RunWaypoint target = draft.target(task.waypoint());
        return target.waypoint().task().parts().get(task.part()).isOnce()
                && target.report(task.part()).isPresent();
    }

    static Sortie withoutDone(RunTransition draft, Sortie sortie) {
        return sortie.sparing(task -> isSkipped(draft, task));
    }

    /** True when what it is to get had to be changed for what was done meanwhile. */
    static boolean skipDone(RunTransition draft, RunDrone drone, Sortie next) {
        Sortie left = withoutDone(draft, next);
        if (left.equals(next)) {
            return false;
        }
        draft.put(drone.withNext(left));
        return true;
    }

    /** Whether it may just have begun a task that it has not spoken of. */
    static boolean mayReportYet(RunTransition draft, RunDrone drone, DroneObservation look) {
        Sortie sortie = drone.sortie();
        Place here = look.place();
        boolean longAgo = Duration.between(drone.since(), draft.now()).compareTo(UNTIL_TOLD) >= 0;
        return !longAgo
                && sortie != null
                && here != null
                && sortie.tasks().stream()
                        .filter(task -> !isSkipped(draft, task))
                        .map(task -> draft.target(task.waypoint()).waypoint().place())
                        .anyMatch(place -> Geodesy.distanceMeters(place.point(), here.point()) < NEAR_METERS);
    }
}
