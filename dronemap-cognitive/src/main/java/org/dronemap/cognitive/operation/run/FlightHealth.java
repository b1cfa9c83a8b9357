package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Power;
import org.dronemap.cognitive.problem.Speeds;
import org.dronemap.core.drone.ReturnHeight;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodesy;
import org.jspecify.annotations.Nullable;

/** Checks a mission run's drone in flight: falling, standing still, off its path, late, or short of charge. */
final class FlightHealth {
    static final double CLEARLY_UP_METERS = 3;

    private static final double LEAST_FALL = 5;
    private static final double STEEPEST_DEGREES = 75;
    /** Long enough that one wrong reading is none. */
    private static final Duration FALLS = Duration.ofMillis(400);

    /** Long enough that nothing does it on its way down. */
    private static final Duration FLIES = Duration.ofSeconds(4);

    private static final Duration MOVES = Duration.ofSeconds(2);
    private static final double UPRIGHT_DEGREES = 45;
    /** As a share of how fast it sinks by itself. */
    private static final double TOO_QUICKLY = 1.5;

    private static final Duration LIES = Duration.ofSeconds(4);
    private static final double FAR_BELOW_METERS = 8;
    private static final double JUST_UP_METERS = 1.5;
    /** How much stillness and the stage may be apart, as they are looked at in turns. */
    private static final Duration BEFORE_IT_ROSE = Duration.ofSeconds(1);

    private static final Duration LONGEST_STILL = Duration.ofSeconds(30);
    private static final double OFF_METERS = 40;
    private static final Duration OFF = Duration.ofSeconds(4);
    private static final Duration LATE = Duration.ofSeconds(45);
    /** Of the reserve that must be left at the end. */
    private static final double TOUCHED = 0.6;

    private FlightHealth() {}

    /** True when it has just been seen to fall, or to lie on the ground. */
    static boolean checkFall(RunTransition draft, RunDrone drone, DroneObservation look) {
        Instant falling = drone.flags().fallingSince();
        if (!isFalling(drone, look)) {
            if (falling != null) {
                draft.put(drone.with(drone.flags().fallingSince(null)));
            }
            return lies(draft, drone, look);
        }
        if (falling == null) {
            draft.put(drone.with(drone.flags().fallingSince(draft.now())));
            return false;
        }
        if (Duration.between(falling, draft.now()).compareTo(FALLS) < 0) {
            return false;
        }
        crashed(draft, drone, "it falls");
        return true;
    }

    static void crashed(RunTransition draft, RunDrone drone, String how) {
        String words = drone.name() + " has crashed: " + how + ".";
        DroneWithdrawal.withdraw(draft, drone, RunDroneStage.CRASHED, RunTrigger.CRASHED, words);
    }

    /** What was taken for a crash was none when it is seen to fly: people decide on it, and others keep apart from it. */
    static void checkCrashed(RunTransition draft, RunDrone drone, DroneObservation look) {
        Instant since = drone.flags().deviatingSince();
        if (!isSeenToFly(drone, look)) {
            if (since != null) {
                draft.put(drone.with(drone.flags().deviatingSince(null)));
            }
        } else if (since == null) {
            draft.put(drone.with(drone.flags().deviatingSince(draft.now())));
        } else if (Duration.between(since, draft.now()).compareTo(FLIES) >= 0) {
            String words = drone.name() + " was taken for crashed, but flies"
                    + (look.mode() == null ? "" : " in mode " + look.mode())
                    + "; it is left alone until somebody resumes it here.";
            DroneWithdrawal.withdraw(draft, drone, RunDroneStage.SUSPENDED, RunTrigger.HEARD_AGAIN, words);
        }
    }

    /** It moves, upright, and does not fall; what lies somewhere does not. */
    static boolean isSeenToFly(RunDrone drone, DroneObservation look) {
        Double tilt = look.tiltDegrees();
        return look.isLive()
                && look.isArmed()
                && look.airborne()
                && look.still().compareTo(MOVES) < 0
                && tilt != null
                && tilt < UPRIGHT_DEGREES
                && !isFalling(drone, look);
    }

    private static boolean isFalling(RunDrone drone, DroneObservation look) {
        double fastest =
                Math.max(LEAST_FALL, 2 * drone.craft().performance().speeds().descent() + 2);
        Double climb = look.climb();
        Double tilt = look.tiltDegrees();
        return (hovers(drone) && climb != null && climb < -fastest) || (tilt != null && tilt > STEEPEST_DEGREES);
    }

    /** It falls, or leans and sinks as no copter does that flies: it reaches nothing that it comes by. */
    static boolean tumbles(RunDrone drone, DroneObservation look) {
        Double tilt = look.tiltDegrees();
        Double climb = look.climb();
        double quick = TOO_QUICKLY * drone.craft().performance().speeds().descent();
        boolean leans = hovers(drone) && tilt != null && tilt > UPRIGHT_DEGREES;
        return (leans && climb != null && climb < -quick) || isFalling(drone, look);
    }

    private static boolean hovers(RunDrone drone) {
        VehicleKind kind = drone.profile().kind();
        return kind == VehicleKind.MULTICOPTER || kind == VehicleKind.HELICOPTER;
    }

    /** Armed, without moving, far below where its mission leads: a fallen copter does not say that it fell. */
    private static boolean lies(RunTransition draft, RunDrone drone, DroneObservation look) {
        Place place = look.place();
        Sortie sortie = drone.sortie();
        if (place == null
                || sortie == null
                || !drone.profile().flies()
                || drone.stage() == RunDroneStage.RETURNING
                || look.still().compareTo(LIES) < 0
                || !(place.altitudeAmslMeters() < lowestUp(draft, drone, look, sortie))) {
            return false;
        }
        crashed(draft, drone, "it lies far below its path");
        return true;
    }

    /** Who is lower does not fly: while it takes off just above the ground, then well below its path. */
    private static double lowestUp(RunTransition draft, RunDrone drone, DroneObservation look, Sortie sortie) {
        if (CraftSnapshots.isTakingOff(drone)) {
            double ground = drone.craft().start().place().altitudeAmslMeters();
            return hasMoved(draft, drone, look) ? ground + JUST_UP_METERS : Double.NEGATIVE_INFINITY;
        }
        return drone.passed() == 0
                ? Double.NEGATIVE_INFINITY
                : MissionLegs.lowest(sortie, drone.passed()) - FAR_BELOW_METERS;
    }

    /** Since it is said to fly: one that has not risen yet stands on the ground just as one that fell. */
    private static boolean hasMoved(RunTransition draft, RunDrone drone, DroneObservation look) {
        Duration flying = Duration.between(drone.since(), draft.now());
        return drone.stage() == RunDroneStage.FLYING
                && look.still().plus(BEFORE_IT_ROSE).compareTo(flying) < 0;
    }

    static void check(RunTransition draft, RunDrone drone, DroneObservation look) {
        Sortie sortie = drone.sortie();
        Place place = look.place();
        if (sortie == null || place == null) {
            return;
        }
        double waits = MissionLegs.hold(sortie, drone.passed()) + MissionLegs.held(sortie, drone.passed());
        Duration longest = LONGEST_STILL.plusSeconds(Math.round(waits));
        // How long it stood before it was let go on does not count.
        Duration flying = Duration.between(drone.since(), draft.now());
        if (look.still().compareTo(longest) > 0 && flying.compareTo(longest) > 0) {
            DroneWithdrawal.callHome(
                    draft, drone, RunTrigger.LATE, drone.name() + " does not move on; it is called home.");
            return;
        }
        offPath(draft, drone, MissionLegs.offMeters(sortie, drone.passed(), place));
        if (!drone.orders().isEmpty()) {
            late(draft, draft.drone(drone.id()), sortie, waits);
            charge(draft, draft.drone(drone.id()), look);
        }
    }

    private static void offPath(RunTransition draft, RunDrone drone, double meters) {
        Instant astray = drone.flags().deviatingSince();
        if (meters <= OFF_METERS) {
            if (astray != null) {
                draft.put(drone.with(drone.flags().deviatingSince(null)));
            }
        } else if (astray == null) {
            draft.put(drone.with(drone.flags().deviatingSince(draft.now())));
        } else if (Duration.between(astray, draft.now()).compareTo(OFF) >= 0) {
            causeOnce(draft, drone, RunTrigger.OFF_PATH, drone.name() + " is off its path.");
        }
    }

    /** {@code waits}: how long it stays where it is, in s; it counts as being there only after that. */
    private static void late(RunTransition draft, RunDrone drone, Sortie sortie, double waits) {
        String waypoint = drone.orders().get(0);
        Duration longest = LATE.plusSeconds(Math.round(waits));
        sortie.due(waypoint)
                .map(due -> Duration.between(due, draft.now()))
                .filter(late -> late.compareTo(longest) > 0)
                .ifPresent(late -> causeOnce(
                        draft,
                        drone,
                        RunTrigger.LATE,
                        drone.name() + " is late: it was to be at the waypoint " + waypoint + " " + late.toSeconds()
                                + " s ago."));
    }

    /** It may wait long for others to pass: what its charge does not last for is not left to wait for that. */
    static void checkWaiting(RunTransition draft, RunDrone drone, DroneObservation look) {
        boolean goesOn = drone.stage() == RunDroneStage.HOLDING
                && drone.next() == null
                && drone.sortie() != null
                && !drone.orders().isEmpty();
        if (goesOn) {
            charge(draft, drone, look);
        } else {
            checkReturnCharge(draft, drone, look);
        }
    }

    private static void charge(RunTransition draft, RunDrone drone, DroneObservation look) {
        Sortie sortie = drone.sortie();
        Place place = look.place();
        if (sortie == null || place == null || drone.next() != null) {
            return;
        }
        Double left = remaining(drone, look);
        double reserve = drone.craft().supply().reserveJoules();
        // Else no plan could be made for it that brings it home.
        boolean lasts = checkReturnCharge(draft, drone, look);
        if (lasts && left != null && left - MissionLegs.joulesToGo(sortie, drone.passed(), place) < TOUCHED * reserve) {
            causeOnce(
                    draft,
                    drone,
                    RunTrigger.LOW_BATTERY,
                    "The battery of " + drone.name() + " (" + look.batteryPercent()
                            + " %) does not last for its waypoints.");
        }
    }

    /** False: it has just been called home, while its charge lasts for that, or will be once it is where it brakes anyway. */
    static boolean checkReturnCharge(RunTransition draft, RunDrone drone, DroneObservation look) {
        Double left = remaining(drone, look);
        Place place = look.place();
        double least = TOUCHED * drone.craft().supply().reserveJoules();
        if (left == null || place == null || left - joulesHome(drone, place) >= least) {
            return true;
        }
        if (WaypointProximity.isDue(draft, drone, look)) {
            return false;
        }
        String words = "The battery of " + drone.name() + " (" + look.batteryPercent()
                + " %) lasts for its way home at most; it is called home.";
        DroneWithdrawal.callHome(draft, drone, RunTrigger.LOW_BATTERY, words);
        return false;
    }

    /** Up to its layer, home and down. */
    static double joulesHome(RunDrone drone, Place place) {
        Speeds speeds = drone.craft().performance().speeds();
        Power power = drone.craft().performance().power();
        Place home = drone.craft().finish().place();
        ReturnHeight set = drone.flags().returnHeight();
        double above = place.altitudeAmslMeters() - home.altitudeAmslMeters();
        double top = set == null ? above : Math.max(above, set.meters());
        return (top - above) / speeds.climb() * power.climb()
                + Geodesy.distanceMeters(place.point(), home.point()) / speeds.cruise() * power.cruise()
                + top / speeds.descent() * power.hover();
    }

    /** In J, by what its battery tells; null: not known, or without a limit. */
    static @Nullable Double remaining(RunDrone drone, DroneObservation look) {
        Double perPercent = drone.flags().joulesPerPercent();
        Integer percent = look.batteryPercent();
        return perPercent == null || percent == null ? null : Double.valueOf(perPercent * percent);
    }

    /** Once for each mission. */
    private static void causeOnce(RunTransition draft, RunDrone drone, RunTrigger trigger, String words) {
        RunDrone.Flags signs = drone.flags();
        if (!signs.triggers().contains(trigger)) {
            List<RunTrigger> told = new ArrayList<>(signs.triggers());
            told.add(trigger);
            draft.put(drone.with(signs.triggers(told)));
            draft.addCause(trigger, drone.id(), words);
        }
    }
}
