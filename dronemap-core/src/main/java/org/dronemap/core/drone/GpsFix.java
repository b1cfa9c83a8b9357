package org.dronemap.core.drone;

import org.dronemap.core.stored.Stored;

/** Quality of a satellite fix, worst first. */
@Stored(names = "NONE TWO_D THREE_D DGPS RTK_FLOAT RTK_FIXED")
public enum GpsFix {
    NONE("none"),
    TWO_D("2D"),
    THREE_D("3D"),
    DGPS("DGPS"),
    RTK_FLOAT("RTK float"),
    RTK_FIXED("RTK fixed");

    private final String label;

    GpsFix(String label) {
        this.label = label;
    }

    /** The words users know. */
    public String label() {
        return label;
    }
}
