package org.dronemap.core.conduct;

/** Result of delivering a target report to an operation. */
public enum TargetReportResult {
    TAKEN,
    /** This one or a newer one was told before. */
    KNOWN,
    /** Too much waits already: say it again later. */
    CROWDED,
    /** The operation is not under way, or does not go by sightings. */
    UNHEARD
}
