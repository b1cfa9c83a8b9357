package org.dronemap.cognitive.operation.follow;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.stored.Stored;

/**
 * The state of a follow's other drones: reliefs on their way to take over, and replaced drones flying home.
 *
 * @param number which drone of the follow leads, or is this one, from 0 in the order in which they came
 * @param sent how many came after the first one
 * @param others on their way there or home, each with what it remembers by itself, and without others
 * @param failed came and did not take over
 * @param vacant the drone that leads had to leave, and another one may take over still
 * @param aloneReported it was said that none can come
 */
@Stored(names = "number sent others failed vacant alone")
public record ReliefState(
        int number, int sent, List<FollowState> others, List<DroneId> failed, boolean vacant, boolean aloneReported) {
    /** One drone, as most follows have. */
    public static final ReliefState NONE = new ReliefState(0, 0, List.of(), List.of(), false, false);

    /** More than what drones keep apart: who waits there is not pushed aside. */
    private static final double ROOM_METERS = 6;

    /** In height, beyond what drones keep apart: those of neighbouring layers do not push each other aside. */
    private static final double ROOM_IN_HEIGHT_METERS = 3;

    private static final double FARTHEST_METERS = 200;
    private static final double BESIDE_METERS = 15;

    public ReliefState {
        others = List.copyOf(others);
        failed = List.copyOf(failed);
    }

    static ReliefState ofNumber(int number) {
        return new ReliefState(number, number, List.of(), List.of(), false, false);
    }

    ReliefState with(List<FollowState> drones) {
        return new ReliefState(number, sent, drones, failed, vacant, aloneReported);
    }

    ReliefState vacant(boolean now) {
        return new ReliefState(number, sent, others, failed, now, aloneReported);
    }

    ReliefState withAloneReported() {
        return new ReliefState(number, sent, others, failed, vacant, true);
    }

    ReliefState sending(FollowState drone) {
        List<FollowState> all = new ArrayList<>(others);
        all.add(drone);
        return new ReliefState(number, drone.reliefOrNone().number(), all, failed, vacant, false);
    }

    ReliefState failing(DroneId drone) {
        List<DroneId> all = new ArrayList<>(failed);
        all.add(drone);
        return new ReliefState(number, sent, others, all, vacant, aloneReported);
    }

    /** That drone leads, with all that is known of the others. */
    ReliefState withLeader(int other, List<FollowState> drones) {
        return new ReliefState(other, sent, drones, failed, false, false);
    }

    /**
     * Where a drone waits to take over: on the same side, so much farther that two have room, and above those that follow,
     * whose ways it crosses as it comes.
     */
    static FollowOrder.RelativePlace standBy(FollowOrder.RelativePlace place, Separation apart) {
        double more = apart.horizontalMeters() + ROOM_METERS;
        double distance = place.distanceMeters() + more;
        return new FollowOrder.RelativePlace(
                place.side(),
                distance <= FARTHEST_METERS ? distance : place.distanceMeters() - more,
                place.heightMeters() + 2 * layerMeters(apart));
    }

    /** How high a drone that was replaced flies home: above those that follow, and above those that come. */
    static double homewardMeters(FollowOrder.RelativePlace place, Separation apart) {
        return place.heightMeters() + 3 * layerMeters(apart);
    }

    private static double layerMeters(Separation apart) {
        return apart.verticalMeters() + ROOM_IN_HEIGHT_METERS;
    }

    /** Metres between two drones from which on one takes over. */
    static double nearMeters(Separation apart) {
        return apart.horizontalMeters() + ROOM_METERS + BESIDE_METERS;
    }
}
