package org.dronemap.ws.flights;

import java.util.List;
import java.util.Locale;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.ws.lab.LabDrone;

/**
 * How near vehicles come to each other in truth while both are in the air, as a share of what keeps them apart: 10 m beside, or
 * 5 m above each other.
 */
final class Separation {
    private static final double BESIDE_METERS = 10;
    private static final double ABOVE_METERS = 5;
    private static final double IN_THE_AIR_METERS = 2;

    private final List<LabDrone> drones;
    private double least = Double.POSITIVE_INFINITY;
    private String where = "nobody was in the air";

    Separation(List<LabDrone> drones) {
        this.drones = List.copyOf(drones);
    }

    void look() {
        for (int one = 0; one < drones.size(); one++) {
            for (int other = one + 1; other < drones.size(); other++) {
                look(drones.get(one), drones.get(other));
            }
        }
    }

    private void look(LabDrone one, LabDrone other) {
        if (one.height() < IN_THE_AIR_METERS || other.height() < IN_THE_AIR_METERS) {
            return;
        }
        double beside = Geodesy.distanceMeters(one.where(), other.where());
        double above = Math.abs(one.amsl() - other.amsl());
        double share = Math.max(beside / BESIDE_METERS, above / ABOVE_METERS);
        if (share < least) {
            least = share;
            where = String.format(
                    Locale.ROOT, "%s and %s: %.1f m beside, %.1f m above", one.name(), other.name(), beside, above);
        }
    }

    /** 1: just as far apart as they have to be. */
    double least() {
        return least;
    }

    String words() {
        return String.format(Locale.ROOT, "the nearest (%.2f of what keeps them apart) were %s", least, where);
    }
}
