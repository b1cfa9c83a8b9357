package org.dronemap.proxy.outlet.client;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.dronemap.core.access.OutletSystemId;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * The MAVLink system ids under which each outlet user's ground stations see drones: stable, the vehicle's own if free.
 * Owned by the outlet's thread.
 */
public final class OutletSystemIdRegistry {
    /** Above these ground stations number themselves. */
    static final int HIGHEST = 239;
    /** What a drone is called for a program that calls itself like it. */
    static final int SPARE = 240;

    private final Map<String, Map<DroneId, Integer>> users = new HashMap<>();
    private final Consumer<OutletSystemId> onNew;

    /** {@code onNew} sees to it that a number is kept. */
    public OutletSystemIdRegistry(List<OutletSystemId> kept, Consumer<OutletSystemId> onNew) {
        this.onNew = onNew;
        kept.forEach(number -> numbers(number.user()).put(number.drone(), number.systemId()));
    }

    private Map<DroneId, Integer> numbers(String user) {
        return users.computeIfAbsent(user, first -> new HashMap<>());
    }

    /** Empty when the user sees more drones than there are numbers. */
    OptionalInt of(String user, DroneId drone, int vehiclesOwn) {
        Map<DroneId, Integer> numbers = numbers(user);
        Integer known = numbers.get(drone);
        if (known != null) {
            return OptionalInt.of(known);
        }
        OptionalInt free = IntStream.concat(IntStream.of(vehiclesOwn), IntStream.rangeClosed(1, HIGHEST))
                .filter(number -> number >= 1 && number <= HIGHEST && !numbers.containsValue(number))
                .findFirst();
        free.ifPresent(number -> {
            numbers.put(drone, number);
            onNew.accept(new OutletSystemId(user, drone, number));
        });
        return free;
    }

    /** Null when the user's programs know no drone by that number. */
    @Nullable
    DroneId drone(String user, int number) {
        return numbers(user).entrySet().stream()
                .filter(entry -> entry.getValue() == number)
                .map(Map.Entry::getKey)
                .findFirst()
                .orElse(null);
    }

    /** The drone is gone; its numbers are free. */
    public void forget(DroneId drone) {
        users.values().forEach(numbers -> numbers.remove(drone));
    }
}
