package org.dronemap.ws.flights.separation;

import java.time.Duration;
import java.util.List;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.LabVehicleLink;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.VehicleSpec;

/** Copters in a moderate wind with gusts, on links that are late and lose a little. */
final class Vehicles {
    private static final double WIND = 3;
    /** With {@code -Ddronemap.separation.noise=true} receivers and barometers err as well. */
    private static final boolean NOISE = Boolean.getBoolean("dronemap.separation.noise");

    private static final VehicleSpec CALM = VehicleSpec.COPTER.inWind(WIND);
    private static final VehicleSpec COPTER = NOISE ? CALM.withNoise() : CALM;
    private static final LabVehicleLink.Quality LINK =
            new LabVehicleLink.Quality(0.01, Duration.ofMillis(20), Duration.ofMillis(40));

    /**
     * So near a waypoint has to be passed, where vehicles know no better where they are: a copter turns for the next one 2 m
     * before it, and is seen ten times a second.
     */
    static final double SERVED_METERS = NOISE ? 6 : 2.5;

    private Vehicles() {}

    static List<LabDrone> put(Laboratory lab, List<Spot> pads) {
        List<LabDrone> drones =
                pads.stream().map(pad -> lab.add(COPTER, pad.frame())).toList();
        drones.forEach(drone -> {
            drone.wire().is(LINK);
            lab.ready(drone);
        });
        return drones;
    }

    static LabDrone put(Laboratory lab, Spot pad) {
        return put(lab, List.of(pad)).get(0);
    }
}
