package org.dronemap.proxy.mavlink.procedure;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Random;
import org.dronemap.core.command.VehicleLogSink;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.LogData;
import org.dronemap.mavlink.message.LogEntry;
import org.dronemap.mavlink.message.LogRequestData;
import org.dronemap.mavlink.message.LogRequestList;

/** A vehicle's side of the log protocol that dies of being asked for logs 0 to 0, as some do. */
final class LogVehicle {
    final byte[] content;
    final int count;
    int last;
    boolean dead;
    int poured;

    LogVehicle(int bytes, int count) {
        content = new byte[bytes];
        new Random(9).nextBytes(content);
        this.count = count;
        last = count;
    }

    void take(TestWire wire, Message message) {
        if (message instanceof LogRequestList list) {
            dead |= list.start() == 0 && list.end() == 0;
            if (count == 0 && !dead) {
                wire.answer(new LogEntry(0, 0, 0, 0, 0));
            }
            for (int id = Math.max(last - count + 1, list.start()); id <= Math.min(last, list.end()) && !dead; id++) {
                wire.answer(new LogEntry(id, count, last, 1_700_000_000L + id, content.length));
            }
        } else if (message instanceof LogRequestData data && !dead) {
            pour(wire, data);
        }
    }

    private void pour(TestWire wire, LogRequestData data) {
        long end = Math.min(content.length, data.ofs() + data.count());
        for (long offset = data.ofs(); offset < end; offset += VehicleLogSink.PIECE_BYTES) {
            int length = (int) Math.min(VehicleLogSink.PIECE_BYTES, end - offset);
            int[] piece = new int[VehicleLogSink.PIECE_BYTES];
            for (int i = 0; i < length; i++) {
                piece[i] = content[(int) offset + i] & 0xFF;
            }
            poured++;
            wire.answer(new LogData(data.id(), offset, length, piece));
        }
    }

    /** Keeps a log in memory. */
    static final class Memory implements VehicleLogSink {
        final BitSet kept = new BitSet();
        byte[] content = new byte[0];
        State state = State.OPEN;
        boolean interrupted;
        /** Pieces that are turned away once. */
        final BitSet noRoomYet = new BitSet();
        /** Says later that all is safe. */
        boolean slow;

        @Override
        public BitSet kept() {
            return (BitSet) kept.clone();
        }

        @Override
        public boolean put(int piece, byte[] bytes) {
            if (noRoomYet.get(piece)) {
                noRoomYet.clear(piece);
                return false;
            }
            int start = piece * PIECE_BYTES;
            content = Arrays.copyOf(content, Math.max(content.length, start + bytes.length));
            System.arraycopy(bytes, 0, content, start, bytes.length);
            kept.set(piece);
            return true;
        }

        @Override
        public boolean complete(long sizeBytes) {
            content = Arrays.copyOf(content, (int) sizeBytes);
            state = slow ? State.OPEN : State.WRITTEN;
            return true;
        }

        @Override
        public void interrupted() {
            interrupted = true;
        }

        @Override
        public State state() {
            return state;
        }
    }
}
