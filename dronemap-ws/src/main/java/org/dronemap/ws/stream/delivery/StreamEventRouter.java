package org.dronemap.ws.stream.delivery;

import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.ControlState;

/**
 * Listens to the cloud manager, and passes changes of drones, commands and control to the stream topics. Heard on
 * lanes; rounds belong to the pump.
 */
public final class StreamEventRouter implements CloudListener {
    private static final long MOVES_GAP_NANOS = 250_000_000L;

    private final List<Consumer<DroneState>> onChange = new CopyOnWriteArrayList<>();
    private final List<Consumer<DroneId>> onRemoval = new CopyOnWriteArrayList<>();
    private final List<Consumer<CommandRecord>> onCommand = new CopyOnWriteArrayList<>();
    private final List<Consumer<ControlEvent>> onControl = new CopyOnWriteArrayList<>();
    private final List<Consumer<Set<DroneId>>> onMoves = new CopyOnWriteArrayList<>();
    private final Set<DroneId> moved = ConcurrentHashMap.newKeySet();
    // Owned by the pump.
    private long movesNanos = System.nanoTime();

    /** Event that control of a drone has changed, with its new state. */
    public record ControlEvent(DroneId drone, ControlState now, ControlChange change) {}

    public void onChange(Consumer<DroneState> topic) {
        onChange.add(topic);
    }

    public void onRemoval(Consumer<DroneId> topic) {
        onRemoval.add(topic);
    }

    public void onCommand(Consumer<CommandRecord> topic) {
        onCommand.add(topic);
    }

    public void onControl(Consumer<ControlEvent> topic) {
        onControl.add(topic);
    }

    /** Told in rounds, four times a second at most: for what moves with the drones that serve it. */
    public void onMoves(Consumer<Set<DroneId>> topic) {
        onMoves.add(topic);
    }

    @Override
    public void droneChanged(DroneState state) {
        moved.add(state.id());
        onChange.forEach(topic -> topic.accept(state));
    }

    @Override
    public void droneRemoved(DroneId id) {
        onRemoval.forEach(topic -> topic.accept(id));
    }

    @Override
    public void commandChanged(CommandRecord command) {
        onCommand.forEach(topic -> topic.accept(command));
    }

    @Override
    public void controlChanged(DroneId drone, ControlState now, ControlChange change) {
        ControlEvent news = new ControlEvent(drone, now, change);
        onControl.forEach(topic -> topic.accept(news));
    }

    public void round(long nowNanos) {
        if (nowNanos - movesNanos < MOVES_GAP_NANOS || moved.isEmpty()) {
            return;
        }
        movesNanos = nowNanos;
        Set<DroneId> drones = Set.copyOf(moved);
        moved.removeAll(drones);
        onMoves.forEach(topic -> topic.accept(drones));
    }
}
