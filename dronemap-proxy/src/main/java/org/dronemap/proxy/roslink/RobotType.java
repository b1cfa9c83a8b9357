package org.dronemap.proxy.roslink;

import org.dronemap.core.drone.VehicleKind;
import org.jspecify.annotations.Nullable;

/** The type of a ROSLink robot, by the number in its heartbeat. */
enum RobotType {
    GENERIC(0, "robot", VehicleKind.UNKNOWN, Dialect.NONE),
    FIXED_WING(1, "fixed wing", VehicleKind.FIXED_WING, Dialect.MAVROS),
    /** Not in the protocol's list, but in a launch file of its drone. */
    GAPTER(2, "Gapter", VehicleKind.MULTICOPTER, Dialect.MAVROS),
    QUADROTOR(3, "quadrotor", VehicleKind.MULTICOPTER, Dialect.MAVROS),
    COAXIAL(4, "coaxial helicopter", VehicleKind.HELICOPTER, Dialect.MAVROS),
    HELICOPTER(5, "helicopter", VehicleKind.HELICOPTER, Dialect.MAVROS),
    HEXAROTOR(6, "hexarotor", VehicleKind.MULTICOPTER, Dialect.MAVROS),
    TURTLEBOT(8, "TurtleBot", VehicleKind.ROVER, Dialect.WHEELS),
    PARROT(9, "AR.Drone", VehicleKind.MULTICOPTER, Dialect.AR_DRONE),
    BEBOP(10, "Bebop", VehicleKind.MULTICOPTER, Dialect.AR_DRONE),
    ERLE_COPTER(11, "Erle-Copter", VehicleKind.MULTICOPTER, Dialect.MAVROS),
    RIA_E100(12, "RIA E100", VehicleKind.ROVER, Dialect.WHEELS);

    private final int number;
    private final String label;
    private final VehicleKind kind;
    private final Dialect words;

    /** The dialect of a robot's bridge: how it reports state and height, and which orders it takes. */
    enum Dialect {
        /** Nothing is known of them. */
        NONE,
        /** A ground robot: its z is a yaw. */
        WHEELS,
        /** A flight controller behind mavros: modes of ArduCopter, its z the height above its start. */
        MAVROS,
        /** Flies by itself and knows no arming, its z the height above its start. */
        AR_DRONE;

        boolean flies() {
            return this == MAVROS || this == AR_DRONE;
        }
    }

    RobotType(int number, String label, VehicleKind kind, Dialect words) {
        this.number = number;
        this.label = label;
        this.kind = kind;
        this.words = words;
    }

    /** A type that is not in the list is some robot. */
    static RobotType of(@Nullable Integer number) {
        for (RobotType type : values()) {
            if (number != null && type.number == number) {
                return type;
            }
        }
        return GENERIC;
    }

    /** As users know it. */
    String label() {
        return label;
    }

    VehicleKind kind() {
        return kind;
    }

    Dialect words() {
        return words;
    }
}
