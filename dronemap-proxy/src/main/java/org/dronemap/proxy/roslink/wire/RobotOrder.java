package org.dronemap.proxy.roslink.wire;

/** A ROSLink message from the server to a robot, never acknowledged, in metres, m/s and rad/s. Metres, m/s, rad/s. */
public sealed interface RobotOrder {
    /** The number that the wire knows it by. */
    int messageId();

    /** The cloud is there: asks for nothing, and is the same message that the robot says of itself. */
    record Heartbeat() implements RobotOrder {
        @Override
        public int messageId() {
            return 0;
        }
    }

    /** Speeds along and turns about the robot's axes; bridges stop only when told to. */
    record Twist(double vx, double vy, double vz, double wx, double wy, double wz) implements RobotOrder {
        public static final Twist STOP = new Twist(0, 0, 0, 0, 0, 0);

        @Override
        public int messageId() {
            return 100;
        }
    }

    /** Go to a place in the map's frame, or in the robot's own. */
    record GoTo(double x, double y, double z, boolean robotFrame) implements RobotOrder {
        @Override
        public int messageId() {
            return 101;
        }
    }

    record TakeOff(double altitude) implements RobotOrder {
        @Override
        public int messageId() {
            return 102;
        }
    }

    record Land() implements RobotOrder {
        @Override
        public int messageId() {
            return 103;
        }
    }

    record Arm() implements RobotOrder {
        @Override
        public int messageId() {
            return 104;
        }
    }

    record Disarm() implements RobotOrder {
        @Override
        public int messageId() {
            return 105;
        }
    }

    /** By the autopilot's own number of the mode. */
    record SetMode(int mode) implements RobotOrder {
        @Override
        public int messageId() {
            return 106;
        }
    }

    record GetMap() implements RobotOrder {
        @Override
        public int messageId() {
            return 107;
        }
    }

    record EmergencyStop() implements RobotOrder {
        @Override
        public int messageId() {
            return 108;
        }
    }
}
