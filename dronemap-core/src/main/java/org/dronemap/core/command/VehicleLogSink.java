package org.dronemap.core.command;

import java.util.BitSet;

/**
 * Receives a vehicle's on-board log piece by piece while it is downloaded; called on the drone's lane. Returns at once;
 * called on the drone's lane.
 */
public interface VehicleLogSink {
    /** Bytes of one piece; only the last may be shorter. */
    int PIECE_BYTES = 90;

    /** Pieces that an earlier attempt left behind. */
    BitSet kept();

    /** False when there was no room at the moment: the piece has to be fetched again. */
    boolean put(int piece, byte[] bytes);

    /** All is there; the log has that many bytes. False when there was no room for that word: say it again. */
    boolean complete(long sizeBytes);

    /** No more comes; what is there is kept for the next attempt. */
    void interrupted();

    /** How far the writing is. */
    State state();

    /** State of the writing of a log: open, completely written or failed. */
    enum State {
        OPEN,
        /** The whole log is safe. */
        WRITTEN,
        /** It cannot be kept. */
        FAILED
    }
}
