package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.dronemap.cognitive.operation.run.RunDrone.Errand;
import org.dronemap.cognitive.operation.run.Tracks.Track;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Separation;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.mission.Altitude;

/**
 * Looks some seconds ahead: plans keep drones apart, but who was held, called home or blown back is not where its plan says.
 * Of two that would come too near to each other one waits until the other has passed.
 */
final class Guard {
    private static final double AHEAD_SECONDS = 10;
    /** Who goes on must not be stopped again at once. */
    private static final double CLEAR_SECONDS = 14;

    private static final double ROOM_METERS = 2;
    /** Heights wander by so much; layers are exactly as far apart as they must be. */
    private static final double WANDER_METERS = 0.6;
    /** From the decision until it stands. */
    static final int STRIDES_TO_STAND = 4;

    /** From the decision until it rises. */
    private static final int STRIDES_TO_ARM = 6;
    /** The share of the distance that two who fly by their plans may come to. */
    private static final double AS_PLANNED = 0.7;

    private static final Duration LONGEST_YIELD = Duration.ofSeconds(15);

    private final Draft draft;
    private final Map<DroneId, Look> looks = new HashMap<>();
    private final double horizontal;
    private final double vertical;
    private final Tracks near;
    private final Tracks far;

    private Guard(Draft draft, List<Look> seen) {
        this.draft = draft;
        seen.forEach(look -> looks.put(look.drone(), look));
        Separation separation = draft.setting().rules().separation();
        horizontal = separation.horizontalMeters() + ROOM_METERS;
        vertical = separation.verticalMeters() - WANDER_METERS;
        LocalPlane plane =
                new LocalPlane(draft.drones().get(0).craft().finish().place().point());
        near = new Tracks(plane, AHEAD_SECONDS);
        far = new Tracks(plane, CLEAR_SECONDS);
    }

    static void watch(Draft draft, List<Look> looks) {
        Guard guard = new Guard(draft, looks);
        List<RunDrone> drones = draft.drones();
        for (int i = 0; i < drones.size(); i++) {
            for (int j = i + 1; j < drones.size(); j++) {
                guard.pair(
                        draft.drone(drones.get(i).id()),
                        draft.drone(drones.get(j).id()));
            }
        }
        draft.drones().stream().filter(drone -> waitsToRise(draft, drone)).forEach(guard::mayRise);
        draft.drones().stream()
                .filter(drone -> drone.signs().yields() != null && !waitsToRise(draft, drone))
                .forEach(guard::mayGoOn);
    }

    private void pair(RunDrone one, RunDrone other) {
        if (!mayMove(one) && !mayMove(other)) {
            return;
        }
        List<Track> mine = near.of(draft, one, looks.get(one.id()));
        List<Track> yours = near.of(draft, other, looks.get(other.id()));
        if (!meet(mine, yours)) {
            return;
        }
        boolean second = mayHold(other) && !meet(mine, standing(yours));
        boolean first = mayHold(one) && !meet(standing(mine), yours);
        if (second) {
            hold(other, one);
        } else if (first) {
            hold(one, other);
        } else if (!dodge(one, other)) {
            hold(other, one);
            hold(one, other);
        }
    }

    /** One of the two gets out of the way, whose step is smaller. */
    private boolean dodge(RunDrone one, RunDrone other) {
        Optional<Dodge> mine = step(one);
        Optional<Dodge> yours = step(other);
        boolean second = yours.isPresent() && (mine.isEmpty() || yours.get().isBetterThan(mine.get()));
        RunDrone who = second ? other : one;
        RunDrone whom = second ? one : other;
        Optional<Dodge> step = second ? yours : mine;
        step.ifPresent(found -> {
            Duration takes = Duration.ofMillis(Math.round(1_000 * found.seconds()));
            RunDrone goes = who.with(who.signs().yields(whom.id())).to(DroneStage.HOLDING, draft.now());
            draft.give(
                    goes.busy(draft.now().plus(takes)),
                    Errand.Kind.DODGE,
                    new Command.GoTo(
                            found.to().point(),
                            new Altitude(found.to().altitudeAmslMeters(), Altitude.Reference.AMSL)));
            draft.say(
                    Trigger.TOO_NEAR,
                    who.id(),
                    who.name() + " " + found.words() + ", to make room for " + whom.name() + ".");
        });
        return step.isPresent();
    }

    private Optional<Dodge> step(RunDrone drone) {
        Look look = looks.get(drone.id());
        if (!mayDodge(drone) || look == null || look.place() == null) {
            return Optional.empty();
        }
        List<Track> others = draft.drones().stream()
                .filter(other -> !other.id().equals(drone.id()))
                .flatMap(other -> near.of(draft, other, looks.get(other.id())).stream())
                .toList();
        return Dodge.of(
                drone,
                look.place(),
                draft.setting().barriers(),
                near,
                track -> others.stream()
                        .mapToDouble(other -> track.clearance(other, horizontal, vertical))
                        .min()
                        .orElse(Double.POSITIVE_INFINITY));
    }

    private boolean mayMove(RunDrone drone) {
        return mayHold(drone) || mayDodge(drone);
    }

    /** It flies its mission or waits in the air, is ours, and is on no way out already. */
    private boolean mayDodge(RunDrone drone) {
        Look look = looks.get(drone.id());
        if (mayHold(drone)) {
            return look != null && look.canGoTo();
        }
        return look != null
                && drone.stage() == DroneStage.HOLDING
                && drone.errand() == null
                && !isBusy(drone)
                && look.isLive()
                && look.takenBy() == null
                && look.waits()
                && look.canGoTo()
                && look.airborne();
    }

    private boolean meet(List<Track> some, List<Track> others) {
        return some.stream().anyMatch(one -> others.stream().anyMatch(other -> one.meets(other, horizontal, vertical)));
    }

    private static List<Track> standing(List<Track> tracks) {
        return tracks.stream().map(track -> track.stopping(STRIDES_TO_STAND)).toList();
    }

    /** It flies its mission, and is ours to stop. */
    private boolean mayHold(RunDrone drone) {
        Look look = looks.get(drone.id());
        return look != null
                && drone.stage() == DroneStage.FLYING
                && drone.errand() == null
                && look.isLive()
                && look.takenBy() == null
                && look.isOnMission()
                && look.airborne();
    }

    private boolean isBusy(RunDrone drone) {
        Instant until = drone.tries().notBefore();
        return until != null && draft.now().isBefore(until);
    }

    private void hold(RunDrone drone, RunDrone other) {
        if (!mayHold(drone)) {
            return;
        }
        RunDrone waits = drone.with(drone.signs().yields(other.id())).to(DroneStage.HOLDING, draft.now());
        draft.give(waits, Errand.Kind.HOLD, new Command.PauseMission());
        draft.say(Trigger.TOO_NEAR, drone.id(), drone.name() + " waits until " + other.name() + " has passed.");
    }

    private static boolean waitsToRise(Draft draft, RunDrone drone) {
        Sortie sortie = drone.sortie();
        boolean due = drone.stage() == DroneStage.READY && sortie != null && Launch.isDue(draft, sortie);
        return due || drone.stage() == DroneStage.ARMING;
    }

    /** Nobody takes off into the way of one who is in the air. */
    private void mayRise(RunDrone drone) {
        Look look = looks.get(drone.id());
        Place place = look == null ? null : look.place();
        if (look == null || place == null || look.isArmed()) {
            return;
        }
        Track at = far.mission(drone, place, 0);
        List<Track> up = List.of(at, at.after(STRIDES_TO_ARM));
        Optional<RunDrone> above = draft.drones().stream()
                .filter(other -> !other.id().equals(drone.id()) && other.stage().mayFly())
                .filter(other -> far.of(draft, other, looks.get(other.id())).stream()
                        .anyMatch(way -> up.stream().anyMatch(mine -> isInTheWay(mine, way, other))))
                .findFirst();
        DroneId yields = above.map(RunDrone::id).orElse(null);
        if (!Objects.equals(yields, drone.signs().yields())) {
            draft.put(drone.with(drone.signs().yields(yields)));
            above.filter(other -> drone.signs().yields() == null)
                    .ifPresent(other -> draft.say(
                            Trigger.TOO_NEAR,
                            drone.id(),
                            drone.name() + " waits on the ground until " + other.name() + " has passed."));
        }
    }

    /** Who flies by its plan was planned for: no room is left beside the least distance. */
    private boolean isInTheWay(Track mine, Track way, RunDrone other) {
        boolean planned = other.stage() == DroneStage.FLYING || other.stage() == DroneStage.STARTING;
        return mine.clearance(way, horizontal, vertical) < (planned ? AS_PLANNED : 1);
    }

    private void mayGoOn(RunDrone drone) {
        Look look = looks.get(drone.id());
        if (drone.stage() != DroneStage.HOLDING || look == null || look.place() == null) {
            draft.put(drone.with(drone.signs().yields(null)));
        } else if (drone.errand() == null && look.waits() && drone.next() == null && !isBusy(drone)) {
            List<Track> mine = List.of(far.mission(drone, look.place(), 0));
            boolean clear = draft.drones().stream()
                    .filter(other -> !other.id().equals(drone.id()))
                    .noneMatch(other -> meet(mine, far.of(draft, other, looks.get(other.id()))));
            boolean late = Duration.between(drone.since(), draft.now()).compareTo(LONGEST_YIELD) > 0;
            if (clear) {
                draft.put(drone.with(drone.signs().yields(null)).to(DroneStage.CONTINUING, draft.now()));
            } else if (late) {
                draft.put(drone.with(drone.signs().yields(null)));
                draft.cause(Trigger.TOO_NEAR, drone.id(), drone.name() + " cannot pass; another way is looked for.");
            }
        }
    }
}
