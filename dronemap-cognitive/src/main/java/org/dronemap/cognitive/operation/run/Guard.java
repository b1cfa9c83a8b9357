package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.cognitive.operation.run.RunDrone.Errand;
import org.dronemap.cognitive.operation.run.Tracks.Track;
import org.dronemap.cognitive.problem.Separation;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.LocalPlane;

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
        draft.drones().stream().filter(drone -> drone.signs().yields() != null).forEach(guard::mayGoOn);
    }

    private void pair(RunDrone one, RunDrone other) {
        if (!mayHold(one) && !mayHold(other)) {
            return;
        }
        List<Track> mine = near.of(draft, one, looks.get(one.id()));
        List<Track> yours = near.of(draft, other, looks.get(other.id()));
        if (!meet(mine, yours)) {
            return;
        }
        boolean second = mayHold(other) && !meet(mine, standing(yours));
        boolean first = mayHold(one) && !meet(standing(mine), yours);
        if (second || !first) {
            hold(other, one);
        }
        if (!second) {
            hold(one, other);
        }
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

    private void hold(RunDrone drone, RunDrone other) {
        if (!mayHold(drone)) {
            return;
        }
        RunDrone waits = drone.with(drone.signs().yields(other.id())).to(DroneStage.HOLDING, draft.now());
        draft.give(waits, Errand.Kind.HOLD, new Command.PauseMission());
        draft.say(Trigger.TOO_NEAR, drone.id(), drone.name() + " waits until " + other.name() + " has passed.");
    }

    private void mayGoOn(RunDrone drone) {
        Look look = looks.get(drone.id());
        if (drone.stage() != DroneStage.HOLDING || look == null || look.place() == null) {
            draft.put(drone.with(drone.signs().yields(null)));
        } else if (drone.errand() == null && look.waits() && drone.next() == null) {
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
