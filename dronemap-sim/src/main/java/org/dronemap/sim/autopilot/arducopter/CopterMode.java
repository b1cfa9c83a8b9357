package org.dronemap.sim.autopilot.arducopter;

import org.dronemap.sim.autopilot.ardupilot.ArduPilotMode;
import org.jspecify.annotations.Nullable;

/** The flight modes of the simulated ArduCopter with ArduCopter's custom_mode numbers. */
enum CopterMode implements ArduPilotMode {
    STABILIZE(0, false, false, true),
    ALT_HOLD(2, false, false, true),
    AUTO(3, true, true, false),
    GUIDED(4, true, true, true),
    LOITER(5, true, true, true),
    RTL(6, true, true, false),
    CIRCLE(7, true, true, false),
    LAND(9, false, false, false),
    POSHOLD(16, true, true, true),
    BRAKE(17, true, true, false),
    SMART_RTL(21, true, true, false);

    private final int number;
    private final boolean needsPosition;
    final boolean guidedFlag;
    private final boolean armable;

    CopterMode(int number, boolean needsPosition, boolean guidedFlag, boolean armable) {
        this.number = number;
        this.needsPosition = needsPosition;
        this.guidedFlag = guidedFlag;
        this.armable = armable;
    }

    static @Nullable CopterMode of(long number) {
        return ArduPilotMode.withNumber(values(), number);
    }

    @Override
    public int number() {
        return number;
    }

    @Override
    public boolean needsPosition() {
        return needsPosition;
    }

    @Override
    public boolean needsMission() {
        return this == AUTO;
    }

    @Override
    public boolean armable() {
        return armable;
    }

    /** A pilot's throttle stick decides about the height. */
    boolean followsStick() {
        return this == STABILIZE || this == ALT_HOLD || this == LOITER || this == POSHOLD || this == CIRCLE;
    }
}
