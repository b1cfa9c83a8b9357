package org.dronemap.proxy.roslink.wire;

import java.util.HashMap;
import java.util.Map;

/**
 * Finds duplicates and gaps in the sequence numbers of the messages from one robot over one link. Old bridges number
 * all messages in one row, newer ones each kind of message for itself, round and round; which it is shows in the first
 * numbers. Not thread-safe.
 */
public final class RobotSequenceTracker {
    /** A number further away than this says that the counting began anew. */
    private static final long NEAR = 64;
    /** So many kinds of messages are kept apart at most. */
    private static final int MOST_ROWS = 32;
    /** So many numbers that fit only one way of counting settle the matter. */
    private static final int SURE = 3;
    /** So many copies in a row are none: the robot counts anew, or not at all. */
    private static final int MOST_COPIES = 3;

    private final Row all = new Row();
    private final Map<Integer, Row> rows = new HashMap<>();
    private int inOneRow;
    private int inRowsOfTheirOwn;
    private long received;
    private long doubled;

    /** One count upwards. */
    private static final class Row {
        private boolean begun;
        private long newest;
        /** Bit i: the number {@code newest - i} came. */
        private long came;

        private long lost;
        private int copies;

        /** It is the neighbour of one that came, on whichever side: one of two links may always be ahead. */
        boolean fits(long number) {
            return !has(number) && (has(number - 1) || has(number + 1));
        }

        boolean has(long number) {
            long back = newest - number;
            return begun && back >= 0 && back < NEAR && (came >>> back & 1) == 1;
        }

        boolean isCopy(long number) {
            if (!has(number)) {
                copies = 0;
                return false;
            }
            if (copies < MOST_COPIES) {
                copies++;
                return true;
            }
            begun = false;
            return false;
        }

        void count(long number) {
            long ahead = number - newest;
            if (!begun || Math.abs(ahead) >= NEAR) {
                begun = true;
                newest = number;
                // Nobody waits for what was sent before.
                came = 1;
            } else if (ahead > 0) {
                lost += ahead - 1;
                came = came << ahead | 1;
                newest = number;
            } else if (!has(number)) {
                came |= 1L << -ahead;
                lost = Math.max(0, lost - 1);
            }
        }
    }

    /** False for a copy of a message that came already. */
    public boolean isNew(RoslinkHeader header) {
        Long number = header.sequence();
        if (number == null) {
            received++;
            return true;
        }
        Row own = rows.get(header.messageId());
        if (own == null && rows.size() < MOST_ROWS) {
            own = new Row();
            rows.put(header.messageId(), own);
        }
        if (own != null && own.isCopy(number)) {
            doubled++;
            return false;
        }
        boolean fitsAll = all.fits(number);
        boolean fitsOwn = own != null && own.fits(number);
        if (fitsAll != fitsOwn) {
            inOneRow = fitsAll ? Math.min(inOneRow + 1, SURE) : Math.max(0, inOneRow - 1);
            inRowsOfTheirOwn = fitsOwn ? Math.min(inRowsOfTheirOwn + 1, SURE) : Math.max(0, inRowsOfTheirOwn - 1);
        }
        all.count(number);
        if (own != null) {
            own.count(number);
        }
        received++;
        return true;
    }

    /** Messages that came, each once. */
    public long received() {
        return received;
    }

    /** Copies of messages that had come already. */
    public long doubled() {
        return doubled;
    }

    /** Messages that are missing, by the way of counting that fits better; 0 until one does. */
    public long lost() {
        if (inRowsOfTheirOwn == SURE && inOneRow < SURE) {
            return rows.values().stream().mapToLong(row -> row.lost).sum();
        }
        return inOneRow == SURE || rows.size() <= 1 ? all.lost : 0;
    }
}
