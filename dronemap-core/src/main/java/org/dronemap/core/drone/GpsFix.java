package org.dronemap.core.drone;

/** Quality of a satellite fix, worst first. */
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
