package org.dronemap.ws.lab;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;

/** Where a vehicle truly was, ten times a second. */
public final class VehicleTrack {
    private final List<Fix> fixes = new ArrayList<>();

    /** Once, in ns of the laboratory's time. */
    public record Fix(long atNanos, Geodetic place, double amsl, double height, boolean armed) {
        /** Metres from there, height included. */
        public double metersTo(Geodetic other, double otherAmsl) {
            return Math.hypot(Geodesy.distanceMeters(place, other), amsl - otherAmsl);
        }
    }

    void add(Fix fix) {
        fixes.add(fix);
    }

    public List<Fix> since(long nanos) {
        return fixes.stream().filter(fix -> fix.atNanos() >= nanos).toList();
    }

    /** How near it came to a place, height included, in m. */
    public double nearest(Geodetic place, double amsl) {
        return fixes.stream()
                .mapToDouble(fix -> fix.metersTo(place, amsl))
                .min()
                .orElseThrow();
    }

    /** The same over the ground, from that time on. */
    public double nearestOverGround(Geodetic place, long sinceNanos) {
        return since(sinceNanos).stream()
                .mapToDouble(fix -> Geodesy.distanceMeters(fix.place(), place))
                .min()
                .orElse(Double.POSITIVE_INFINITY);
    }

    /** How far it strayed over the ground from where it was at that time, in m. */
    public double strayed(long sinceNanos) {
        List<Fix> part = since(sinceNanos);
        return part.stream()
                .mapToDouble(
                        fix -> Geodesy.distanceMeters(fix.place(), part.get(0).place()))
                .max()
                .orElseThrow();
    }
}
