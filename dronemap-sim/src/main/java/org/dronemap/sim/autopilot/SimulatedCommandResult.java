package org.dronemap.sim.autopilot;

/** MAV_RESULT: how a simulated vehicle answers a command, with its number on the wire. */
public enum SimulatedCommandResult {
    ACCEPTED(0),
    TEMPORARILY_REJECTED(1),
    DENIED(2),
    UNSUPPORTED(3),
    FAILED(4),
    IN_PROGRESS(5);

    private final int number;

    SimulatedCommandResult(int number) {
        this.number = number;
    }

    public int number() {
        return number;
    }

    public static SimulatedCommandResult acceptedIf(boolean accepted) {
        return accepted ? ACCEPTED : FAILED;
    }
}
