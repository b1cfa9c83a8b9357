package org.dronemap.sim.physics;

/**
 * The flight physics of one simulated aeroplane: it is never slower than its wings bear, turns by banking, and rolls on
 * the ground. Owned by its vehicle.
 */
public final class FixedWingBody extends FlyingBody {
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

    private double airspeed;

    public FixedWingBody(double yaw) {
        super(yaw);
    }

    @Override
    void continueFrom(VehicleBody other) {
        super.continueFrom(other);
        airspeed = (velocityNorth * Math.cos(yaw) + velocityEast * Math.sin(yaw)) / TRUE_SPEED;
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
    public double airSpeed(WindModel wind) {
        return airspeed;
    }
}
