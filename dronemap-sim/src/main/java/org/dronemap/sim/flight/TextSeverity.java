package org.dronemap.sim.flight;

/** MAV_SEVERITY of texts that a simulated vehicle sends, with its number on the wire. */
public enum TextSeverity {
    EMERGENCY(0),
    ALERT(1),
    CRITICAL(2),
    ERROR(3),
    WARNING(4),
    NOTICE(5),
    INFO(6),
    DEBUG(7);

    private final int number;

    TextSeverity(int number) {
        this.number = number;
    }

    public int number() {
        return number;
    }
}
