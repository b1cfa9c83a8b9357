package org.dronemap.sim.robot;

/** The message ids of the server's ROSLink orders, as simulated robots know them. */
final class RobotOrderIds {
    static final int HEARTBEAT = 0;
    static final int TWIST = 100;
    static final int GO_TO = 101;
    static final int TAKE_OFF = 102;
    static final int LAND = 103;
    static final int ARM = 104;
    static final int DISARM = 105;
    static final int SET_MODE = 106;
    static final int GET_MAP = 107;
    static final int STOP = 108;

    private RobotOrderIds() {}
}
