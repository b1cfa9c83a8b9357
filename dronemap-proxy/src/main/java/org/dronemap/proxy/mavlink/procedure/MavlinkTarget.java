package org.dronemap.proxy.mavlink.procedure;

import java.util.function.Consumer;
import java.util.function.Supplier;
import org.dronemap.mavlink.Message;

/**
 * The MAVLink vehicle that exchanges are sent to: its ids, send path, round trip time and command send times.
 *
 * @param way gives how long its answers take on the link that is in use now
 * @param ledger which commands crossed the wire when
 */
public record MavlinkTarget(
        int systemId,
        int componentId,
        Consumer<Message> down,
        Supplier<RoundTripEstimator> way,
        CommandSendTimes ledger) {
    /** The cloud's own system id: what autopilots expect of their ground station. */
    public static final int OWN_SYSTEM_ID = 255;

    /** MAV_COMP_ID_MISSIONPLANNER. */
    public static final int OWN_COMPONENT_ID = 190;

    /** Somebody of whom nothing is known yet. */
    public MavlinkTarget(int systemId, int componentId, Consumer<Message> down) {
        this(systemId, componentId, down, new RoundTripEstimator());
    }

    private MavlinkTarget(int systemId, int componentId, Consumer<Message> down, RoundTripEstimator always) {
        this(systemId, componentId, down, () -> always, new CommandSendTimes());
    }

    /** How long its answers take now. */
    RoundTripEstimator roundTrip() {
        return way.get();
    }

    /** The same, spoken to another way. */
    public MavlinkTarget through(Consumer<Message> newDown) {
        return new MavlinkTarget(systemId, componentId, newDown, way, ledger);
    }

    public void send(Message message) {
        down.accept(message);
    }

    /** False for an answer that is addressed to somebody else; 0 is everybody. */
    public static boolean isForUs(int targetSystem) {
        return targetSystem == 0 || targetSystem == OWN_SYSTEM_ID;
    }
}
