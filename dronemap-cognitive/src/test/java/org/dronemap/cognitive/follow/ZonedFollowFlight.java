package org.dronemap.cognitive.follow;

import java.util.List;
import java.util.SplittableRandom;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;

/** One random follow near fences and near the lowest height, over a poor network and in gusts: how near it came to either. */
final class ZonedFollowFlight {
    private static final LocalPlane PLANE = new LocalPlane(SimDrone.HOME);
    /** What guidance keeps to each fence. */
    private static final double MARGIN = 5;

    private static final double HALF = 100;
    private static final SimulatedLink.Quality POOR = new SimulatedLink.Quality(0.5, 0.2, 0.1);

    /** Metres that were left at the worst moment: to a fence, and above the lowest height; negative: it went beyond. */
    record Margins(double fenceMeters, double heightMeters) {
        boolean kept() {
            return fenceMeters > 0 && heightMeters > 0;
        }
    }

    private ZonedFollowFlight() {}

    static Margins fly(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        PlanePoint keptOut = new PlanePoint(random.nextDouble(-60, 60), random.nextDouble(30, 60));
        FlyableArea room = FlyableArea.of(
                SimDrone.HOME,
                List.of(square(new PlanePoint(0, 0), HALF)),
                List.of(square(keptOut, random.nextDouble(8, 15))),
                MARGIN);
        TargetPath walk = TargetPath.one(random.nextInt(4), seed);
        StandOffSide side =
                random.nextBoolean() ? new StandOffSide.Behind() : new StandOffSide.Fixed(random.nextDouble(360));
        double distance = random.nextDouble(3, 15);
        FollowTrial.Noise noise = random.nextBoolean() ? FollowTrial.Noise.PLACE : FollowTrial.Noise.NONE;
        double wind = random.nextDouble(8);
        double begins = random.nextDouble(FollowTrial.LOWEST_METERS + 0.5, 20);
        // Below the lowest height may be asked for; it is not flown to.
        double asked = random.nextDouble(2, 20);
        FollowTrial.Setup setup = new FollowTrial.Setup(
                FollowTrial.Way.FORESEEN,
                new StandOff(side, distance, SimDrone.HOME_AMSL + asked),
                noise,
                POOR,
                wind,
                seed,
                Double.POSITIVE_INFINITY);
        double[] least = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        FollowTrial.fly(walk, setup, new FollowTrial.Site(room, begins), (now, here, target) -> {
            least[0] = Math.min(least[0], room.clearance(new PlanePoint(here.east(), here.north())) + MARGIN);
            least[1] = Math.min(least[1], here.up() - FollowTrial.LOWEST_METERS);
        });
        return new Margins(least[0], least[1]);
    }

    private static List<Geodetic> square(PlanePoint middle, double half) {
        double east = middle.eastMeters();
        double north = middle.northMeters();
        return List.of(
                PLANE.place(new PlanePoint(east - half, north - half)),
                PLANE.place(new PlanePoint(east + half, north - half)),
                PLANE.place(new PlanePoint(east + half, north + half)),
                PLANE.place(new PlanePoint(east - half, north + half)));
    }
}
