package org.dronemap.cognitive.follow;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.LongFunction;
import org.dronemap.cognitive.follow.FollowTrial.Noise;
import org.dronemap.cognitive.follow.FollowTrial.Result;
import org.dronemap.cognitive.follow.FollowTrial.Setup;
import org.dronemap.cognitive.follow.FollowTrial.Way;

/**
 * {@code SEEDS [NAME=FILE …]}: has a drone follow all walks in all ways, and writes a line of JSON for each. A file has lines
 * {@code SECONDS EAST NORTH}: a walk that was recorded.
 */
public final class FollowExperiment {
    static final double SETTLED = 20;
    static final double WIND = 3;
    static final StandOff SOUTH = new StandOff(new StandOffSide.Fixed(180), 5, SimDrone.HOME_AMSL + 15);
    static final Link SLOW = new Link("300 ms", new SimulatedLink.Quality(0.3, 0, 0));
    private static final List<Link> LINKS =
            List.of(SLOW, new Link("500 ± 200 ms, 10 % lost", new SimulatedLink.Quality(0.5, 0.2, 0.1)));

    record Link(String name, SimulatedLink.Quality quality) {}

    private record Case(Way way, Noise noise, Link link) {}

    private FollowExperiment() {}

    public static void main(String[] words) throws IOException {
        int seeds = Integer.parseInt(words[0]);
        List<LongFunction<TargetPath>> walks = new ArrayList<>();
        for (int kind = 0; kind < TargetPath.all(0).size(); kind++) {
            int number = kind;
            walks.add(seed -> TargetPath.all(seed).get(number));
        }
        for (String word : Arrays.asList(words).subList(1, words.length)) {
            String[] parts = word.split("=", 2);
            TargetPath recorded = TargetPath.recorded(parts[0], read(Path.of(parts[1])));
            walks.add(seed -> recorded);
        }
        for (LongFunction<TargetPath> walk : walks) {
            for (Link link : LINKS) {
                for (Noise noise : Noise.values()) {
                    for (Way way : Way.values()) {
                        write(System.out, walk, new Case(way, noise, link), seeds);
                    }
                }
            }
        }
    }

    private static List<double[]> read(Path file) throws IOException {
        return Files.readAllLines(file).stream()
                .map(line -> Arrays.stream(line.split(" ", -1))
                        .mapToDouble(Double::parseDouble)
                        .toArray())
                .toList();
    }

    private static void write(PrintStream out, LongFunction<TargetPath> walks, Case what, int seeds) {
        List<Result> flown = new ArrayList<>();
        for (long seed = 1; seed <= seeds; seed++) {
            flown.add(FollowTrial.fly(
                    walks.apply(seed),
                    new Setup(what.way(), SOUTH, what.noise(), what.link().quality(), WIND, seed, SETTLED)));
        }
        String walk = walks.apply(1).name();
        out.println(new ExperimentRow("simulated", walk, what.link().name(), what.noise(), what.way(), SETTLED, flown)
                .json());
    }
}
