package org.dronemap.core.recording;

/**
 * Settings of recordings: when flights are recorded, and how much is kept.
 *
 * @param mostBytes all recordings of the server together; the oldest go first
 * @param keepDays older ones go; 0: age does not matter
 */
public record RecordingPolicy(When when, long mostBytes, int keepDays) {
    private static final long DEFAULT_BYTES = 2_000_000_000L;

    /** Every flight, up to 2 GB. */
    public static final RecordingPolicy DEFAULT = new RecordingPolicy(When.FLIGHTS, DEFAULT_BYTES, 0);

    /** Times at which a drone is recorded: during flights, always or never. */
    public enum When {
        /** From some seconds before arming until some seconds after disarming. */
        FLIGHTS,
        /** As long as there is contact. */
        ALWAYS,
        NEVER
    }
}
