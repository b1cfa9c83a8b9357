package org.dronemap.sim.physics;

/**
 * The motion of one simulated ground vehicle that steers with its front wheels: it turns only while it rolls, and never
 * leaves the ground. Owned by its vehicle.
 */
public final class GroundBody implements VehicleBody {
    private static final double GRAVITY = 9.80665;
    private static final double ACCELERATION = 1.1;
    /** How it plans to slow down before it comes to a place. */
    private static final double DECELERATION = 0.65;
    /** How quickly a command can brake it. */
    private static final double BRAKING = 1.1;
    /** With the motor off it loses so much of its speed a second. */
    private static final double ROLLING_OUT = 0.55;

    private static final double SMALLEST_RADIUS = 0.9;
    private static final double MOST_SIDEWARD = 0.6 * GRAVITY;
    private static final double MOST_TURN = Math.toRadians(60);
    private static final double STEERING_GAIN = 1.2;
    private static final double SPEED_IN_TURN = 1.5;
    private static final double STRAIGHT = Math.toRadians(20);
    private static final double BEHIND = Math.toRadians(60);
    private static final double STANDING = 0.05;
    private static final double NEAR_METERS = 0.2;

    private double north;
    private double east;
    private double speed;
    private double acceleration;
    private double yaw;
    private double yawRate;

    public GroundBody(double yaw) {
        this.yaw = yaw;
    }

    @Override
    public void step(MotionSetpoint setpoint, WindModel wind, double seconds) {
        if (setpoint instanceof MotionSetpoint.Reach reach) {
            reach(reach.target(), reach.horizontalSpeed(), seconds);
        } else if (setpoint instanceof MotionSetpoint.Track track) {
            reach(track.place().target(), track.place().horizontalSpeed(), seconds);
        } else if (setpoint instanceof MotionSetpoint.Velocity velocity) {
            double wanted = Math.hypot(velocity.north(), velocity.east());
            if (wanted < STANDING) {
                change(0, seconds);
                turn(0, seconds);
            } else {
                steer(Math.atan2(velocity.east(), velocity.north()), wanted, seconds);
            }
        } else {
            rollOut(seconds);
        }
        north += speed * Math.cos(yaw) * seconds;
        east += speed * Math.sin(yaw) * seconds;
    }

    private void reach(NeuPosition target, double horizontalSpeed, double seconds) {
        double distance = position().horizontalDistanceTo(target);
        if (distance < NEAR_METERS) {
            change(0, seconds);
            turn(0, seconds);
            return;
        }
        double slowing = Math.sqrt(2 * DECELERATION * distance);
        steer(position().bearingTo(target), Math.min(horizontalSpeed, slowing), seconds);
    }

    private void rollOut(double seconds) {
        double kept = speed * Math.exp(-ROLLING_OUT * seconds);
        acceleration = (kept - speed) / seconds;
        speed = kept;
        turn(0, seconds);
    }

    /** Slow while it has to turn, but never standing: a standing one cannot turn. For what is behind it brakes first. */
    private void steer(double bearing, double wanted, double seconds) {
        double error = Math.IEEEremainder(bearing - yaw, 2 * Math.PI);
        double size = Math.abs(error);
        change(size > STRAIGHT ? Math.min(wanted, SPEED_IN_TURN) : wanted, seconds);
        boolean tooQuick = size > BEHIND && speed > SPEED_IN_TURN + STANDING;
        turn(tooQuick ? 0 : error * STEERING_GAIN, seconds);
    }

    private void change(double wanted, double seconds) {
        double change = Math.max(-BRAKING * seconds, Math.min(ACCELERATION * seconds, wanted - speed));
        acceleration = change / seconds;
        speed += change;
    }

    private void turn(double wantedRate, double seconds) {
        double rolling = Math.abs(speed);
        double limit = Math.min(MOST_TURN, Math.min(rolling / SMALLEST_RADIUS, MOST_SIDEWARD / Math.max(rolling, 0.1)));
        yawRate = clamp(wantedRate, limit);
        yaw = Math.IEEEremainder(yaw + yawRate * seconds, 2 * Math.PI);
    }

    private static double clamp(double value, double limit) {
        return Math.max(-limit, Math.min(limit, value));
    }

    @Override
    public NeuPosition position() {
        return new NeuPosition(north, east, 0);
    }

    @Override
    public NeuPosition stoppingPoint() {
        double distance = speed * speed / (2 * BRAKING);
        return new NeuPosition(north + distance * Math.cos(yaw), east + distance * Math.sin(yaw), 0);
    }

    @Override
    public boolean onGround() {
        return true;
    }

    @Override
    public double up() {
        return 0;
    }

    @Override
    public double velocityNorth() {
        return speed * Math.cos(yaw);
    }

    @Override
    public double velocityEast() {
        return speed * Math.sin(yaw);
    }

    @Override
    public double velocityUp() {
        return 0;
    }

    @Override
    public double groundSpeed() {
        return Math.abs(speed);
    }

    @Override
    public double airSpeed(WindModel wind) {
        return groundSpeed();
    }

    @Override
    public double roll() {
        return 0;
    }

    @Override
    public double pitch() {
        return 0;
    }

    @Override
    public double yaw() {
        return yaw;
    }

    @Override
    public double rollRate() {
        return 0;
    }

    @Override
    public double pitchRate() {
        return 0;
    }

    @Override
    public double yawRate() {
        return yawRate;
    }

    @Override
    public double thrust() {
        return Math.abs(speed) / 10 + Math.max(0, acceleration) / 5;
    }

    @Override
    public double impactSpeed() {
        return 0;
    }
}
