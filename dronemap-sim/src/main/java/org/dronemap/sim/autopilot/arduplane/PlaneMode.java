package org.dronemap.sim.autopilot.arduplane;

import org.dronemap.sim.autopilot.ardupilot.ArduPilotMode;
import org.jspecify.annotations.Nullable;

/** The flight modes of the simulated ArduPlane with ArduPlane's custom_mode numbers and its own names for them. */
enum PlaneMode implements ArduPilotMode {
    MANUAL(0, Control.PILOT, true),
    CIRCLE(1, Control.ITSELF, true),
    STABILIZE(2, Control.PILOT, true),
    FLY_BY_WIRE_A(5, Control.PILOT, true),
    FLY_BY_WIRE_B(6, Control.PILOT_AT_HEIGHT, true),
    CRUISE(7, Control.PILOT_AT_HEIGHT, true),
    AUTO(10, Control.ITSELF, true),
    RTL(11, Control.ITSELF, false),
    LOITER(12, Control.ITSELF, true),
    TAKEOFF(13, Control.ITSELF, true),
    GUIDED(15, Control.ITSELF, true),
    QSTABILIZE(17, Control.LIFT, true),
    QHOVER(18, Control.LIFT, true),
    QLOITER(19, Control.LIFT, true),
    QLAND(20, Control.LIFT, false),
    QRTL(21, Control.LIFT, false);

    private enum Control {
        PILOT,
        PILOT_AT_HEIGHT,
        ITSELF,
        LIFT
    }

    private final int number;
    private final Control control;
    private final boolean armable;

    PlaneMode(int number, Control control, boolean armable) {
        this.number = number;
        this.control = control;
        this.armable = armable;
    }

    static @Nullable PlaneMode of(long number) {
        return ArduPilotMode.withNumber(values(), number);
    }

    @Override
    public int number() {
        return number;
    }

    @Override
    public boolean needsPosition() {
        return control == Control.ITSELF;
    }

    @Override
    public boolean needsMission() {
        return this == AUTO;
    }

    @Override
    public boolean armable() {
        return armable;
    }

    /** It flies on lift motors. */
    boolean lifts() {
        return control == Control.LIFT;
    }

    /** A pilot flies it, and its throttle is the pilot's. */
    boolean followsStick() {
        return control == Control.PILOT;
    }

    boolean pilotHoldsHeight() {
        return control == Control.PILOT_AT_HEIGHT;
    }

    /** The base_mode of the heartbeat while it is disarmed. */
    int baseMode() {
        boolean guided = control == Control.ITSELF || this == QRTL;
        return guided ? 89 : this == MANUAL ? 65 : 81;
    }
}
