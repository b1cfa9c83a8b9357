package org.dronemap.core.cloud.lane;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.time.Time;

/** All lanes of this process: a drone's is found by its id; sessions not yet bound to a drone share the registry lane. */
public final class Lanes implements AutoCloseable {
    private static final int CAPACITY = 65_536;

    private final List<Lane> lanes;
    private final Lane registry;

    public Lanes(Time time, int count) {
        registry = new Lane(time, "lane-registry", CAPACITY);
        lanes = IntStream.range(0, count)
                .mapToObj(index -> new Lane(time, "lane-" + index, CAPACITY))
                .toList();
    }

    public Lane of(DroneId drone) {
        return lanes.get(Math.floorMod(drone.hashCode(), lanes.size()));
    }

    public Lane registry() {
        return registry;
    }

    /** Telemetry that all lanes refused since the start. */
    public long droppedCount() {
        return registry.droppedCount()
                + lanes.stream().mapToLong(Lane::droppedCount).sum();
    }

    /** Tasks and ticks that threw, each logged, since the start. */
    public long failedCount() {
        return all().stream().mapToLong(Lane::failedCount).sum();
    }

    /** Every lane, the registry's too. */
    public List<Lane> all() {
        return Stream.concat(Stream.of(registry), lanes.stream()).toList();
    }

    @Override
    public void close() {
        lanes.forEach(Lane::close);
        registry.close();
    }
}
