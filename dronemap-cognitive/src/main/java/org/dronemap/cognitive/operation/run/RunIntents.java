package org.dronemap.cognitive.operation.run;

import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.plan.BarrierCheck;
import org.dronemap.cognitive.plan.TimedPlace;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Speeds;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.separation.FlightIntent;
import org.dronemap.core.separation.FlightPace;
import org.dronemap.core.separation.TrackedDrone;

/** Says what a mission run means its drones to do next, for those who keep all drones apart. */
final class RunIntents {
    private RunIntents() {}

    static Map<DroneId, FlightIntent> of(RunState state, Instant now) {
        FlightIntent.Bounds bounds =
                (drone, there) -> isWithin(state.setting().barriers(), state.drone(drone.id()), drone, there);
        Map<DroneId, FlightIntent> intents = new HashMap<>();
        for (RunDrone drone : state.drones()) {
            step(state, drone, now).ifPresent(step -> intents.put(drone.id(), intent(state, drone, step, bounds)));
        }
        return intents;
    }

    private static Optional<FlightIntent.Step> step(RunState state, RunDrone drone, Instant now) {
        Sortie sortie = drone.sortie();
        return switch (drone.stage()) {
            case READY ->
                sortie != null && LaunchTiming.isDue(state.clock(), sortie, now)
                        ? Optional.of(FlightIntent.Step.RISE)
                        : Optional.empty();
            case ARMING, STARTING -> Optional.of(FlightIntent.Step.RISE);
            case FLYING, SILENT -> Optional.of(FlightIntent.Step.FLY);
            case HOLDING, REPLACING, RESUMING -> Optional.of(FlightIntent.Step.STAND);
            case CONTINUING -> Optional.of(FlightIntent.Step.GO_ON);
            case RETURNING -> Optional.of(FlightIntent.Step.COME_HOME);
            case CRASHED -> Optional.of(FlightIntent.Step.LIE);
            default -> Optional.empty();
        };
    }

    private static FlightIntent intent(
            RunState state, RunDrone drone, FlightIntent.Step step, FlightIntent.Bounds bounds) {
        Speeds speeds = drone.craft().performance().speeds();
        RunDrone.IssuedCommand command = drone.issuedCommand();
        return new FlightIntent(
                step,
                ahead(drone),
                new FlightPace(speeds.cruise(), speeds.climb(), speeds.descent(), speeds.acceleration()),
                command != null,
                command == null ? since(drone) : command.at(),
                bounds,
                state.setting().onCloudLoss() == MissionCloudLossPolicy.CONTINUE);
    }

    /** One that waits on the ground for the time of its plan means to rise from then on. */
    private static Instant since(RunDrone drone) {
        Sortie sortie = drone.sortie();
        return drone.stage() == RunDroneStage.READY && sortie != null
                ? sortie.moment(sortie.tour().departsSeconds())
                : drone.since();
    }

    private static List<MissionItem> ahead(RunDrone drone) {
        Sortie sortie = drone.sortie();
        if (sortie == null) {
            return List.of();
        }
        List<MissionItem> items = sortie.mission().items();
        return items.subList(Math.min(drone.passed(), items.size()), items.size());
    }

    /** Areas that bind this run alone are no zones of the cloud. */
    private static boolean isWithin(
            List<Barrier> barriers, Optional<RunDrone> known, TrackedDrone drone, Command.GoTo there) {
        Geodetic point = drone.point();
        Optional<Double> meters = drone.amslMeters();
        if (known.isEmpty() || point == null || meters.isEmpty()) {
            return false;
        }
        TimedPlace from = new TimedPlace(new Place(point, meters.get()), 0);
        TimedPlace to = new TimedPlace(new Place(there.point(), there.altitude().meters()), 1);
        return new BarrierCheck(barriers, known.get().craft())
                .fault(from, to, false)
                .isEmpty();
    }
}
