package org.dronemap.core.virtual;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/**
 * A mission of a virtual drone split into take-off, waypoints and ending, so that drones can share it. Its waypoints
 * are what one drone may leave to the next.
 *
 * @param takeOffMeters as planned; null: to the height of the first waypoint
 * @param landsThere it lands at its last waypoint instead of returning
 */
public record VirtualTour(@Nullable Double takeOffMeters, List<MissionItem.Waypoint> waypoints, boolean landsThere) {
    private static final double LOWEST_METERS = 1;
    private static final double HIGHEST_METERS = 500;
    /** A take-off before the waypoints, an end after them. */
    private static final int MOST_WAYPOINTS = Mission.MAX_ITEMS - 2;

    public VirtualTour {
        waypoints = List.copyOf(waypoints);
    }

    /** Why a mission is none for virtual drones, as a sentence; empty when it is one. */
    public static Optional<String> fault(Mission mission) {
        List<MissionItem> items = mission.items();
        long waypoints =
                items.stream().filter(MissionItem.Waypoint.class::isInstance).count();
        if (waypoints == 0 || waypoints > MOST_WAYPOINTS) {
            return Optional.of(
                    "A virtual drone's mission has 1 to " + MOST_WAYPOINTS + " waypoints, not " + waypoints + ".");
        }
        MissionItem end = items.get(items.size() - 1);
        if (end.kind() == MissionItem.Kind.LAND && ((MissionItem.Land) end).place() != null) {
            return Optional.of("Item " + items.size()
                    + ": a virtual drone's mission lands at its last waypoint; leave the" + " landing's place out.");
        }
        for (int index = 0; index < items.size(); index++) {
            MissionItem item = items.get(index);
            if (!fits(item, index == 0, index == items.size() - 1)) {
                return Optional.of("Item " + (index + 1) + ": a take-off comes first, and landing or returning last; a"
                        + " virtual drone's mission may change drones only at waypoints, and has no tasks there.");
            }
        }
        return Optional.empty();
    }

    /** {@code mission} must have no fault. */
    public static VirtualTour of(Mission mission) {
        List<MissionItem> items = mission.items();
        MissionItem first = items.get(0);
        return new VirtualTour(
                first instanceof MissionItem.TakeOff takeOff ? takeOff.altitudeMeters() : null,
                items.stream()
                        .filter(MissionItem.Waypoint.class::isInstance)
                        .map(MissionItem.Waypoint.class::cast)
                        .toList(),
                items.get(items.size() - 1).kind() == MissionItem.Kind.LAND);
    }

    private static boolean fits(MissionItem item, boolean first, boolean last) {
        return switch (item.kind()) {
            case WAYPOINT -> true;
            case TAKE_OFF -> first;
            case LAND, RETURN_TO_LAUNCH -> last;
            case WAIT, TAKE_PHOTO, SET_SERVO, LOOK_AT, LOOK_AHEAD, OTHER -> false;
        };
    }

    /**
     * How high that drone takes off for the waypoints from this one on: null when it does not take off; empty when that
     * cannot be said, because an altitude is above the sea and its home is not known.
     */
    Optional<TakeOff> takeOff(DroneState drone, int first) {
        if (!beginsWithTakeOff(drone)) {
            return Optional.of(TakeOff.NONE);
        }
        if (takeOffMeters != null) {
            return Optional.of(new TakeOff(takeOffMeters));
        }
        Altitude altitude = waypoints.get(first).altitude();
        Home home = drone.home();
        if (altitude.reference() == Altitude.Reference.AMSL && home == null) {
            return Optional.empty();
        }
        double above = altitude.reference() == Altitude.Reference.AMSL && home != null
                ? altitude.meters() - home.altitudeAmslMeters()
                : altitude.meters();
        return Optional.of(new TakeOff(Math.min(HIGHEST_METERS, Math.max(LOWEST_METERS, above))));
    }

    /** A plane takes off by its mission alone. */
    private static boolean beginsWithTakeOff(DroneState drone) {
        return drone.capabilities().commands().contains(Capability.TAKE_OFF)
                || (drone.identification().kind() == VehicleKind.FIXED_WING
                        && drone.capabilities().missions().supports(MissionItem.Kind.TAKE_OFF));
    }

    /** Metres above home; null: none. */
    record TakeOff(@Nullable Double meters) {
        static final TakeOff NONE = new TakeOff(null);
    }

    /** What a drone is given that takes over from this waypoint on. */
    public VirtualTourSection share(int first, @Nullable Double takeOff) {
        List<MissionItem> items = new ArrayList<>();
        if (takeOff != null) {
            items.add(new MissionItem.TakeOff(takeOff));
        }
        items.addAll(waypoints.subList(first, waypoints.size()));
        items.add(landsThere ? new MissionItem.Land() : new MissionItem.ReturnToLaunch());
        return new VirtualTourSection(new Mission(items), first, takeOff == null ? 0 : 1);
    }
}
