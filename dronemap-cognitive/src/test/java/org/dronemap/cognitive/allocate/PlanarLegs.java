package org.dronemap.cognitive.allocate;

import org.dronemap.cognitive.cost.Legs;

/** Straight lines on a plane; each type has its speed, and east takes longer against the wind than west with it. */
final class PlanarLegs implements Legs {
    private final double[] east;
    private final double[] north;
    private final double[] speeds;
    private final double wind;

    PlanarLegs(double[] east, double[] north, double[] speeds, double wind) {
        this.east = east;
        this.north = north;
        this.speeds = speeds;
        this.wind = wind;
    }

    @Override
    public int places() {
        return east.length;
    }

    @Override
    public double eastMeters(int place) {
        return east[place];
    }

    @Override
    public double northMeters(int place) {
        return north[place];
    }

    @Override
    public double seconds(int type, int from, int to) {
        double along = east[to] - east[from];
        return meters(type, from, to) / speeds[type] + wind * Math.max(0, along);
    }

    @Override
    public double meters(int type, int from, int to) {
        return Math.hypot(east[to] - east[from], north[to] - north[from]);
    }

    @Override
    public double joules(int type, int from, int to) {
        return 2 * seconds(type, from, to) + 0.5 * meters(type, from, to);
    }
}
