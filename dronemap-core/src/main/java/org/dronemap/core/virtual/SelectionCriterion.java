package org.dronemap.core.virtual;

import java.util.Locale;
import org.dronemap.core.stored.Stored;

/** Criteria by which candidate drones are compared, in order: distance, battery left, link loss, id. */
@Stored(names = "DISTANCE BATTERY_LEFT LINK_LOSS ORDER")
public enum SelectionCriterion {
    /** Metres from where it stands to the first waypoint, in steps of 50. */
    DISTANCE("%.0f m from the first waypoint"),
    /** Per cent of the battery after the mission, in steps of 5. */
    BATTERY_LEFT("%.0f %% of the battery left after the mission"),
    /** Per cent of its messages that were lost, whole ones; 100 when that is not known. */
    LINK_LOSS("%.0f %% of its messages lost"),
    /** Its place in the order of ids, where all else is alike. */
    ORDER("number %.0f in the order of ids, all else alike");

    private final String form;

    SelectionCriterion(String form) {
        this.form = form;
    }

    String words(double value) {
        return String.format(Locale.ROOT, form, value);
    }
}
