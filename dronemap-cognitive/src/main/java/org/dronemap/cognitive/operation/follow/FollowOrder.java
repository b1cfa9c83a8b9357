package org.dronemap.cognitive.operation.follow;

import org.dronemap.cognitive.follow.StandOffSide;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.ChosenDrone;
import org.dronemap.core.stored.Stored;

/**
 * The order that a follow begins with: drone, place beside the phone, speed, and how long to wait for positions.
 *
 * @param near where the phone was when it asked
 * @param patienceSeconds without positions, before it flies home
 */
@Stored(names = "chosen near place speed patienceSeconds")
public record FollowOrder(ChosenDrone chosen, Geodetic near, RelativePlace place, double speed, int patienceSeconds) {
    /** Lower than this nobody is followed: metres above the drone's home. */
    public static final double LOWEST_METERS = 5;

    public static final double HIGHEST_METERS = 120;

    /**
     * The place of the drone relative to the phone.
     *
     * @param heightMeters above its home
     */
    @Stored(names = "side distanceMeters heightMeters")
    public record RelativePlace(StandOffSide side, double distanceMeters, double heightMeters) {}

    FollowOrder by(ChosenDrone other) {
        return new FollowOrder(other, near, place, speed, patienceSeconds);
    }

    FollowOrder at(RelativePlace other) {
        return new FollowOrder(chosen, near, other, speed, patienceSeconds);
    }
}
