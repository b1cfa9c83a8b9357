package org.dronemap.cognitive.follow;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;

/** Where a person really is, twenty times a second, in metres east and north of where it begins. Immutable. */
public final class TargetPath {
    public static final double STEP_SECONDS = 0.05;
    private static final int KINDS = 6;

    private final String name;
    private final List<Point> points;
    private final double asleepFrom;
    private final double asleepUntil;

    /** A place and a velocity. */
    public record Point(double east, double north, double eastward, double northward) {}

    /**
     * How somebody moves.
     *
     * @param speed m/s
     * @param straightSeconds between two turns, at most
     * @param radiusMeters of turns; 0: on the spot
     * @param stops it stands for a while before each turn
     */
    record Habit(double speed, double straightSeconds, double radiusMeters, double acceleration, boolean stops) {}

    private TargetPath(String name, List<Point> points, double asleepFrom, double asleepUntil) {
        this.name = name;
        this.points = List.copyOf(points);
        this.asleepFrom = asleepFrom;
        this.asleepUntil = asleepUntil;
    }

    public static List<TargetPath> all(long seed) {
        return IntStream.range(0, KINDS).mapToObj(kind -> one(kind, seed)).toList();
    }

    /** The one that stands at that place in {@link #all}. */
    static TargetPath one(int kind, long seed) {
        return switch (kind) {
            case 0 -> walking(seed);
            case 1 -> running(seed);
            case 2 -> cycling(seed);
            case 3 -> stopAndGo(seed);
            case 4 -> asleep(seed);
            case 5 -> sharply(seed);
            default -> throw new IllegalArgumentException("kinds are 0 to 5: " + kind);
        };
    }

    public static TargetPath walking(long seed) {
        return made("walking", seed, 240, new Habit(1.4, 40, 1, 1, false));
    }

    public static TargetPath running(long seed) {
        return made("running", seed, 240, new Habit(4, 25, 10, 1.5, false));
    }

    public static TargetPath cycling(long seed) {
        return made("cycling", seed, 240, new Habit(8, 25, 40, 1, false));
    }

    /** Bends that ask for more than copters accelerate by. */
    public static TargetPath sharply(long seed) {
        return made("sharp bends", seed, 240, new Habit(8, 25, 25, 1, false));
    }

    public static TargetPath stopAndGo(long seed) {
        return made("stop-and-go", seed, 240, new Habit(3, 15, 3, 1.5, true));
    }

    /** Walks; the phone sleeps for half a minute in the middle. */
    public static TargetPath asleep(long seed) {
        TargetPath walk = walking(seed);
        return new TargetPath("sleep", walk.points, 100, 130);
    }

    /** From points that were recorded, each a second and a place. */
    public static TargetPath recorded(String name, List<double[]> track) {
        List<Point> points = new ArrayList<>();
        for (int leg = 0; leg + 1 < track.size(); leg++) {
            double[] from = track.get(leg);
            double[] to = track.get(leg + 1);
            double seconds = to[0] - from[0];
            double eastward = (to[1] - from[1]) / seconds;
            double northward = (to[2] - from[2]) / seconds;
            while (points.size() * STEP_SECONDS < to[0] - track.get(0)[0] - 1e-9) {
                double since = points.size() * STEP_SECONDS - (from[0] - track.get(0)[0]);
                points.add(new Point(from[1] + eastward * since, from[2] + northward * since, eastward, northward));
            }
        }
        return new TargetPath(name, points, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
    }

    private static TargetPath made(String name, long seed, double seconds, Habit habit) {
        SplittableRandom random = new SplittableRandom(seed);
        List<Point> points = new ArrayList<>();
        double course = random.nextDouble() * 2 * Math.PI;
        double speed = 0;
        double east = 0;
        double north = 0;
        double next = habit.straightSeconds() * (0.5 + random.nextDouble() / 2);
        double stands = 0;
        double turning = 0;
        for (double now = 0; now < seconds; now += STEP_SECONDS) {
            if (turning == 0 && now > next) {
                turning = (random.nextDouble() - 0.5) * Math.PI * 1.2;
                stands = habit.stops() ? now + 3 + random.nextDouble() * 5 : now;
            }
            double wanted = now < stands ? 0 : habit.speed();
            double change = habit.acceleration() * STEP_SECONDS;
            speed += Math.max(-change, Math.min(change, wanted - speed));
            if (turning != 0 && now >= stands) {
                double turn =
                        Math.signum(turning) * Math.min(Math.abs(turning), speed / habit.radiusMeters() * STEP_SECONDS);
                course += turn;
                turning = Math.abs(turning - turn) < 1e-9 ? 0 : turning - turn;
                next = now + habit.straightSeconds() * (0.5 + random.nextDouble() / 2);
            }
            points.add(new Point(east, north, speed * Math.sin(course), speed * Math.cos(course)));
            east += speed * Math.sin(course) * STEP_SECONDS;
            north += speed * Math.cos(course) * STEP_SECONDS;
        }
        return new TargetPath(name, points, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
    }

    public String name() {
        return name;
    }

    public double seconds() {
        return points.size() * STEP_SECONDS;
    }

    public Point at(double seconds) {
        return points.get(Math.max(0, Math.min(points.size() - 1, (int) Math.round(seconds / STEP_SECONDS))));
    }

    /** The phone takes no fixes. */
    boolean isAsleep(double seconds) {
        return seconds >= asleepFrom && seconds < asleepUntil;
    }
}
