package org.dronemap.core.cloud.rule;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.OnboardRallyPoints;
import org.dronemap.core.drone.OnboardStorage;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.core.safety.LandingSite;

/**
 * Places where one drone can land: where it stood since the server started, and its rally points. Owned by the drone's
 * lane.
 */
public final class KnownLandingSites {
    private static final int MOST = 8;
    private static final double SAME_METERS = 10;

    private final Deque<Geodetic> stood = new ArrayDeque<>(MOST);

    public void observe(DroneState state) {
        Position position = state.position();
        Geodetic here = position == null ? null : position.point();
        if (here == null || state.airborne() || !Boolean.FALSE.equals(state.armed())) {
            return;
        }
        Geodetic last = stood.peekFirst();
        if (last != null && Geodesy.distanceMeters(last, here) < SAME_METERS) {
            return;
        }
        stood.removeIf(place -> Geodesy.distanceMeters(place, here) < SAME_METERS);
        stood.addFirst(here);
        if (stood.size() > MOST) {
            stood.removeLast();
        }
    }

    public List<LandingSite> known(OnboardStorage onBoard) {
        OnboardRallyPoints rally = onBoard.rallyPoints();
        return Stream.concat(
                        stood.stream().map(place -> new LandingSite(place, "a place where it has stood before")),
                        (rally == null ? List.<RallyPoint>of() : rally.points())
                                .stream().map(point -> new LandingSite(point.point(), "a rally point of its own")))
                .toList();
    }
}
