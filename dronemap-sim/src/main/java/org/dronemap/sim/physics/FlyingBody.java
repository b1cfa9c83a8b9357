package org.dronemap.sim.physics;

/** The state of a simulated vehicle that flies: what its kind of lift changes, and how it is read. Owned by its vehicle. */
abstract class FlyingBody implements VehicleBody {
    protected static final double GRAVITY = 9.80665;

    protected double north;
    protected double east;
    protected double up;
    protected double velocityNorth;
    protected double velocityEast;
    protected double velocityUp;
    protected double roll;
    protected double pitch;
    protected double yaw;
    protected double rollRate;
    protected double pitchRate;
    protected double yawRate;
    protected double thrust;
    protected double impactSpeed;

    FlyingBody(double yaw) {
        this.yaw = yaw;
    }

    /** Goes on from where another body is: what was lifted by motors is borne by its wings, or the other way round. */
    void continueFrom(VehicleBody other) {
        north = other.position().north();
        east = other.position().east();
        up = other.up();
        velocityNorth = other.velocityNorth();
        velocityEast = other.velocityEast();
        velocityUp = other.velocityUp();
        roll = other.roll();
        pitch = other.pitch();
        yaw = other.yaw();
    }

    protected static double clamp(double value, double limit) {
        return Math.max(-limit, Math.min(limit, value));
    }

    @Override
    public NeuPosition position() {
        return new NeuPosition(north, east, up);
    }

    @Override
    public double groundSpeed() {
        return Math.hypot(velocityNorth, velocityEast);
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
