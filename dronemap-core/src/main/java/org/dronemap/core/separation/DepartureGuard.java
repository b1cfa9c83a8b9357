package org.dronemap.core.separation;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/** Lets drones set off only where that is clear: from the ground, from a stand in the air, and after they gave way. */
final class DepartureGuard {
    /** Within that nobody sets off who still rolls: where it comes to stand is not known. */
    private static final double ROLLS_METERS = 40;
    /** m/s over the ground: whoever is slower stands. */
    private static final double STANDS_SPEED = 2;
    /** From the decision until it rises. */
    private static final int STRIDES_TO_ARM = 6;
    /** From the decision until it sets off from its stand. */
    private static final int STRIDES_TO_GO = 3;
    /** The share of the distance that two who fly by their plans may come to. */
    private static final double AS_PLANNED = 0.7;

    private static final Duration LONGEST_YIELD = Duration.ofSeconds(15);
    /** Two that stand and wait for each other: then one of them makes way. */
    private static final Duration LONGEST_STANDOFF = Duration.ofSeconds(4);

    private static final Duration LONGEST_ARMING = Duration.ofSeconds(20);
    /** One that may go on from its stand, and does not, has to ask again. */
    private static final Duration LONGEST_GOING = Duration.ofSeconds(8);

    private static final double OVER_METERS = 6;
    private static final double OVER_SECONDS = 5;
    /** Over its home nobody climbs from here to make room. */
    private static final double HIGHEST_OVER_METERS = 80;

    /**
     * On the ground: where no moment is found by then at which its whole flight is clear, it sets off. So long, and a share of how
     * long it flies.
     */
    private static final double LONGEST_PROOF_SECONDS = 20;

    private static final double LONGEST_PROOF_SHARE = 0.25;
    /** The same for one that flies on when nobody keeps it apart from others any more. */
    private static final double LONGEST_ALONE_SECONDS = 600;

    /** The same in the air, since it began to give way. */
    private static final Duration LONGEST_STAND = Duration.ofSeconds(40);

    private static final Duration LONGEST_STAND_ALONE = Duration.ofMinutes(2);

    private final SeparationRound round;
    private final FlightProof proof;
    /** Who sets off now, or is about to: nobody else sets off into their way. */
    private final Map<DroneId, List<Track>> departing = new HashMap<>();

    DepartureGuard(SeparationRound round) {
        this.round = round;
        this.proof = new FlightProof(round);
    }

    void check() {
        // Who has set off already, or may in this moment, comes first.
        round.picture.drones().stream().filter(this::isSettingOff).forEach(this::goesNext);
        round.picture.drones().stream()
                .filter(DepartureGuard::rises)
                .forEach(drone -> risesNext(drone, this::straightUp));
        List<TrackedDrone> grounded = round.picture.drones().stream()
                .filter(drone -> drone.step() == FlightIntent.Step.RISE && !rises(drone))
                .toList();
        grounded.stream().filter(this::wasLetGo).forEach(drone -> risesNext(drone, this::up));
        grounded.forEach(this::checkTakeOff);
        round.picture.drones().stream().filter(DepartureGuard::isAboutToGoOn).forEach(this::checkDeparture);
        round.picture.drones().stream()
                .filter(drone -> round.yielding(drone) != null)
                .sorted(Comparator.comparing(drone -> !isSettingOff(drone)))
                .forEach(this::checkHold);
    }

    private void goesNext(TrackedDrone drone) {
        TrackSample here = round.far.here(drone);
        if (here != null && drone.waits() && drone.state().airborne()) {
            goesNext(drone, way(drone, here));
        }
    }

    private void goesNext(TrackedDrone drone, Track way) {
        departing.put(drone.id(), List.of(way, way.after(STRIDES_TO_GO)));
        proof.counts(drone, goesHome(drone) ? FlightProof.Way.HOME : FlightProof.Way.MISSION);
    }

    private Track way(TrackedDrone drone, TrackSample here) {
        return goesHome(drone) ? round.far.homeward(drone, here) : round.far.mission(drone, here);
    }

    private boolean isSettingOff(TrackedDrone drone) {
        Yielding own = round.yielding(drone);
        boolean isToldTo = drone.step() == FlightIntent.Step.GO_ON && drone.isCommanded();
        return isToldTo || (own != null && mayGo(own));
    }

    private boolean mayGo(Yielding own) {
        return own.give().clear() && own.wasLetGoWithin(LONGEST_GOING, round.picture.now());
    }

    /** It is armed for its mission, and not in the air yet as far as it says itself. */
    private static boolean rises(TrackedDrone drone) {
        return (drone.step() == FlightIntent.Step.RISE || drone.step() == FlightIntent.Step.FLY)
                && Boolean.TRUE.equals(drone.state().armed())
                && !drone.state().airborne();
    }

    /** Nobody takes off into the way of one who is in the air, or takes off beside it at the same time. */
    private void checkTakeOff(TrackedDrone drone) {
        TrackSample here = round.far.here(drone);
        if (here == null || drone.state().airborne()) {
            return;
        }
        List<Track> up = up(drone, here);
        Optional<TrackedDrone> above = others(drone)
                .filter(other -> ways(other).stream()
                        .anyMatch(way -> up.stream().anyMatch(mine -> isInTheWay(drone, mine, way, other))))
                .findFirst()
                .or(() -> unproved(drone, here));
        above.ifPresentOrElse(other -> waitFor(drone, other), () -> letGo(drone));
    }

    private void letGo(TrackedDrone drone) {
        Instant now = round.picture.now();
        round.yielding.compute(drone.id(), (id, own) -> own == null ? Yielding.toNobody(drone, now) : own.mayGoOn(now));
        if (isUnderWay(drone)) {
            risesNext(drone, this::up);
        }
    }

    private void risesNext(TrackedDrone drone, BiFunction<TrackedDrone, TrackSample, List<Track>> ways) {
        TrackSample here = round.far.here(drone);
        if (here != null) {
            departing.put(drone.id(), ways.apply(drone, here));
            proof.counts(drone, FlightProof.Way.MISSION);
        }
    }

    private List<Track> straightUp(TrackedDrone drone, TrackSample here) {
        return List.of(round.far.mission(drone, here));
    }

    /** However long it takes to arm it. */
    private List<Track> up(TrackedDrone drone, TrackSample here) {
        Track at = round.far.mission(drone, here);
        return List.of(at, at.after(STRIDES_TO_ARM), at.after(2 * STRIDES_TO_ARM));
    }

    /** In an earlier round: it may be armed in this moment. One that waits is in nobody's way, whatever it is told. */
    private boolean wasLetGo(TrackedDrone drone) {
        Yielding own = round.yielding(drone);
        return (own == null ? drone.isCommanded() : own.mayRise()) && isUnderWay(drone);
    }

    /** On the ground a drone waits for free, but not for ever: in the air it is kept apart as well. */
    private Optional<TrackedDrone> unproved(TrackedDrone drone, TrackSample here) {
        FlightIntent intent = drone.intent();
        Yielding own = round.yielding(drone);
        boolean told = own != null && own.mayRise() && own.isSettingOff(round.picture.now());
        if (intent == null || intent.commanded() || told) {
            return Optional.empty();
        }
        double usual = LONGEST_PROOF_SECONDS + LONGEST_PROOF_SHARE * round.far.missionSeconds(drone, here);
        double longest = intent.goesOnAlone() ? Math.max(usual, LONGEST_ALONE_SECONDS) : usual;
        double waited = Duration.between(intent.since(), round.picture.now()).toMillis() / 1e3;
        return waited < longest ? proof.meets(drone, here, FlightProof.Way.MISSION) : Optional.empty();
    }

    /** One that cannot be armed yet does not keep those beside it on the ground for ever. */
    private boolean isUnderWay(TrackedDrone drone) {
        Yielding own = round.yielding(drone);
        return drone.isCommanded() || (own != null && own.wasLetGoWithin(LONGEST_ARMING, round.picture.now()));
    }

    private List<Track> ways(TrackedDrone other) {
        List<Track> all = new ArrayList<>(round.far(other));
        all.addAll(departing.getOrDefault(other.id(), List.of()));
        return all;
    }

    private void waitFor(TrackedDrone drone, TrackedDrone other) {
        Yielding own = round.yielding(drone);
        if (own == null || !own.to().equals(other.id()) || own.give().clear()) {
            round.put(drone, round.give(other, GiveWay.Manner.WAIT, null));
        }
    }

    /** Who flies by the same plan was planned for: no room is left beside the least distance. */
    private boolean isInTheWay(TrackedDrone drone, Track mine, Track way, TrackedDrone other) {
        boolean flies = other.step() == FlightIntent.Step.FLY || other.step() == FlightIntent.Step.GO_ON;
        boolean planned = flies && SeparationRound.isPlannedTogether(drone, other);
        return mine.clearance(way, round.least(drone, other)) < (planned ? AS_PLANNED : 1);
    }

    private static boolean isAboutToGoOn(TrackedDrone drone) {
        return drone.step() == FlightIntent.Step.GO_ON
                && !drone.isCommanded()
                && drone.state().airborne()
                && drone.waits();
    }

    /** With a new mission it does not fly into the way of one who is not where plans take it to be. */
    private void checkDeparture(TrackedDrone drone) {
        TrackSample here = round.far.here(drone);
        Yielding own = round.yielding(drone);
        if (here == null || (own != null && own.isOrdered())) {
            return;
        }
        Track mine = round.far.mission(drone, here);
        Optional<TrackedDrone> other = others(drone)
                .filter(one -> round.far(one).stream()
                        .anyMatch(way -> isInTheWay(drone, mine, way, one)
                                || (rolls(drone) && isNear(mine, way, round.least(drone, one)))))
                .findFirst()
                .or(() -> unprovedToGo(drone, here));
        other.ifPresentOrElse(one -> waitFor(drone, one), () -> {
            round.yielding.remove(drone.id());
            goesNext(drone, mine);
        });
    }

    private Optional<TrackedDrone> unprovedToGo(TrackedDrone drone, TrackSample here) {
        FlightIntent intent = drone.intent();
        boolean lasts = intent == null
                || Duration.between(intent.since(), round.picture.now()).compareTo(longestStand(drone)) > 0;
        return lasts ? Optional.empty() : proof.meets(drone, here, FlightProof.Way.MISSION);
    }

    private Stream<TrackedDrone> others(TrackedDrone drone) {
        return round.picture.drones().stream()
                .filter(other -> !other.id().equals(drone.id()) && !round.areFar(drone, other));
    }

    private static boolean rolls(TrackedDrone drone) {
        return drone.waits() && drone.speed() > STANDS_SPEED;
    }

    private static boolean isNear(Track mine, Track way, Separation least) {
        return mine.beginsNear(way, ROLLS_METERS, least);
    }

    /** Who gave way in the air may go on when all is clear. */
    private void checkHold(TrackedDrone drone) {
        Yielding own = round.yielding(drone);
        TrackSample here = round.far.here(drone);
        if (own == null || here == null) {
            return;
        }
        if (!own.isOrdered()) {
            boolean wants = drone.step() == FlightIntent.Step.RISE || drone.step() == FlightIntent.Step.GO_ON;
            if (!wants) {
                round.yielding.remove(drone.id());
            }
        } else if (drone.waits() && !drone.isCommanded() && !own.isBusy(round.picture.now())) {
            checkStand(drone, here, own);
        }
    }

    private void checkStand(TrackedDrone drone, TrackSample here, Yielding own) {
        if (own.give().clear() && !mayGo(own)) {
            // Others first.
            round.yielding.put(drone.id(), own.mayNotGoOn());
            return;
        }
        boolean home = goesHome(drone);
        Track mine = way(drone, here);
        boolean free = isClear(drone, mine, home || !rolls(drone));
        boolean clear = free && isProved(drone, here, own, home);
        Yielding next = clear ? own.mayGoOn(round.picture.now()) : own.mayNotGoOn();
        round.yielding.put(drone.id(), next);
        if (clear) {
            goesNext(drone, mine);
            return;
        }
        if (free) {
            return;
        }
        Duration lasting = own.lasting(round.picture.now());
        if (lasting.compareTo(LONGEST_STANDOFF) > 0) {
            new WayMaking(round).makeWay(drone, mine);
        }
        if (home && lasting.compareTo(LONGEST_YIELD) > 0) {
            climbOver(drone, here, own);
        }
    }

    /** Who was told already that it may go on stays told. */
    private boolean isProved(TrackedDrone drone, TrackSample here, Yielding own, boolean home) {
        Instant now = round.picture.now();
        return mayGo(own)
                || own.lasting(now).compareTo(longestStand(drone)) > 0
                || proof.meets(drone, here, home ? FlightProof.Way.HOME : FlightProof.Way.MISSION)
                        .isEmpty();
    }

    private static Duration longestStand(TrackedDrone drone) {
        FlightIntent intent = drone.intent();
        return intent != null && intent.goesOnAlone() ? LONGEST_STAND_ALONE : LONGEST_STAND;
    }

    private boolean isClear(TrackedDrone drone, Track mine, boolean mayRoll) {
        return others(drone).allMatch(other -> {
            Separation least = round.least(drone, other);
            return ways(other).stream()
                    .allMatch(way -> mine.isPassable(way, least) && (mayRoll || !isNear(mine, way, least)));
        });
    }

    private static boolean goesHome(TrackedDrone drone) {
        FlightIntent.@Nullable Step step = drone.step();
        return step == FlightIntent.Step.COME_HOME || drone.ahead().isEmpty();
    }

    /** Whoever is on its way home comes over those who do not pass. */
    private void climbOver(TrackedDrone drone, TrackSample here, Yielding own) {
        TrackSample higher = new TrackSample(here.spot(), here.low() + OVER_METERS);
        boolean low = here.low() - drone.homeAmslMeters().orElse(here.low()) < HIGHEST_OVER_METERS;
        boolean may = low
                && drone.hovers()
                && drone.canGoTo()
                && drone.handling() == Handling.COMMANDED
                && !isWaitedForByEarlier(drone, own)
                && round.mayGo(drone, higher);
        if (may) {
            String words = String.format(Locale.ROOT, "climbs %.0f m", OVER_METERS);
            round.command(
                    drone,
                    new GiveWay(own.to(), own.give().toName(), GiveWay.Manner.MOVE, round.picture.now(), false, words),
                    OVER_SECONDS,
                    round.goTo(higher),
                    drone.name() + " climbs to come home over those who do not pass.");
        }
    }

    /** Of two who wait for each other one moves. */
    private boolean isWaitedForByEarlier(TrackedDrone drone, Yielding own) {
        Yielding others = round.yielding.get(own.to());
        return others != null
                && others.to().equals(drone.id())
                && own.to().value().compareTo(drone.id().value()) < 0;
    }
}
