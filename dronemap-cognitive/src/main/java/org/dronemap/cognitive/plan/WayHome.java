package org.dronemap.cognitive.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.Home;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlaneHull;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.zone.AltitudeBand;

/**
 * All straight ways home of one drone of a plan: from anywhere on its tour to where the tour ends. Heights are above the
 * sea.
 *
 * @param area within which all of them lie
 * @param topMeters of its tour, or as high as vehicles fly home unasked
 * @param ceilingMeters that zones set; infinite: none
 * @param blocked heights that zones on the ways leave no room in
 */
record WayHome(
        DroneId drone, Home home, PlaneHull area, double topMeters, double ceilingMeters, List<HeightRange> blocked) {
    /** What vehicles climb to where nobody says otherwise, above their homes. */
    static final double USUAL_METERS = 15;

    /** Heights from low to high, both of them included. */
    record HeightRange(double low, double high) {
        boolean contains(double height) {
            return height >= low && height <= high;
        }
    }

    static WayHome of(Craft craft, Tour tour, List<Barrier> barriers, LocalPlane plane) {
        List<Place> places = tour.ways().stream()
                .flatMap(way -> way.fixes().stream())
                .map(TimedPlace::place)
                .toList();
        Place end = craft.finish().place();
        double top = places.stream()
                .mapToDouble(Place::altitudeAmslMeters)
                .reduce(craft.homeAmslMeters() + USUAL_METERS, Math::max);
        PlaneHull area = PlaneHull.around(Stream.concat(places.stream(), Stream.of(end))
                .map(place -> plane.spot(place.point()))
                .toList());
        double ceiling = Double.POSITIVE_INFINITY;
        List<HeightRange> blocked = new ArrayList<>();
        for (Barrier barrier : barriers) {
            HeightRange band = band(barrier, craft);
            if (!barrier.binds(craft.id())) {
                continue;
            }
            if (barrier.isKeepIn()) {
                ceiling = Math.min(ceiling, band.high());
            } else if (barrier.band().isBounded() && isOnAWay(barrier, craft, places)) {
                blocked.add(band);
                ceiling = band.high() == Double.POSITIVE_INFINITY ? Math.min(ceiling, band.low()) : ceiling;
            }
        }
        return new WayHome(
                craft.id(), new Home(end.point(), craft.homeAmslMeters()), area, top, ceiling, List.copyOf(blocked));
    }

    private static HeightRange band(Barrier barrier, Craft craft) {
        double ground = barrier.band().reference() == Altitude.Reference.HOME ? craft.homeAmslMeters() : 0;
        return new HeightRange(
                barrier.band().lowMeters() + ground, barrier.band().highMeters() + ground);
    }

    /** At whatever height. */
    private static boolean isOnAWay(Barrier barrier, Craft craft, List<Place> places) {
        Barrier column = new Barrier(barrier.words(), barrier.shape(), AltitudeBand.ALL, barrier.drones());
        BarrierCheck check = new BarrierCheck(List.of(column), craft);
        TimedPlace end = new TimedPlace(craft.finish().place(), 0);
        return places.stream()
                .anyMatch(place ->
                        check.fault(new TimedPlace(place, 0), end, false).isPresent());
    }

    /** Of the same drone. */
    boolean isSame(WayHome other) {
        return drone.equals(other.drone);
    }

    /** The lowest of whole metres above its home, which is all that some autopilots know, that is not below. */
    double wholeMeters(double amslMeters) {
        return home.altitudeAmslMeters() + Math.ceil(amslMeters - home.altitudeAmslMeters() - 1e-6);
    }

    double aboveHome(double amslMeters) {
        return amslMeters - home.altitudeAmslMeters();
    }
}
