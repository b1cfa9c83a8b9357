package org.dronemap.cognitive.operation.run.model;

import java.time.Instant;
import java.util.List;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.ReturnHeight;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * The state of one drone in a mission run: stage, waypoints to visit, mission on board and command under way.
 *
 * @param since when it came to this stage
 * @param orders the waypoints that it is to visit, in order, without those that it has visited
 * @param sortie what it has on board and flies; null: nothing yet
 * @param passed how many items of that are behind it
 * @param next what it is to get in its place
 * @param issuedCommand the command that is under way
 * @param attempts how it went with the present step
 * @param note why it is not flying its waypoints, as a sentence
 * @param flags what has been noticed of it and may pass
 */
@Stored(names = "kin stage since orders sortie passed next errand tries note signs")
public record RunDrone(
        Profile profile,
        RunDroneStage stage,
        Instant since,
        List<String> orders,
        @Nullable Sortie sortie,
        int passed,
        @Nullable Sortie next,
        @Nullable IssuedCommand issuedCommand,
        Attempts attempts,
        @Nullable String note,
        Flags flags) {
    /**
     * The profile of a drone, which does not change during the run.
     *
     * @param craft as planned with first; where it is when something is planned anew is looked at then
     * @param returnMeters how high over its home it flies home, in a layer of its own; null: as the vehicle is set
     */
    @Stored(names = "craft name kind returnMeters")
    public record Profile(
            Craft craft,
            String name,
            VehicleKind kind,
            @Nullable Double returnMeters) {
        /** Else it drives or swims, and is never in the air. */
        public boolean flies() {
            return switch (kind) {
                case ROVER, BOAT, SUBMARINE -> false;
                case MULTICOPTER, HELICOPTER, FIXED_WING, VTOL, AIRSHIP, UNKNOWN -> true;
            };
        }

        public Profile with(Craft other) {
            return new Profile(other, name, kind, returnMeters);
        }

        public Profile withoutLayer() {
            return new Profile(craft, name, kind, null);
        }
    }

    /**
     * A command that it was given.
     *
     * @param sortie the number of the one that it brings; 0: none
     */
    @Stored(names = "command kind sortie at")
    public record IssuedCommand(CommandId command, Purpose kind, int sortie, Instant at) {
        /** The purpose of the command. */
        @Stored(names = "UPLOAD MODE ARM START HOLD HEIGHT DODGE HOME DISARM")
        public enum Purpose {
            UPLOAD,
            MODE,
            ARM,
            START,
            HOLD,
            /** Sets how high it flies home, or puts that back. */
            HEIGHT,
            /** Out of another drone's way. */
            DODGE,
            HOME,
            DISARM
        }
    }

    /**
     * The failed attempts at the present step.
     *
     * @param failed how many in a row, without those that are waited for
     * @param notBefore there is none before that
     * @param refusedSince the first that was refused in a way that may pass; null: none was
     */
    @Stored(names = "failed notBefore refusedSince", later = "refusedSince")
    public record Attempts(
            int failed,
            @Nullable Instant notBefore,
            @Nullable Instant refusedSince) {
        public static final Attempts NONE = new Attempts(0, null);

        public Attempts(int failed, @Nullable Instant notBefore) {
            this(failed, notBefore, null);
        }
    }

    /**
     * Flags and timers of a drone that outlast its stage.
     *
     * @param held control of it was seen since it came to the run, or was resumed
     * @param begun it has been seen on the mission that it has on board, so that what it tells of it counts
     * @param fallingSince since when it falls, or leans as nothing that flies does
     * @param deviatingSince since when it is off its path
     * @param linkLoss what it may still do while it is not heard
     * @param waitsFor for which drone it waits
     * @param triggers what was said of its present mission already
     * @param joulesPerPercent what a hundredth of its battery holds; null: not known
     * @param returnHeight how high it flies home for the run, and what has to be put back; null: as it is set
     */
    @Stored(names = "held begun falling astray silence yields told joulesPerPercent homeward")
    public record Flags(
            boolean held,
            boolean begun,
            @Nullable Instant fallingSince,
            @Nullable Instant deviatingSince,
            @Nullable LinkLoss linkLoss,
            @Nullable DroneId waitsFor,
            List<RunTrigger> triggers,
            @Nullable Double joulesPerPercent,
            @Nullable ReturnHeight returnHeight) {
        public static final Flags NONE = new Flags(false, false, null, null, null, null, List.of(), null, null);

        public Flags {
            triggers = List.copyOf(triggers);
        }

        public Flags held(boolean now) {
            return new Flags(
                    now,
                    begun,
                    fallingSince,
                    deviatingSince,
                    linkLoss,
                    waitsFor,
                    triggers,
                    joulesPerPercent,
                    returnHeight);
        }

        public Flags begun(boolean now) {
            return new Flags(
                    held,
                    now,
                    fallingSince,
                    deviatingSince,
                    linkLoss,
                    waitsFor,
                    triggers,
                    joulesPerPercent,
                    returnHeight);
        }

        public Flags fallingSince(@Nullable Instant from) {
            return new Flags(
                    held, begun, from, deviatingSince, linkLoss, waitsFor, triggers, joulesPerPercent, returnHeight);
        }

        public Flags deviatingSince(@Nullable Instant from) {
            return new Flags(
                    held, begun, fallingSince, from, linkLoss, waitsFor, triggers, joulesPerPercent, returnHeight);
        }

        public Flags withLinkLoss(@Nullable LinkLoss what) {
            return new Flags(
                    held,
                    begun,
                    fallingSince,
                    deviatingSince,
                    what,
                    waitsFor,
                    triggers,
                    joulesPerPercent,
                    returnHeight);
        }

        public Flags waitsFor(@Nullable DroneId other) {
            return new Flags(
                    held,
                    begun,
                    fallingSince,
                    deviatingSince,
                    linkLoss,
                    other,
                    triggers,
                    joulesPerPercent,
                    returnHeight);
        }

        public Flags triggers(List<RunTrigger> all) {
            return new Flags(
                    held, begun, fallingSince, deviatingSince, linkLoss, waitsFor, all, joulesPerPercent, returnHeight);
        }

        public Flags joulesPerPercent(double joules) {
            return new Flags(
                    held, begun, fallingSince, deviatingSince, linkLoss, waitsFor, triggers, joules, returnHeight);
        }

        public Flags returnHeight(@Nullable ReturnHeight now) {
            return new Flags(
                    held, begun, fallingSince, deviatingSince, linkLoss, waitsFor, triggers, joulesPerPercent, now);
        }
    }

    /**
     * A drone that is not heard.
     *
     * @param lastContact when it was, last
     * @param place where it was then
     * @param flew it flew its mission then, or was about to; else it waited in the air or was on its way home
     * @param reservedUntil till then its next waypoints stay its own
     * @param flyingUntil till then it may be in the air
     */
    @Stored(names = "heard place flew reservedUntil flyingUntil")
    public record LinkLoss(
            Instant lastContact, @Nullable Place place, boolean flew, Instant reservedUntil, Instant flyingUntil) {}

    public RunDrone {
        orders = List.copyOf(orders);
    }

    public static RunDrone joining(Profile kin, Instant now) {
        return new RunDrone(
                kin, RunDroneStage.LANDED, now, List.of(), null, 0, null, null, Attempts.NONE, null, Flags.NONE);
    }

    public DroneId id() {
        return profile.craft().id();
    }

    public String name() {
        return profile.name();
    }

    public Craft craft() {
        return profile.craft();
    }

    /** What it will have been given last. */
    @Nullable
    public Sortie latest() {
        return next == null ? sortie : next;
    }

    /** A new step begins; what kept it from its waypoints is not said of one that is on its way to them. */
    public RunDrone to(RunDroneStage step, Instant now) {
        Flags seen = step == RunDroneStage.FLYING ? flags.begun(true) : flags;
        String why = switch (step) {
            case UPLOADING, STARTING, FLYING -> null;
            default -> note;
        };
        return new RunDrone(profile, step, now, orders, sortie, passed, next, null, Attempts.NONE, why, seen);
    }

    public RunDrone with(Profile other) {
        return new RunDrone(other, stage, since, orders, sortie, passed, next, issuedCommand, attempts, note, flags);
    }

    public RunDrone noted(@Nullable String why) {
        return new RunDrone(profile, stage, since, orders, sortie, passed, next, issuedCommand, attempts, why, flags);
    }

    public RunDrone withOrders(List<String> waypoints) {
        return new RunDrone(
                profile, stage, since, waypoints, sortie, passed, next, issuedCommand, attempts, note, flags);
    }

    public RunDrone withSortie(@Nullable Sortie what, int behind) {
        return new RunDrone(profile, stage, since, orders, what, behind, next, issuedCommand, attempts, note, flags);
    }

    public RunDrone withNext(@Nullable Sortie later) {
        return new RunDrone(profile, stage, since, orders, sortie, passed, later, issuedCommand, attempts, note, flags);
    }

    public RunDrone withIssuedCommand(@Nullable IssuedCommand what) {
        return new RunDrone(profile, stage, since, orders, sortie, passed, next, what, attempts, note, flags);
    }

    public RunDrone tried(Attempts now) {
        return new RunDrone(profile, stage, since, orders, sortie, passed, next, null, now, note, flags);
    }

    /** It does nothing else until then. */
    public RunDrone busy(Instant until) {
        return new RunDrone(
                profile,
                stage,
                since,
                orders,
                sortie,
                passed,
                next,
                issuedCommand,
                new Attempts(attempts.failed(), until),
                note,
                flags);
    }

    public RunDrone with(Flags other) {
        return new RunDrone(profile, stage, since, orders, sortie, passed, next, issuedCommand, attempts, note, other);
    }
}
