package org.dronemap.ws.flights.separation;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;

/**
 * The beginning of each operation of a scenario, chosen from flights alone so that their drones meet.
 *
 * @param begins seconds after the first moment, for each operation
 * @param seconds when the last one of them meets another one
 */
record Meeting(List<Double> begins, double seconds) {
    private static final double FIRST_BEGINS = 40;
    private static final double LATEST = 80;
    private static final double STEP = 0.5;
    private static final int TENTHS = 10;
    private static final int STRIDE = 2;
    private static final double HORIZONTAL_METERS = 10;
    private static final double VERTICAL_METERS = 5;
    /** Nearer than that share of what keeps drones apart. */
    private static final double NEAR = 0.6;

    private static final int BEST = 8;
    /** From so many operations on they are in each other's ways whenever they begin. */
    private static final int MANY = 6;

    /** The nearest approach for one beginning, and for how many steps it is near. */
    private record Candidate(double begins, double share, double seconds, int near) {
        Candidate and(Candidate other) {
            Candidate nearer = other.share < share ? other : this;
            return new Candidate(begins, nearer.share, nearer.seconds, near + other.near);
        }
    }

    static Meeting of(List<Alone> alone, SplittableRandom chance) {
        List<Double> begins = new ArrayList<>(List.of(FIRST_BEGINS));
        double seconds = FIRST_BEGINS;
        for (int number = 1; number < alone.size(); number++) {
            List<Candidate> all = new ArrayList<>();
            // Each at a moment of its own: pools give out drones in the order in which missions come.
            for (double at = STEP * number / alone.size(); at < LATEST; at += STEP) {
                all.add(nearest(alone, begins, number, at));
            }
            Candidate chosen = alone.size() < MANY ? choose(all, chance) : all.get(chance.nextInt(all.size()));
            begins.add(chosen.begins());
            seconds = chosen.seconds();
        }
        return new Meeting(begins, seconds);
    }

    /** One of those with which they are near for longest: what delays somebody a little changes little then. */
    private static Candidate choose(List<Candidate> all, SplittableRandom chance) {
        List<Candidate> best = all.stream()
                .sorted(Comparator.comparing(Candidate::near).reversed().thenComparing(Candidate::share))
                .limit(BEST)
                .toList();
        return best.get(chance.nextInt(best.size()));
    }

    /** Between that operation and those whose beginnings are chosen. */
    private static Candidate nearest(List<Alone> alone, List<Double> begins, int number, double at) {
        Alone own = alone.get(number);
        Candidate least = new Candidate(at, Double.POSITIVE_INFINITY, at, 0);
        for (int other = 0; other < begins.size(); other++) {
            Shift shift = new Shift(
                    (int) Math.round((at - begins.get(other)) * TENTHS),
                    (int) Math.round(own.meetsAfter() * TENTHS),
                    (int) Math.round(alone.get(other).meetsAfter() * TENTHS));
            for (Spot[] mine : own.ways()) {
                for (Spot[] theirs : alone.get(other).ways()) {
                    least = least.and(shift.nearest(mine, theirs, at));
                }
            }
        }
        return least;
    }

    /** One way by {@code later} steps later than another one, each of which counts from some step of its own on. */
    private record Shift(int later, int from, int theirsFrom) {
        Candidate nearest(Spot[] mine, Spot[] theirs, double at) {
            double least = Double.POSITIVE_INFINITY;
            int when = 0;
            int near = 0;
            for (int step = Math.max(from, theirsFrom - later);
                    step < mine.length && step + later < theirs.length;
                    step += STRIDE) {
                Spot here = mine[step];
                Spot there = theirs[step + later];
                if (here != null && there != null) {
                    double share = share(here, there);
                    near += share < NEAR ? 1 : 0;
                    if (share < least) {
                        least = share;
                        when = step;
                    }
                }
            }
            return new Candidate(at, least, at + (double) when / TENTHS, near);
        }
    }

    /** 1: just as far apart as they have to be. */
    static double share(Spot here, Spot there) {
        double vertical = Math.abs(here.up() - there.up()) / VERTICAL_METERS;
        return Math.max(vertical, here.metersOverGroundTo(there) / HORIZONTAL_METERS);
    }
}
