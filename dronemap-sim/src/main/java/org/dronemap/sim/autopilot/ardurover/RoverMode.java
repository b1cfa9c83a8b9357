package org.dronemap.sim.autopilot.ardurover;

import org.dronemap.sim.autopilot.ardupilot.ArduPilotMode;
import org.jspecify.annotations.Nullable;

/** The modes of the simulated ArduRover with ArduRover's custom_mode numbers. */
enum RoverMode implements ArduPilotMode {
    MANUAL(0, false, true, true),
    ACRO(1, false, true, true),
    STEERING(3, false, true, true),
    HOLD(4, false, false, true),
    LOITER(5, true, false, true),
    SIMPLE(7, true, false, true),
    AUTO(10, true, false, true),
    RTL(11, true, false, false),
    SMART_RTL(12, true, false, false),
    GUIDED(15, true, false, true);

    private final int number;
    private final boolean needsPosition;
    private final boolean bySticks;
    private final boolean armable;

    RoverMode(int number, boolean needsPosition, boolean bySticks, boolean armable) {
        this.number = number;
        this.needsPosition = needsPosition;
        this.bySticks = bySticks;
        this.armable = armable;
    }

    static @Nullable RoverMode of(long number) {
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

    /** The sticks drive it. */
    boolean bySticks() {
        return bySticks;
    }

    /** It drives by itself. */
    boolean byItself() {
        return needsPosition && this != SIMPLE;
    }
}
