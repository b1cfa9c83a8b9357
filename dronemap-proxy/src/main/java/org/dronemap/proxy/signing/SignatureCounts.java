package org.dronemap.proxy.signing;

/** Counts of one drone's received frames by signature verdict since the start; all but the valid were refused. */
public record SignatureCounts(
        long valid, long unsigned, long badSignature, long replayed, long tooOld, long tooManyStreams) {
    public static final SignatureCounts NONE = new SignatureCounts(0, 0, 0, 0, 0, 0);

    public long refused() {
        return unsigned + badSignature + replayed + tooOld + tooManyStreams;
    }
}
