package org.dronemap.core.conduct;

/** Result of a target report for an operation: accepted, known already, too many waiting, or not following. */
public enum TargetReportResult {
    ACCEPTED,
    /** This one or a newer one was told before. */
    DUPLICATE,
    /** Too much waits already: say it again later. */
    QUEUE_FULL,
    /** The operation is not under way, or does not go by sightings. */
    NOT_EXPECTED
}
