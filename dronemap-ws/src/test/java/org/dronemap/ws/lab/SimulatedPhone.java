package org.dronemap.ws.lab;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.ReporterState;
import org.dronemap.ws.follow.FollowRequest;
import org.dronemap.ws.follow.FollowView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RejectionKind;
import org.jspecify.annotations.Nullable;

/** A phone that is followed: goes straight on, and says once a second where it is, as long as it speaks and there is a server. */
public final class SimulatedPhone {
    private static final Duration RHYTHM = Duration.ofSeconds(1);
    private static final double ACCURACY_METERS = 4;

    private final Laboratory lab;
    private final Pilot owner;
    private final LabDrone beside;
    private double north;
    private double east;
    private double northSpeed;
    private double eastSpeed;
    private long movedAtNanos;
    private boolean speaks = true;
    private @Nullable String follow;

    /** So many metres from where that drone was put down. */
    SimulatedPhone(Laboratory lab, Pilot owner, LabDrone beside, double north, double east) {
        this.lab = lab;
        this.owner = owner;
        this.beside = beside;
        this.north = north;
        this.east = east;
        var unused = lab.time().worker("phone of " + owner.name(), 1).every(RHYTHM, RHYTHM, this::say);
    }

    /** From now on, in m/s. */
    public void walks(double northward, double eastward) {
        move();
        northSpeed = northward;
        eastSpeed = eastward;
    }

    private void move() {
        double seconds = (lab.time().nanos() - movedAtNanos) / 1e9;
        north += northSpeed * seconds;
        east += eastSpeed * seconds;
        movedAtNanos = lab.time().nanos();
    }

    public Geodetic place() {
        return beside(0, 0);
    }

    /** So many metres from where it is now. */
    public Geodetic beside(double northward, double eastward) {
        move();
        return beside.place(north + northward, east + eastward);
    }

    public void isSilent() {
        speaks = false;
    }

    public void speaksAgain() {
        speaks = true;
    }

    /** Its connection shows that, as the stream would say it. */
    public void isReached(ReporterState how) {
        if (!lab.server().follows().reached(id(), how)) {
            throw new AssertionError("Nobody follows " + owner.name());
        }
    }

    /** Asks for that drone, or for the best of the warehouse. */
    public SimulatedPhone asks(@Nullable LabDrone drone, FollowRequest.PlaceRequest where, double patienceSeconds) {
        Geodetic here = place();
        follow = lab.server()
                .follows()
                .open(
                        owner.principal(),
                        new FollowRequest.OpenRequest(
                                here.latitudeDegrees(),
                                here.longitudeDegrees(),
                                null,
                                drone == null ? null : drone.id().value(),
                                where,
                                null,
                                null,
                                patienceSeconds))
                .id();
        return this;
    }

    public SimulatedPhone starts() {
        var unused = lab.server().follows().start(owner.principal(), id());
        return this;
    }

    public FollowView pauses() {
        return lab.server().follows().pause(owner.principal(), id());
    }

    public FollowView goesOn() {
        return lab.server().follows().goOn(owner.principal(), id());
    }

    public FollowView stops() {
        return lab.server().follows().stop(owner.principal(), id());
    }

    /** Waits until its follow is at that stage. */
    public SimulatedPhone awaits(String stage, Duration longest) {
        lab.untilSeen(
                owner.name() + "'s follow is " + stage,
                longest,
                () -> view().state().equals(stage));
        return this;
    }

    public FollowView view() {
        return lab.server().follows().one(owner.principal(), id());
    }

    public String id() {
        return Objects.requireNonNull(follow, "nobody was asked for");
    }

    public boolean wasTold(String words) {
        return view().told().stream().anyMatch(one -> one.words().contains(words));
    }

    private void say() {
        if (!speaks || follow == null || !lab.isUp()) {
            return;
        }
        Instant now = lab.now();
        Geodetic here = place();
        FollowRequest.PositionRequest position = new FollowRequest.PositionRequest(
                null, now, here.latitudeDegrees(), here.longitudeDegrees(), ACCURACY_METERS, null, null);
        try {
            var unused = lab.server()
                    .follows()
                    .positions(
                            owner.principal(), id(), new FollowRequest.PositionsRequest(now, null, List.of(position)));
        } catch (Rejection over) {
            if (over.kind() != RejectionKind.CONFLICT) {
                throw over;
            }
        }
    }
}
