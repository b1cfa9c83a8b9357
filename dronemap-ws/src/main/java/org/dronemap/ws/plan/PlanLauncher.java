package org.dronemap.ws.plan;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.core.access.Principal;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.conduct.TakeOffClearance;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.access.Caller;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.command.CommandService;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.problem.OperationProblem;
import org.dronemap.ws.problem.OutageClassifier;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Uploads the missions of an accepted plan to its drones, and starts them if asked for when all are uploaded. Every
 * command goes through the gate, as the user who accepted.
 */
final class PlanLauncher {
    private static final Logger LOG = LoggerFactory.getLogger(PlanLauncher.class);
    /** The gate gives up before; a mission that goes up over a bad link may take longer than that in all. */
    private static final Duration LONGEST_SILENCE = Duration.ofMinutes(3);

    private static final double MILLIS = 1_000;
    private static final CompletableFuture<Boolean> NO = CompletableFuture.completedFuture(false);

    private final PlanJobExecutor desk;
    private final CommandService commands;
    private final TakeOffClearance clearance;
    private final PlanJob job;
    private final Principal principal;
    private final String face;
    private final Start start;

    /** Start options of a plan: whether drones are started, and their action when they lose contact with the cloud. */
    record Start(boolean wanted, @Nullable String onCloudLoss) {}

    /** {@code caller}: who accepted the plan. */
    PlanLauncher(
            PlanJobExecutor desk,
            CommandService commands,
            TakeOffClearance clearance,
            PlanJob job,
            Caller caller,
            Start start) {
        this.desk = desk;
        this.commands = commands;
        this.clearance = clearance;
        this.job = job;
        this.principal = caller.principal();
        this.face = caller.face();
        this.start = start;
    }

    /** Ends when nothing is under way any more; never fails. */
    CompletableFuture<Void> run(List<Tour> tours) {
        List<CompletableFuture<Boolean>> uploads =
                tours.stream().map(this::upload).toList();
        return all(uploads)
                .thenComposeAsync(
                        done -> start.wanted()
                                ? startAll(tours, uploads.stream().allMatch(CompletableFuture::join))
                                : CompletableFuture.completedFuture(null),
                        desk.launches())
                .exceptionally(this::broken)
                .thenRun(() -> {
                    job.launched(desk.nowNanos());
                    desk.notifyChanged(job);
                });
    }

    private @Nullable Void broken(Throwable thrown) {
        LOG.error("The plan {} could not be carried out", job.id(), thrown);
        job.status().flights().stream()
                .filter(flight -> !flight.stage().isEnd())
                .forEach(flight -> settle(
                        flight.drone(),
                        DroneLaunchStatus.Stage.FAILED,
                        DroneLaunchStatus.Reason.of(
                                ServerProblem.SERVER_FAILED,
                                "The server failed; those who run it find out why in its log.")));
        return null;
    }

    private static CompletableFuture<Void> all(List<CompletableFuture<Boolean>> each) {
        return CompletableFuture.allOf(each.toArray(CompletableFuture[]::new));
    }

    private CompletableFuture<Boolean> upload(Tour tour) {
        List<MissionItemRequest> items = job.order()
                .missions(tour.drone())
                .map(missions -> missions.items(tour))
                .orElse(List.of());
        return give(
                tour.drone(),
                DroneLaunchStatus.Stage.UPLOADING,
                DroneLaunchStatus.Stage.UPLOADED,
                new CommandRequest.UploadMission(items, null, null));
    }

    private CompletableFuture<Void> startAll(List<Tour> tours, boolean allUploaded) {
        if (!allUploaded) {
            tours.stream()
                    .map(Tour::drone)
                    .filter(drone -> stage(drone) == DroneLaunchStatus.Stage.UPLOADED)
                    .forEach(
                            drone -> settle(
                                    drone,
                                    DroneLaunchStatus.Stage.HELD_BACK,
                                    DroneLaunchStatus.Reason.of(
                                            OperationProblem.PLAN_INCOMPLETE,
                                            "It has its mission and was not started, since another drone of the plan has none.")));
            return CompletableFuture.completedFuture(null);
        }
        return all(tours.stream().map(this::startOne).toList());
    }

    private CompletableFuture<Boolean> startOne(Tour tour) {
        DroneId drone = tour.drone();
        return whenDue(tour)
                .thenComposeAsync(due -> goesOn(due, drone) ? whenClear(tour) : NO, desk.launches())
                .thenComposeAsync(due -> goesOn(due, drone) ? enterCommandMode(drone) : NO, desk.launches())
                .thenComposeAsync(ready -> goesOn(ready, drone) ? arm(drone) : NO, desk.launches())
                .thenComposeAsync(
                        armed -> goesOn(armed, drone) ? begin(drone) : armed ? disarm(drone) : NO, desk.launches())
                .whenComplete((begun, thrown) -> clearance.forget(drone));
    }

    /** True as soon as it rises into nobody's way, or nobody is to be started any more. */
    private CompletableFuture<Boolean> whenClear(Tour tour) {
        List<MissionItem> items = commands.known(principal, tour.drone().value())
                .map(state -> state.mission().items())
                .orElse(List.of());
        return clearance.await(
                tour.drone(),
                items == null ? List.of() : items,
                job.stopped(),
                () -> settle(
                        tour.drone(),
                        DroneLaunchStatus.Stage.WAITING,
                        DroneLaunchStatus.Reason.of(
                                OperationProblem.TAKE_OFF_NOT_CLEAR,
                                "It waits on the ground until another drone has left its way up.")));
    }

    /** True at the time of its departure, or as soon as nobody is to be started any more. */
    private CompletableFuture<Boolean> whenDue(Tour tour) {
        Duration wait = Duration.ofMillis(Math.round(tour.departsSeconds() * MILLIS));
        if (wait.isZero() || wait.isNegative()) {
            return CompletableFuture.completedFuture(true);
        }
        settle(tour.drone(), DroneLaunchStatus.Stage.WAITING, null);
        return desk.time().within(job.stopped().thenApply(why -> true), wait, true);
    }

    /** Tells of a drone that would go on, and is not to. */
    private boolean goesOn(boolean soFar, DroneId drone) {
        DroneLaunchStatus.Reason why = job.whyStopped();
        if (soFar && why != null) {
            settle(drone, DroneLaunchStatus.Stage.HELD_BACK, why);
        }
        return soFar && why == null;
    }

    private CompletableFuture<Boolean> enterCommandMode(DroneId drone) {
        return commandMode(drone)
                .map(mode -> give(
                        drone,
                        DroneLaunchStatus.Stage.ARMING,
                        DroneLaunchStatus.Stage.ARMING,
                        new CommandRequest.SetMode(mode, null, null)))
                .orElse(CompletableFuture.completedFuture(true));
    }

    private CompletableFuture<Boolean> arm(DroneId drone) {
        return give(
                drone,
                DroneLaunchStatus.Stage.ARMING,
                DroneLaunchStatus.Stage.STARTING,
                new CommandRequest.Arm(null, null));
    }

    private CompletableFuture<Boolean> begin(DroneId drone) {
        return give(
                drone,
                DroneLaunchStatus.Stage.STARTING,
                DroneLaunchStatus.Stage.STARTED,
                new CommandRequest.StartMission(start.onCloudLoss(), null, null));
    }

    /** It stands there with its motors running, and nobody will start it. */
    private CompletableFuture<Boolean> disarm(DroneId drone) {
        return give(
                        drone,
                        DroneLaunchStatus.Stage.STARTING,
                        DroneLaunchStatus.Stage.STARTING,
                        new CommandRequest.Disarm(null, null, null))
                .thenApply(disarmed -> {
                    goesOn(disarmed, drone);
                    return false;
                });
    }

    /** The mode in which it can be armed; empty when it is in one. */
    private Optional<String> commandMode(DroneId drone) {
        return commands.known(principal, drone.value())
                .filter(state -> !acceptsCommands(state, state.mode()))
                .flatMap(state -> state.capabilities().mode(Capabilities.Steering.ORDERS));
    }

    private static boolean acceptsCommands(DroneState state, @Nullable String mode) {
        return state.capabilities()
                .steering(mode)
                .filter(steering -> steering == Capabilities.Steering.ORDERS)
                .isPresent();
    }

    /** True once it has succeeded; else the drone's outcome says why it has not. */
    private CompletableFuture<Boolean> give(
            DroneId drone, DroneLaunchStatus.Stage during, DroneLaunchStatus.Stage after, CommandRequest what) {
        CommandView given;
        try {
            given = commands.submit(principal, face, drone.value(), what);
        } catch (Rejection refused) {
            job.settle(new DroneLaunchStatus(
                    drone, DroneLaunchStatus.Stage.FAILED, DroneLaunchStatus.Reason.of(refused), refused.commandId()));
            desk.notifyChanged(job);
            return CompletableFuture.completedFuture(false);
        } catch (RuntimeException failed) {
            // Thrown on, nobody would ever hear what became of this plan.
            settle(
                    drone,
                    DroneLaunchStatus.Stage.FAILED,
                    DroneLaunchStatus.Reason.of(OutageClassifier.rejectionOf(failed)));
            return CompletableFuture.completedFuture(false);
        }
        job.settle(new DroneLaunchStatus(drone, during, null, given.id()));
        desk.notifyChanged(job);
        return commands.awaitEndOrSilence(given, LONGEST_SILENCE).thenApply(ended -> ended(drone, after, ended));
    }

    private boolean ended(DroneId drone, DroneLaunchStatus.Stage after, CommandView command) {
        CommandView.OutcomeView outcome = command.outcome();
        boolean succeeded = outcome != null && outcome.result().equals("succeeded");
        String code = outcome == null ? null : outcome.code();
        String why = outcome == null ? "There was no news of it for three minutes." : outcome.reason();
        job.settle(
                succeeded
                        ? new DroneLaunchStatus(drone, after, null, command.id())
                        : new DroneLaunchStatus(
                                drone,
                                DroneLaunchStatus.Stage.FAILED,
                                new DroneLaunchStatus.Reason(
                                        code == null ? OutcomeCode.OUTCOME_UNKNOWN.word() : code,
                                        "To " + command.summary() + " did not succeed"
                                                + (why == null ? "." : ": " + why)),
                                command.id()));
        desk.notifyChanged(job);
        return succeeded;
    }

    private void settle(DroneId drone, DroneLaunchStatus.Stage stage, DroneLaunchStatus.@Nullable Reason why) {
        job.settle(new DroneLaunchStatus(drone, stage, why, null));
        desk.notifyChanged(job);
    }

    private DroneLaunchStatus.@Nullable Stage stage(DroneId drone) {
        return job.status().flights().stream()
                .filter(flight -> flight.drone().equals(drone))
                .map(DroneLaunchStatus::stage)
                .findFirst()
                .orElse(null);
    }
}
