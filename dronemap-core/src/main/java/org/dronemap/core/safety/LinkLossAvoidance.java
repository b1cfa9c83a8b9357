package org.dronemap.core.safety;

import java.util.Optional;
import org.dronemap.core.command.ChangeSpeed;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkTrend;
import org.jspecify.annotations.Nullable;

/**
 * State machine of what is done about one flying drone's link that is expected to be lost: tried once, then home; each
 * once, whatever the link does meanwhile. Sends nothing; owned by the drone's lane.
 */
public final class LinkLossAvoidance {
    /** What was tried shows within so long. */
    private static final double TRY_SECONDS = 15;
    /** A link that gets no worse and no better for so long is not helped. */
    private static final double LONGEST_TRY_SECONDS = 60;
    /** Whose link falls again so soon after a try is not helped by another one. */
    private static final double TRIED_SECONDS = 300;

    private Stage stage = Stage.WATCHING;
    private double sinceSeconds;
    private double triedSeconds = Double.NEGATIVE_INFINITY;
    private boolean mission;
    private @Nullable Double speed;

    /** Holder of a drone: that decides who acts. */
    public enum Holder {
        /** A user who has control. */
        USER,
        /** A pilot at the vehicle, or another ground station. */
        OTHERS,
        /** An operation, which acts by itself. */
        OPERATION,
        /** Nobody: it flies a mission or waits, as this cloud told it. */
        NOBODY
    }

    private enum Stage {
        WATCHING,
        WARNED,
        CLIMBED,
        SLOWED,
        RETURNING
    }

    /** The next act; empty: none. {@code inMission}: it flies by a mission now; {@code seconds}: by any clock. */
    public Optional<LinkAct> next(
            DroneState drone, Holder holder, boolean inMission, double seconds, LinkActPlanner.WayCheck zones) {
        LinkTrend trend = drone.link().trend();
        if (holder == Holder.OPERATION) {
            rest();
            return Optional.empty();
        }
        if (holder != Holder.NOBODY) {
            return warn(trend, holder, seconds);
        }
        return switch (stage) {
            case WATCHING, WARNED ->
                trend.isFalling() ? begin(drone, inMission, seconds, zones) : watch(trend, seconds);
            case CLIMBED, SLOWED -> tried(trend, seconds);
            case RETURNING -> watch(trend, seconds);
        };
    }

    /** It is down, or somebody else brings it down. */
    public void rest() {
        stage = Stage.WATCHING;
        mission = false;
        speed = null;
    }

    /** It is to be brought home, by whatever way there is. */
    public boolean returns() {
        return stage == Stage.RETURNING;
    }

    /** It was told something that has to show yet whether it helps. */
    public boolean tries() {
        return stage == Stage.CLIMBED || stage == Stage.SLOWED;
    }

    private Optional<LinkAct> warn(LinkTrend trend, Holder holder, double seconds) {
        if (stage != Stage.WARNED && trend.isFalling()) {
            to(Stage.WARNED, seconds);
            return Optional.of(LinkAct.warn(trend.words()
                    + (holder == Holder.USER
                            ? " Let it return home, or bring it nearer or higher, while it can be told."
                            : " Whoever flies it should bring it nearer or higher.")));
        }
        if (stage != Stage.WARNED) {
            rest();
            return Optional.empty();
        }
        return watch(trend, seconds);
    }

    /** Only a link that is as usual again ends what is said or done about it. */
    private Optional<LinkAct> watch(LinkTrend trend, double seconds) {
        if (stage != Stage.RETURNING && trend.state() == LinkTrend.State.STEADY) {
            to(Stage.WATCHING, seconds);
        }
        return Optional.empty();
    }

    private Optional<LinkAct> begin(
            DroneState drone, boolean inMission, double seconds, LinkActPlanner.WayCheck zones) {
        LinkAct act = seconds - triedSeconds < TRIED_SECONDS
                ? LinkAct.comeHome(drone.link().trend().words() + " It comes home: what was tried before did not last.")
                : LinkActPlanner.first(drone, inMission, zones);
        mission = inMission;
        speed = LinkActPlanner.speed(drone);
        to(
                switch (act.kind()) {
                    case CLIMB -> Stage.CLIMBED;
                    case SLOW_DOWN -> Stage.SLOWED;
                    case WARN, RETURN, GO_ON -> Stage.RETURNING;
                },
                seconds);
        return Optional.of(act);
    }

    private Optional<LinkAct> tried(LinkTrend trend, double seconds) {
        double since = seconds - sinceSeconds;
        triedSeconds = seconds;
        String what = stage == Stage.CLIMBED ? "climbed" : "slowed down";
        if (trend.state() == LinkTrend.State.STEADY) {
            return Optional.of(goOn(what, seconds));
        }
        boolean falls = trend.isFalling() && trend.secondsLeft() != null && since >= TRY_SECONDS;
        boolean unknown = trend.state() == LinkTrend.State.UNKNOWN;
        if (!falls && since < LONGEST_TRY_SECONDS && !unknown) {
            return Optional.empty();
        }
        to(Stage.RETURNING, seconds);
        return Optional.of(
                LinkAct.comeHome(trend.words() + " It has " + what + ", which did not help; it comes home."));
    }

    private LinkAct goOn(String what, double seconds) {
        boolean climbed = stage == Stage.CLIMBED;
        Double before = speed;
        Command with = null;
        String then = ".";
        if (climbed && mission) {
            // What it does without the cloud is its owner's choice, which the vehicle has kept.
            with = new Command.StartMission(null);
            then = ", and it goes on with its mission.";
        } else if (!climbed && before != null && before >= ChangeSpeed.SLOWEST) {
            with = new ChangeSpeed(before);
            then = ", and it goes on as fast as before.";
        }
        to(Stage.WATCHING, seconds);
        return LinkAct.goOn(with, "Its link is as usual again since it has " + what + then);
    }

    private void to(Stage next, double seconds) {
        stage = next;
        sinceSeconds = seconds;
    }
}
