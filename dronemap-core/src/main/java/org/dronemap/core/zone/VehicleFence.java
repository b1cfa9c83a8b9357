package org.dronemap.core.zone;

import java.time.Instant;
import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.FenceArea;

/**
 * Part of the zones that a vehicle can keep as its own fence: areas without floor and ceiling.
 *
 * @param leftOut those with a floor or a ceiling, which the fences of vehicles do not know
 */
public record VehicleFence(List<FenceArea> shapes, List<Zone> leftOut) {
    public static VehicleFence of(ZoneRegistry book, DroneId drone, Instant now) {
        // Nobody's name is empty: zones for one user stay out.
        List<Zone> binding = book.binding("", drone, now, now);
        return new VehicleFence(
                binding.stream()
                        .filter(zone -> !zone.band().isBounded())
                        .map(Zone::shape)
                        .toList(),
                binding.stream().filter(zone -> zone.band().isBounded()).toList());
    }
}
