package org.dronemap.proxy.signing;

/** Counts of one drone's frames by signature verdict since the start; all but the first were refused. */
public record FrameCounts(
        long valid, long unsigned, long badSignature, long replayed, long tooOld, long tooManyStreams) {
    public static final FrameCounts NONE = new FrameCounts(0, 0, 0, 0, 0, 0);

    public long refused() {
        return unsigned + badSignature + replayed + tooOld + tooManyStreams;
    }
}
