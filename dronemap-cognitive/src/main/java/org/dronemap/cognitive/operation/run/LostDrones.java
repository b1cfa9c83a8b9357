package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.ReplanCause;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Speeds;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.safety.SafetyTimes;
import org.jspecify.annotations.Nullable;

/** Handles drones of a mission run that are not heard: which waypoints stay theirs, and what they did meanwhile. */
final class LostDrones {
    /** Vehicles that miss the cloud go home, if they were told to. */
    private static final Duration UNTIL_FAIL_SAFE = SafetyTimes.CORRIDOR_KEPT;
    /** So far ahead a drone that flies on keeps its waypoints; what comes later is given to others. */
    private static final Duration FLIES_ON = Duration.ofSeconds(60);
    /** Beside what the way takes. */
    private static final Duration MARGIN = Duration.ofSeconds(60);

    private static final Duration UNTIL_ALL_IS_TOLD = Duration.ofMillis(2_500);
    /** Who does not tell its mission is taken as it is then. */
    private static final Duration LONGEST_UNTOLD = Duration.ofSeconds(8);

    private static final double STEEPLY_METERS = 120;

    private LostDrones() {}

    static void linkLost(RunTransition draft, RunDrone drone, DroneObservation look) {
        if (drone.stage().compareTo(RunDroneStage.STARTING) < 0) {
            onTheGround(draft, drone);
        } else if (drone.stage().compareTo(RunDroneStage.RETURNING) <= 0) {
            inTheAir(draft, drone, look);
        }
    }

    private static void onTheGround(RunTransition draft, RunDrone drone) {
        if (drone.stage() != RunDroneStage.LANDED || !drone.orders().isEmpty()) {
            DroneWithdrawal.withdraw(
                    draft, drone.withSortie(null, 0), RunDroneStage.LANDED, RunTrigger.LOST, silentOnTheGround(drone));
        }
    }

    private static String silentOnTheGround(RunDrone drone) {
        return "Nothing is heard of " + drone.name() + ", which stands on the ground.";
    }

    /** It may get waypoints again, and is no longer said to be silent. */
    static void endSilenceOnTheGround(RunTransition draft, RunDrone drone) {
        if (silentOnTheGround(drone).equals(drone.note())) {
            draft.put(drone.noted(null));
            draft.explain(RunTrigger.HEARD_AGAIN, drone.id(), drone.name() + " is heard again; it is on the ground.");
        }
    }

    private static String silentInTheAir(RunTransition draft, RunDrone drone, List<String> reserved) {
        return "Nothing is heard of " + drone.name() + " any more; it " + RunMessages.mayGoOn(draft, drone) + ". "
                + switch (reserved.size()) {
                    case 0 -> "Nothing is reserved for it.";
                    case 1 -> "1 waypoint (" + reserved.get(0) + ") is reserved for it.";
                    default ->
                        RunMessages.count(reserved.size(), "waypoint") + " (" + RunMessages.list(reserved)
                                + ") are reserved for it.";
                };
    }

    private static void inTheAir(RunTransition draft, RunDrone drone, DroneObservation look) {
        Instant heard = draft.now().minus(look.silence());
        boolean flies = drone.stage() == RunDroneStage.FLYING || drone.stage() == RunDroneStage.STARTING;
        boolean goesOn = draft.setting().onCloudLoss() == MissionCloudLossPolicy.CONTINUE;
        Duration reach = !flies ? Duration.ZERO : goesOn ? FLIES_ON : UNTIL_FAIL_SAFE;
        List<String> reserved = reached(draft, drone, look.place(), reach);
        Instant until = heard.plus(goesOn ? reach.plus(MARGIN) : SafetyTimes.CORRIDOR_FREED);
        RunDrone.LinkLoss silence = new RunDrone.LinkLoss(
                heard,
                look.place(),
                drone.stage() == RunDroneStage.FLYING,
                until,
                heard.plus(longest(drone, look.place(), flies && goesOn)));
        String name = drone.name();
        String words = silentInTheAir(draft, drone, reserved);
        boolean offers = drone.orders().size() > reserved.size();
        RunDrone silent = draft.release(drone, "Nothing was heard of " + name + ".")
                .withOrders(reserved)
                .noted(words);
        reserved.forEach(id -> draft.put(draft.target(id).to(RunWaypoint.State.RESERVED, drone.id(), null)));
        draft.put(silent.with(silent.flags()
                        .withLinkLoss(silence)
                        .fallingSince(null)
                        .deviatingSince(null)
                        .waitsFor(null))
                .to(RunDroneStage.SILENT, draft.now()));
        if (offers) {
            draft.addCause(RunTrigger.LOST, drone.id(), words, drone.orders());
        } else {
            draft.explain(RunTrigger.LOST, drone.id(), words);
        }
    }

    /** The waypoints that it may come to within that time, the one that it flies to among them. */
    static List<String> reached(RunTransition draft, RunDrone drone, @Nullable Place from, Duration time) {
        List<String> reached = new ArrayList<>();
        Speeds speeds = drone.craft().performance().speeds();
        double left = time.toMillis() / 1_000.0;
        Place at = from;
        for (String id : drone.orders()) {
            if (left <= 0) {
                break;
            }
            reached.add(id);
            RunWaypoint target = draft.target(id);
            Place there = target.waypoint().place();
            if (at != null) {
                left -= Geodesy.distanceMeters(at.point(), there.point()) / speeds.cruise();
            }
            left -= target.waypoint().task().serviceSeconds();
            at = there;
        }
        return reached;
    }

    /** Its mission to the end where it flies on, else its way home. */
    static Duration longest(RunDrone drone, @Nullable Place place, boolean mission) {
        Sortie sortie = drone.sortie();
        Duration way = Duration.ofMinutes(2);
        if (mission && sortie != null) {
            double from = sortie.tour().departsSeconds();
            way = Duration.ofMillis(Math.round(1_000 * (sortie.tour().endsSeconds() - from)));
        } else if (place != null) {
            Speeds speeds = drone.craft().performance().speeds();
            Place home = drone.craft().finish().place();
            double down = Math.max(STEEPLY_METERS, place.altitudeAmslMeters() - home.altitudeAmslMeters());
            double seconds = Geodesy.distanceMeters(place.point(), home.point()) / speeds.cruise()
                    + down / Math.min(speeds.climb(), speeds.descent());
            way = Duration.ofMillis(Math.round(1_000 * seconds)).plus(UNTIL_FAIL_SAFE);
        }
        return way.plus(MARGIN);
    }

    static void observe(RunTransition draft, DroneObservation look) {
        RunDrone drone = renoted(draft, draft.drone(look.drone()));
        RunDrone.LinkLoss silence = Objects.requireNonNull(drone.flags().linkLoss());
        if (look.isLive() && look.ready() && look.mode() != null && look.armed() != null) {
            awaitReports(draft, drone, look);
            return;
        }
        if (drone.attempts().notBefore() != null) {
            drone = drone.tried(RunDrone.Attempts.NONE);
            draft.put(drone);
        }
        if (draft.now().isAfter(silence.flyingUntil())) {
            String words = drone.name() + " was not heard again; " + whereAbouts(draft, drone, silence, look);
            DroneWithdrawal.withdraw(draft, drone, RunDroneStage.GONE, RunTrigger.GONE, words);
        } else if (draft.now().isAfter(silence.reservedUntil())
                && !drone.orders().isEmpty()) {
            String words = drone.name() + " was not heard again; what was reserved for it is offered to the others.";
            draft.put(renoted(draft, draft.release(drone, words)));
            draft.addCause(RunTrigger.GONE, drone.id(), words, drone.orders());
        }
    }

    /** A plane circles over its home for as long as it can; what drives is never down. */
    private static String whereAbouts(
            RunTransition draft, RunDrone drone, RunDrone.LinkLoss silence, DroneObservation look) {
        if (!draft.isWordedBefore(2) && SilentPlaces.mayHover(drone, look, draft.now())) {
            return "it may still hover where it was heard last, until " + SilentPlaces.until(drone, silence) + ".";
        }
        if (!draft.isWordedBefore(2) && drone.profile().kind() == VehicleKind.FIXED_WING) {
            return "it may be down, or circle over its home.";
        }
        return draft.isWordedBefore(2) || drone.profile().flies()
                ? "it must be down by now."
                : "it must have come to a stop by now.";
    }

    /** What was reserved for it may have been visited, cancelled or offered to others since. */
    private static RunDrone renoted(RunTransition draft, RunDrone drone) {
        RunDrone noted = drone.noted(silentInTheAir(draft, drone, drone.orders()));
        draft.put(noted);
        return noted;
    }

    /** Who is down says a moment later how far it came. */
    private static void awaitReports(RunTransition draft, RunDrone drone, DroneObservation look) {
        Instant from = drone.attempts().notBefore();
        if (!look.isDisarmed()) {
            linkRegained(draft, drone, look);
        } else if (from == null) {
            draft.put(drone.tried(new RunDrone.Attempts(0, draft.now().plus(UNTIL_ALL_IS_TOLD))));
        } else if (!draft.now().isBefore(look.isFullyReported() ? from : from.plus(LONGEST_UNTOLD))) {
            linkRegained(draft, drone, look);
        }
    }

    /** What it has reached is reckoned already. */
    private static void linkRegained(RunTransition draft, RunDrone silent, DroneObservation look) {
        boolean flew = Objects.requireNonNull(silent.flags().linkLoss()).flew();
        boolean explained = RunCloudLoss.bringsHome(draft, flew);
        RunDrone drone =
                silent.tried(RunDrone.Attempts.NONE).with(silent.flags().withLinkLoss(null));
        String name = drone.name();
        if (look.isDisarmed()) {
            down(draft, drone, look, explained);
        } else if (look.comesDown()) {
            String words = name + " is heard again; it comes home or down"
                    + (draft.isWordedBefore(2) ? " by itself." : " (" + look.mode() + ").");
            DroneWithdrawal.withdraw(draft, drone, RunDroneStage.RETURNING, RunTrigger.HEARD_AGAIN, words);
            if (explained) {
                RunCloudLoss.markMissed(draft, draft.drone(drone.id()));
            }
        } else if (look.isSteered() || (look.waits() && look.airborne() && flew && look.giveWay() == null)) {
            // Who flew a mission does not come to stand by itself.
            String words = name + " is heard again, in mode " + look.mode() + "; it is left alone until it is resumed.";
            DroneWithdrawal.withdraw(draft, drone, RunDroneStage.SUSPENDED, RunTrigger.HEARD_AGAIN, words);
        } else {
            reclaim(draft, drone, look);
        }
    }

    private static void down(RunTransition draft, RunDrone drone, DroneObservation look, boolean explained) {
        if (explained && HomeArrival.isAtHome(drone, look)) {
            rejoin(draft, drone);
            return;
        }
        boolean done = drone.sortie() != null && look.isAtTheEnd();
        String words =
                drone.name() + " is heard again; it is down" + (done ? ", as its mission was flown to the end." : ".");
        if (done) {
            DroneWithdrawal.withdraw(
                    draft, drone.withSortie(null, 0), RunDroneStage.LANDED, RunTrigger.HEARD_AGAIN, words);
            draft.causes().add(new ReplanCause(RunTrigger.HEARD_AGAIN, drone.id(), words, drone.orders()));
        } else {
            DroneWithdrawal.withdraw(draft, drone, RunDroneStage.LEFT, RunTrigger.HEARD_AGAIN, words);
        }
    }

    /** Whether it is down where its fail-safe brings it, after it had missed the cloud: nothing is wrong with it. */
    static boolean cameHome(RunDrone drone, DroneObservation look) {
        return RunCloudLoss.hasMissed(drone) && HomeArrival.isAtHome(drone, look);
    }

    static void rejoin(RunTransition draft, RunDrone drone) {
        String words = drone.name() + " came home since it had missed the cloud; it takes part again.";
        RunDrone out =
                draft.release(drone, words).withSortie(null, 0).noted(null).to(RunDroneStage.LANDED, draft.now());
        draft.put(out.with(out.flags().triggers(List.of())));
        draft.addCause(RunTrigger.HEARD_AGAIN, drone.id(), words, drone.orders());
    }

    private static void reclaim(RunTransition draft, RunDrone drone, DroneObservation look) {
        Sortie sortie = drone.sortie();
        boolean carries = !Boolean.FALSE.equals(look.progress().carries());
        boolean own = carries && sortie != null && drone.orders().containsAll(sortie.ahead(drone.passed()));
        drone.orders().forEach(id -> draft.put(draft.target(id).to(RunWaypoint.State.ASSIGNED, drone.id(), null)));
        RunDrone back = drone.noted(null);
        if (own && look.isOnMission()) {
            draft.put(back.to(RunDroneStage.FLYING, draft.now()));
        } else {
            draft.put(back.to(RunDroneStage.HOLDING, draft.now()));
        }
        draft.addCause(
                RunTrigger.HEARD_AGAIN,
                drone.id(),
                drone.name() + " is heard again; it "
                        + (own && look.isOnMission() ? "goes on." : RunMessages.waits(draft, drone) + " for a plan."));
    }
}
