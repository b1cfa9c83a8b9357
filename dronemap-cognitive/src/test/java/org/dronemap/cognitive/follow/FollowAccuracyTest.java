package org.dronemap.cognitive.follow;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.function.LongFunction;
import org.dronemap.cognitive.follow.FollowTrial.Noise;
import org.dronemap.cognitive.follow.FollowTrial.Result;
import org.dronemap.cognitive.follow.FollowTrial.Setup;
import org.dronemap.cognitive.follow.FollowTrial.Way;
import org.junit.jupiter.api.Test;

/** How far simulated drones are from where they have to be, by the truth, over a slow network. */
class FollowAccuracyTest {
    private static final StandOff SOUTH = new StandOff(new StandOffSide.Fixed(180), 5, SimDrone.HOME_AMSL + 15);
    private static final SimulatedLink.Quality SLOW = new SimulatedLink.Quality(0.3, 0, 0);
    private static final SimulatedLink.Quality POOR = new SimulatedLink.Quality(0.5, 0.2, 0.1);
    private static final double WIND = 3;
    private static final double SETTLED = 20;
    private static final int SEEDS = 3;
    /** What is rare comes to little in three walks. */
    private static final int SEEDS_OF_A_QUANTILE = 10;

    private static Setup setup(Way way, Noise noise, SimulatedLink.Quality link, long seed) {
        return new Setup(way, SOUTH, noise, link, WIND, seed, SETTLED);
    }

    /** All samples of some walks as one. */
    private static Result flown(LongFunction<TargetPath> walks, Way way, Noise noise, SimulatedLink.Quality link) {
        return flown(walks, way, noise, link, SEEDS);
    }

    private static Result flown(
            LongFunction<TargetPath> walks, Way way, Noise noise, SimulatedLink.Quality link, int seeds) {
        Result all = new Result(new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
        for (long seed = 1; seed <= seeds; seed++) {
            Result one = FollowTrial.fly(walks.apply(seed), setup(way, noise, link, seed));
            all.error().addAll(one.error());
            all.reported().addAll(one.reported());
            all.noise().addAll(one.noise());
        }
        return all;
    }

    @Test
    void staysBesideAWalker() {
        Result result = flown(TargetPath::walking, Way.FORESEEN, Noise.NONE, SLOW, SEEDS_OF_A_QUANTILE);
        assertThat(result.mean()).isLessThan(1);
        assertThat(result.quantile(0.95)).isLessThan(2);
    }

    @Test
    void staysBesideARunnerAndFarBetterThanWithoutForesight() {
        double mean = flown(TargetPath::running, Way.FORESEEN, Noise.NONE, SLOW).mean();
        assertThat(mean).isLessThan(1.5);
        assertThat(mean)
                .isLessThan(0.7
                        * flown(TargetPath::running, Way.LAST_FIX, Noise.NONE, SLOW)
                                .mean());
    }

    @Test
    void staysBesideACyclistAndFarBetterThanWithoutForesight() {
        double mean = flown(TargetPath::cycling, Way.FORESEEN, Noise.NONE, SLOW).mean();
        assertThat(mean).isLessThan(4);
        assertThat(mean)
                .isLessThan(0.7
                        * flown(TargetPath::cycling, Way.LAST_FIX, Noise.NONE, SLOW)
                                .mean());
    }

    /** Upwind they fly at the end of what they can lean for; one that is asked for more flies straight on where it had to turn. */
    @Test
    void turnsWithACyclistWhomItCanHardlyKeepUpWith() {
        Result all = new Result(new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
        for (long seed : List.of(1L, 3L, 5L)) {
            Setup setup = setup(Way.FORESEEN, Noise.NONE, SLOW, seed);
            SimDrone drone = SimDrone.leaning(FollowTrial.height(setup), WIND, seed);
            all.error()
                    .addAll(FollowTrial.fly(TargetPath.cycling(seed), setup, drone)
                            .error());
        }
        assertThat(all.mean()).isLessThan(6);
        assertThat(all.quantile(1)).isLessThan(40);
    }

    @Test
    void addsLittleToTheErrorOfAPhone() {
        for (LongFunction<TargetPath> walks :
                List.<LongFunction<TargetPath>>of(TargetPath::walking, TargetPath::running)) {
            Result result = flown(walks, Way.FORESEEN, Noise.PLACE, SLOW);
            assertThat(result.mean()).isLessThan(Result.mean(result.noise()) + 1);
        }
    }

    @Test
    void addsLittleToTheErrorOfACyclistsPhoneThatSaysHowItMoves() {
        Result result = flown(TargetPath::cycling, Way.FORESEEN, Noise.PLACE_AND_COURSE, SLOW);
        assertThat(result.mean()).isLessThan(Result.mean(result.noise()) + 1);
    }

    @Test
    void staysBesideAWalkerOverAPoorNetwork() {
        assertThat(flown(TargetPath::walking, Way.FORESEEN, Noise.NONE, POOR).mean())
                .isLessThan(2);
    }

    @Test
    void holdsWhileThePhoneSleepsAndComesUpAgain() {
        List<Double> speeds = new ArrayList<>();
        TargetPath walk = TargetPath.asleep(1);
        double[] last = new double[3];
        Setup setup = setup(Way.FORESEEN, Noise.NONE, SLOW, 1);
        Result result = FollowTrial.fly(walk, setup, FollowTrial.Site.open(setup), (now, drone, target) -> {
            if (now > 108 && now < 130) {
                speeds.add(Math.hypot(drone.east() - last[0], drone.north() - last[1]) / TargetPath.STEP_SECONDS);
            }
            last[0] = drone.east();
            last[1] = drone.north();
        });
        assertThat(Result.mean(speeds)).isLessThan(0.15);
        int size = result.error().size();
        assertThat(Result.mean(result.error().subList(size - 400, size))).isLessThan(1.5);
    }
}
