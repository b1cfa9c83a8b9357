package org.dronemap.sim.autopilot;

import java.util.Random;
import java.util.function.Consumer;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.LogData;
import org.dronemap.mavlink.message.LogEntry;
import org.dronemap.mavlink.message.LogRequestData;
import org.dronemap.mavlink.message.LogRequestList;

/**
 * A simulated vehicle's side of log transfer: two logs with constant bytes for each system id. A list or a piece goes
 * out a bit at a time, as from a real one; asking for 0 to 0 is answered with nothing.
 */
final class LogProtocol {
    private static final int PIECE = 90;
    private static final int PIECES_PER_STEP = 20;
    private static final int[] SIZES = {12_345, 100_000};
    private static final long WRITTEN_AT = 1_700_000_000L;

    private final int systemId;
    private final Consumer<Message> out;
    private int pouring = -1;
    private long offset;
    private long until;

    LogProtocol(int systemId, Consumer<Message> out) {
        this.systemId = systemId;
        this.out = out;
    }

    void list(LogRequestList request) {
        for (int id = Math.max(1, request.start()); id <= Math.min(SIZES.length, request.end()); id++) {
            out.accept(new LogEntry(id, SIZES.length, SIZES.length, WRITTEN_AT + id, SIZES[id - 1]));
        }
    }

    void sendBlock(LogRequestData request) {
        if (request.id() >= 1 && request.id() <= SIZES.length && request.ofs() < SIZES[request.id() - 1]) {
            pouring = request.id();
            offset = request.ofs();
            until = Math.min(SIZES[request.id() - 1], request.ofs() + request.count());
        }
    }

    void stop() {
        pouring = -1;
    }

    void step() {
        byte[] content = pouring > 0 ? content(pouring) : new byte[0];
        for (int i = 0; i < PIECES_PER_STEP && pouring > 0; i++) {
            int count = (int) Math.min(PIECE, until - offset);
            int[] piece = new int[PIECE];
            for (int at = 0; at < count; at++) {
                piece[at] = content[(int) offset + at] & 0xFF;
            }
            out.accept(new LogData(pouring, offset, count, piece));
            offset += count;
            if (offset >= until) {
                pouring = -1;
            }
        }
    }

    /** Made anew each time: vehicles are many, and logs are fetched seldom. */
    private byte[] content(int id) {
        byte[] content = new byte[SIZES[id - 1]];
        new Random(systemId * 1_000L + id).nextBytes(content);
        return content;
    }
}
