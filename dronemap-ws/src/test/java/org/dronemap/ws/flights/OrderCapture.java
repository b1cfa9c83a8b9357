package org.dronemap.ws.flights;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.dronemap.ws.lab.LabVehicleLink;

/**
 * Reads what comes out at a vehicle's socket by the layout of MAVLink frames alone, with no code of the server's, and keeps
 * what orders something: a vehicle that somebody else flies must get none of that.
 */
final class OrderCapture implements LabVehicleLink.Capture {
    private static final int FIRST_OF_2 = 0xFD;
    private static final int FIRST_OF_1 = 0xFE;
    private static final int COMMAND_INT = 75;
    private static final int COMMAND_LONG = 76;
    /** SET_MODE, PARAM_SET, mission items and counts, setpoints, sticks, SETUP_SIGNING. */
    private static final Set<Integer> ORDERS = Set.of(11, 23, 38, 39, 41, 44, 45, 69, 70, 73, 84, 86, 82, 139, 256);
    /** REQUEST_MESSAGE, SET_MESSAGE_INTERVAL, requests of capabilities and of the home: they only ask. */
    private static final Set<Integer> QUESTIONS = Set.of(410, 510, 511, 512, 519, 520, 521);

    private static final int HEARTBEAT = 0;

    private final List<Order> orders = new ArrayList<>();
    private long heartbeats;
    private long lastHeartbeatNanos;

    /** {@code command}: its MAV_CMD; 0 where it has none. */
    record Order(long nanos, int message, int command) {}

    @Override
    public void told(long nanos, byte[] bytes) {
        int at = 0;
        while (at < bytes.length) {
            int first = bytes[at] & 0xFF;
            boolean second = first == FIRST_OF_2;
            if (!second && first != FIRST_OF_1) {
                at++;
                continue;
            }
            int length = bytes[at + 1] & 0xFF;
            int header = second ? 10 : 6;
            int message = second
                    ? (bytes[at + 7] & 0xFF) | (bytes[at + 8] & 0xFF) << 8 | (bytes[at + 9] & 0xFF) << 16
                    : bytes[at + 5] & 0xFF;
            judge(nanos, message, bytes, at + header, length);
            boolean signed = second && (bytes[at + 2] & 1) != 0;
            at += header + length + 2 + (signed ? 13 : 0);
        }
    }

    private void judge(long nanos, int message, byte[] bytes, int payload, int length) {
        if (message == HEARTBEAT) {
            heartbeats++;
            lastHeartbeatNanos = nanos;
        } else if (message == COMMAND_LONG || message == COMMAND_INT) {
            // Seven floats, or four floats, two integers and a float, stand before the number; zeros at the end are cut
            // off.
            int command = at(bytes, payload, length, 28) | at(bytes, payload, length, 29) << 8;
            if (!QUESTIONS.contains(command)) {
                orders.add(new Order(nanos, message, command));
            }
        } else if (ORDERS.contains(message)) {
            orders.add(new Order(nanos, message, 0));
        }
    }

    private static int at(byte[] bytes, int payload, int length, int offset) {
        return offset < length ? bytes[payload + offset] & 0xFF : 0;
    }

    /** After that moment. */
    List<Order> ordersAfter(long nanos) {
        return orders.stream().filter(order -> order.nanos() > nanos).toList();
    }

    long heartbeats() {
        return heartbeats;
    }

    long lastHeartbeatNanos() {
        return lastHeartbeatNanos;
    }
}
