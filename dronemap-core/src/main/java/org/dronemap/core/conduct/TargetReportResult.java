package org.dronemap.core.conduct;

/** Whether an operation took a target report, or why not: known already, too many waiting, or not following. */
public enum TargetReportResult {
    TAKEN,
    /** This one or a newer one was told before. */
    KNOWN,
    /** Too much waits already: say it again later. */
    CROWDED,
    /** The operation is not under way, or does not go by sightings. */
    UNHEARD
}
