package org.dronemap.cognitive.follow;

import java.util.List;
import java.util.SplittableRandom;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.Spot;

/** One random follow near fences and near the lowest height, over a poor network and in gusts: how near it came to either. */
final class FencedFlight {
    private static final LocalPlane PLANE = new LocalPlane(SimDrone.HOME);
    /** What guidance keeps to each fence. */
    private static final double MARGIN = 5;

    private static final double HALF = 100;
    private static final Wire.Quality POOR = new Wire.Quality(0.5, 0.2, 0.1);

    /** Metres that were left at the worst moment: to a fence, and above the lowest height; negative: it went beyond. */
    record Margins(double fenceMeters, double heightMeters) {
        boolean kept() {
            return fenceMeters > 0 && heightMeters > 0;
        }
    }

    private FencedFlight() {}

    static Margins fly(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Spot keptOut = new Spot(random.nextDouble(-60, 60), random.nextDouble(30, 60));
        Room room = Room.of(
                SimDrone.HOME,
                List.of(square(new Spot(0, 0), HALF)),
                List.of(square(keptOut, random.nextDouble(8, 15))),
                MARGIN);
        Walk walk = Walk.one(random.nextInt(4), seed);
        Side side = random.nextBoolean() ? new Side.Behind() : new Side.Fixed(random.nextDouble(360));
        double distance = random.nextDouble(3, 15);
        Trial.Noise noise = random.nextBoolean() ? Trial.Noise.PLACE : Trial.Noise.NONE;
        double wind = random.nextDouble(8);
        double begins = random.nextDouble(Trial.LOWEST_METERS + 0.5, 20);
        // Below the lowest height may be asked for; it is not flown to.
        double asked = random.nextDouble(2, 20);
        Trial.Setup setup = new Trial.Setup(
                Trial.Way.FORESEEN,
                new StandOff(side, distance, SimDrone.HOME_AMSL + asked),
                noise,
                POOR,
                wind,
                seed,
                Double.POSITIVE_INFINITY);
        double[] least = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        Trial.fly(walk, setup, new Trial.Place(room, begins), (now, here, target) -> {
            least[0] = Math.min(least[0], room.clearance(new Spot(here.east(), here.north())) + MARGIN);
            least[1] = Math.min(least[1], here.up() - Trial.LOWEST_METERS);
        });
        return new Margins(least[0], least[1]);
    }

    private static List<Geodetic> square(Spot middle, double half) {
        double east = middle.eastMeters();
        double north = middle.northMeters();
        return List.of(
                PLANE.place(new Spot(east - half, north - half)),
                PLANE.place(new Spot(east + half, north - half)),
                PLANE.place(new Spot(east + half, north + half)),
                PLANE.place(new Spot(east - half, north + half)));
    }
}
