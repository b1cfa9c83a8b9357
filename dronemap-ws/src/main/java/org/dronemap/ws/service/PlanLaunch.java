package org.dronemap.ws.service;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.core.access.Principal;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Brings the missions of an accepted plan to its drones, and starts them if that was asked for: all missions first, since
 * a drone that flies without the others may meet them. Every command goes through the gate, as the user who accepted.
 */
final class PlanLaunch {
    private static final Logger LOG = LoggerFactory.getLogger(PlanLaunch.class);
    private static final Duration LONGEST_COMMAND = Duration.ofMinutes(3);
    private static final double MILLIS = 1_000;

    private final PlanDesk desk;
    private final CommandService commands;
    private final PlanJob job;
    private final Principal principal;
    private final String face;
    private final Start start;

    /** Whether drones are started, and what they do when they no longer hear the cloud. */
    record Start(boolean wanted, @Nullable String onCloudLoss) {}

    /** {@code caller}: who accepted the plan. */
    PlanLaunch(PlanDesk desk, CommandService commands, PlanJob job, Caller caller, Start start) {
        this.desk = desk;
        this.commands = commands;
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
                    desk.tell(job);
                });
    }

    private @Nullable Void broken(Throwable thrown) {
        LOG.error("The plan {} could not be carried out", job.id(), thrown);
        job.status().flights().stream()
                .filter(flight -> !flight.stage().isEnd())
                .forEach(flight -> settle(
                        flight.drone(),
                        PlanFlight.Stage.FAILED,
                        "The server failed; those who run it find out why in its log."));
        return null;
    }

    private static CompletableFuture<Void> all(List<CompletableFuture<Boolean>> each) {
        return CompletableFuture.allOf(each.toArray(CompletableFuture[]::new));
    }

    private CompletableFuture<Boolean> upload(Tour tour) {
        List<MissionItemView> items = job.order()
                .missions(tour.drone())
                .map(missions -> missions.items(tour))
                .orElse(List.of());
        return give(
                tour.drone(),
                PlanFlight.Stage.UPLOADING,
                PlanFlight.Stage.UPLOADED,
                CommandRequest.uploadMission(items));
    }

    private CompletableFuture<Void> startAll(List<Tour> tours, boolean allUploaded) {
        if (!allUploaded) {
            tours.stream()
                    .map(Tour::drone)
                    .filter(drone -> stage(drone) == PlanFlight.Stage.UPLOADED)
                    .forEach(drone -> settle(
                            drone,
                            PlanFlight.Stage.HELD_BACK,
                            "It has its mission and was not started, since another drone of the plan has none."));
            return CompletableFuture.completedFuture(null);
        }
        return all(tours.stream().map(this::startOne).toList());
    }

    private CompletableFuture<Boolean> startOne(Tour tour) {
        DroneId drone = tour.drone();
        long millis = Math.round(tour.departsSeconds() * MILLIS);
        if (millis > 0) {
            settle(drone, PlanFlight.Stage.WAITING, null);
        }
        Executor whenDue = CompletableFuture.delayedExecutor(millis, TimeUnit.MILLISECONDS, desk.launches());
        return CompletableFuture.supplyAsync(() -> modeForOrders(drone), whenDue)
                .thenCompose(mode -> mode.map(name -> give(
                                drone, PlanFlight.Stage.ARMING, PlanFlight.Stage.ARMING, CommandRequest.setMode(name)))
                        .orElse(CompletableFuture.completedFuture(true)))
                .thenComposeAsync(
                        ready -> giveIf(
                                ready,
                                drone,
                                PlanFlight.Stage.ARMING,
                                PlanFlight.Stage.STARTING,
                                CommandRequest.simple("arm")),
                        desk.launches())
                .thenComposeAsync(
                        armed -> giveIf(
                                armed,
                                drone,
                                PlanFlight.Stage.STARTING,
                                PlanFlight.Stage.STARTED,
                                CommandRequest.startMission(start.onCloudLoss())),
                        desk.launches());
    }

    private CompletableFuture<Boolean> giveIf(
            boolean wanted, DroneId drone, PlanFlight.Stage during, PlanFlight.Stage after, CommandRequest what) {
        return wanted ? give(drone, during, after, what) : CompletableFuture.completedFuture(false);
    }

    /** The mode in which it can be armed; empty when it is in one. */
    private Optional<String> modeForOrders(DroneId drone) {
        return commands.known(principal, drone.value())
                .filter(state -> !takesOrders(state, state.mode()))
                .flatMap(state -> state.capabilities().modes().stream()
                        .filter(mode -> takesOrders(state, mode))
                        .min((one, other) -> one.equals("GUIDED") ? -1 : other.equals("GUIDED") ? 1 : 0));
    }

    private static boolean takesOrders(DroneState state, @Nullable String mode) {
        return state.capabilities()
                .steering(mode)
                .filter(steering -> steering == Capabilities.Steering.ORDERS)
                .isPresent();
    }

    /** True once it has succeeded; else the drone's outcome says why it has not. */
    private CompletableFuture<Boolean> give(
            DroneId drone, PlanFlight.Stage during, PlanFlight.Stage after, CommandRequest what) {
        CommandView given;
        try {
            given = commands.submit(principal, face, drone.value(), what);
        } catch (Rejection refused) {
            job.settle(new PlanFlight(drone, PlanFlight.Stage.FAILED, refused.sentence(), refused.commandId()));
            desk.tell(job);
            return CompletableFuture.completedFuture(false);
        }
        job.settle(new PlanFlight(drone, during, null, given.id()));
        desk.tell(job);
        return commands.awaitEnd(given, LONGEST_COMMAND).thenApply(ended -> ended(drone, after, ended));
    }

    private boolean ended(DroneId drone, PlanFlight.Stage after, CommandView command) {
        CommandView.OutcomeView outcome = command.outcome();
        boolean succeeded = outcome != null && outcome.result().equals("succeeded");
        String why = outcome == null ? "It has not ended after three minutes." : outcome.reason();
        job.settle(
                succeeded
                        ? new PlanFlight(drone, after, null, command.id())
                        : new PlanFlight(
                                drone,
                                PlanFlight.Stage.FAILED,
                                "To " + command.summary() + " did not succeed" + (why == null ? "." : ": " + why),
                                command.id()));
        desk.tell(job);
        return succeeded;
    }

    private void settle(DroneId drone, PlanFlight.Stage stage, @Nullable String why) {
        job.settle(new PlanFlight(drone, stage, why, null));
        desk.tell(job);
    }

    private PlanFlight.@Nullable Stage stage(DroneId drone) {
        return job.status().flights().stream()
                .filter(flight -> flight.drone().equals(drone))
                .map(PlanFlight::stage)
                .findFirst()
                .orElse(null);
    }
}
