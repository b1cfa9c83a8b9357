package org.dronemap.ws.flights.separation;

import java.util.List;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.VehicleTrack;

/**
 * The flight of one operation with nobody else in the air.
 *
 * @param seconds from its beginning until all are down
 * @param meetsAfter so many seconds after its beginning
 * @param ways of its drones, ten places a second from its beginning; null where a drone is not in the air
 */
record Alone(double seconds, double meetsAfter, List<Spot[]> ways) {
    private static final double AIRBORNE_METERS = 2;

    static Alone of(Party.Flight flight, long beginNanos) {
        List<LabDrone> drones = flight.drones();
        double seconds = drones.stream()
                .mapToDouble(drone -> (lastArmedNanos(drone) - beginNanos) / 1e9)
                .max()
                .orElse(0);
        List<Spot[]> ways = drones.stream().map(drone -> way(drone, beginNanos)).toList();
        return new Alone(seconds, flight.meetsAfter(), ways);
    }

    private static long lastArmedNanos(LabDrone drone) {
        return drone.track().since(0).stream()
                .filter(VehicleTrack.Fix::armed)
                .mapToLong(VehicleTrack.Fix::atNanos)
                .max()
                .orElse(0);
    }

    private static Spot[] way(LabDrone drone, long beginNanos) {
        return drone.track().since(beginNanos).stream()
                .map(fix -> fix.amsl() - drone.groundAmsl() > AIRBORNE_METERS ? Spot.of(fix.place(), fix.amsl()) : null)
                .toArray(Spot[]::new);
    }
}
