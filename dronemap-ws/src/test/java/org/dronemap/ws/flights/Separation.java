package org.dronemap.ws.flights;

import java.util.List;
import java.util.Locale;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.ws.lab.LabDrone;

/** How near vehicles come to each other in truth while both are in the air: metres straight through space. */
final class Separation {
    private static final double IN_THE_AIR_METERS = 2;

    private final List<LabDrone> drones;
    private double least = Double.POSITIVE_INFINITY;
    private String where = "";

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
        double meters = Math.hypot(Geodesy.distanceMeters(one.where(), other.where()), one.amsl() - other.amsl());
        if (meters < least) {
            least = meters;
            where = String.format(
                    Locale.ROOT,
                    "%s %.0f m up and %s %.0f m up",
                    one.name(),
                    one.height(),
                    other.name(),
                    other.height());
        }
    }

    double leastMeters() {
        return least;
    }

    String words() {
        return String.format(Locale.ROOT, "the nearest were %.1f m apart: %s", least, where);
    }
}
