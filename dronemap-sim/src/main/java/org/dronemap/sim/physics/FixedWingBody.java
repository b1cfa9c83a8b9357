package org.dronemap.sim.physics;

/**
 * The flight physics of one simulated aeroplane: it is never slower than its wings bear, turns by banking, and rolls on
 * the ground. Owned by its vehicle.
 */
public final class FixedWingBody implements VehicleBody {
    private static final double GRAVITY = 9.80665;
    /** As of the ArduPlane that was recorded: its run, its climb with full power, and its change of speed in flight. */
    private static final double RUN_ACCELERATION = 6.9;

    private static final double CLIMB_ACCELERATION = 2.2;
    private static final double CRUISE_ACCELERATION = 0.9;
    private static final double CRUISE_DECELERATION = 0.5;
    /** So many seconds take two thirds of its speed as it rolls out. */
    private static final double ROLL_OUT_SECONDS = 2.9;

    private static final double STANDS_SPEED = 0.05;
    /** Over the ground it is faster than its airspeed says: the air is thin, as where the real one was recorded. */
    private static final double TRUE_SPEED = 1.05;

    private static final double LIFT_OFF_SPEED = 16;
    private static final double STALL_SPEED = 7;
    private static final double GLIDE_DECELERATION = 3;
    private static final double GLIDE_SINK = 1.1;
    private static final double MOST_BANK = Math.toRadians(65);
    private static final double ROLL_SECONDS = 0.4;
    private static final double VERTICAL_ACCELERATION = 5;
    private static final double THRUST_SHARE_OF_CLIMB = 0.06;

    private double north;
    private double east;
    private double up;
    private double airspeed;
    private double velocityNorth;
    private double velocityEast;
    private double velocityUp;
    private double roll;
    private double pitch;
    private double yaw;
    private double rollRate;
    private double pitchRate;
    private double yawRate;
    private double thrust;
    private double impactSpeed;

    public FixedWingBody(double yaw) {
        this.yaw = yaw;
    }

    /** Goes on from where another body is, such as one that was lifted by motors. */
    void continueFrom(VehicleBody other) {
        north = other.position().north();
        east = other.position().east();
        up = other.up();
        velocityNorth = other.velocityNorth();
        velocityEast = other.velocityEast();
        velocityUp = other.velocityUp();
        airspeed = (velocityNorth * Math.cos(other.yaw()) + velocityEast * Math.sin(other.yaw())) / TRUE_SPEED;
        roll = other.roll();
        pitch = other.pitch();
        yaw = other.yaw();
    }

    @Override
    public void step(MotionSetpoint setpoint, WindModel wind, double seconds) {
        if (setpoint instanceof MotionSetpoint.Wing wing) {
            power(wing, seconds);
        } else {
            glide(seconds);
        }
        move(wind, seconds);
        meetGround();
    }

    private void power(MotionSetpoint.Wing wing, double seconds) {
        boolean rolling = onGround();
        double gain = rolling ? RUN_ACCELERATION : wing.run() ? CLIMB_ACCELERATION : CRUISE_ACCELERATION;
        double wanted = (wing.airspeed() - airspeed) / 2;
        airspeed += Math.max(-CRUISE_DECELERATION, Math.min(gain, wanted)) * seconds;
        thrust = Math.max(0, 1 + velocityUp * THRUST_SHARE_OF_CLIMB);
        if (rolling && airspeed < LIFT_OFF_SPEED) {
            level(seconds);
            return;
        }
        airspeed = Math.max(STALL_SPEED, airspeed);
        bank(Math.atan2(wing.lateral(), GRAVITY), seconds);
        rise(wing.climb(), seconds);
    }

    private void glide(double seconds) {
        thrust = 0;
        level(seconds);
        if (onGround()) {
            airspeed *= Math.exp(-seconds / ROLL_OUT_SECONDS);
            airspeed = airspeed < STANDS_SPEED ? 0 : airspeed;
            return;
        }
        airspeed = Math.max(STALL_SPEED, airspeed - GLIDE_DECELERATION * seconds);
        rise(-GLIDE_SINK, seconds);
    }

    private void level(double seconds) {
        bank(0, seconds);
        yawRate = 0;
    }

    private void bank(double wanted, double seconds) {
        double share = 1 - Math.exp(-seconds / ROLL_SECONDS);
        rollRate = (clamp(wanted, MOST_BANK) - roll) * share / seconds;
        roll += rollRate * seconds;
        yawRate = airspeed > STALL_SPEED / 2 ? GRAVITY * Math.tan(roll) / (airspeed * TRUE_SPEED) : 0;
        yaw = Math.IEEEremainder(yaw + yawRate * seconds, 2 * Math.PI);
    }

    private void rise(double wanted, double seconds) {
        velocityUp += clamp(wanted - velocityUp, VERTICAL_ACCELERATION * seconds);
        double nose = Math.asin(clamp(velocityUp / Math.max(airspeed, STALL_SPEED), 1));
        pitchRate = (nose - pitch) / seconds;
        pitch = nose;
    }

    private void move(WindModel wind, double seconds) {
        boolean blown = !onGround();
        velocityNorth = airspeed * TRUE_SPEED * Math.cos(yaw) + (blown ? wind.north() : 0);
        velocityEast = airspeed * TRUE_SPEED * Math.sin(yaw) + (blown ? wind.east() : 0);
        north += velocityNorth * seconds;
        east += velocityEast * seconds;
        up += velocityUp * seconds;
    }

    private void meetGround() {
        if (up > 0) {
            return;
        }
        if (velocityUp < 0) {
            impactSpeed = -velocityUp;
        }
        up = 0;
        velocityUp = Math.max(0, velocityUp);
        pitch = 0;
        pitchRate = 0;
    }

    private static double clamp(double value, double limit) {
        return Math.max(-limit, Math.min(limit, value));
    }

    @Override
    public NeuPosition position() {
        return new NeuPosition(north, east, up);
    }

    /** It cannot stop: where it is. */
    @Override
    public NeuPosition stoppingPoint() {
        return position();
    }

    @Override
    public boolean onGround() {
        return up <= 0 && velocityUp <= 0;
    }

    @Override
    public double up() {
        return up;
    }

    @Override
    public double velocityNorth() {
        return velocityNorth;
    }

    @Override
    public double velocityEast() {
        return velocityEast;
    }

    @Override
    public double velocityUp() {
        return velocityUp;
    }

    @Override
    public double groundSpeed() {
        return Math.hypot(velocityNorth, velocityEast);
    }

    @Override
    public double airSpeed(WindModel wind) {
        return airspeed;
    }

    @Override
    public double roll() {
        return roll;
    }

    @Override
    public double pitch() {
        return pitch;
    }

    @Override
    public double yaw() {
        return yaw;
    }

    @Override
    public double rollRate() {
        return rollRate;
    }

    @Override
    public double pitchRate() {
        return pitchRate;
    }

    @Override
    public double yawRate() {
        return yawRate;
    }

    @Override
    public double thrust() {
        return thrust;
    }

    @Override
    public double impactSpeed() {
        return impactSpeed;
    }
}
