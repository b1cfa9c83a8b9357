package org.dronemap.ws.flights.separation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.dronemap.ws.lab.LaboratorySetup;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Flies many seeds of one scenario, or one seed with something that comes between at each tenth of a second around its
 * meeting, and has a program judge them that knows nothing of the product. {@code DRONEMAP_TRIAL_SEEDS} says which: the name
 * of a scenario or of what comes between, and the seeds, as in {@code two-runs.1-25} and {@code pilot.1}.
 */
@Tag("soak")
class SeparationTrialTest {
    private static final String UNIT =
            Optional.ofNullable(System.getenv("DRONEMAP_TRIAL_SEEDS")).orElse("two-runs.1-2");
    private static final Path ROOT = Path.of("..").toAbsolutePath().normalize();
    private static final Path FOLDER = Path.of("target", "separation", UNIT);
    /** The server is killed at a moment that chance chooses. */
    private static final String KILLED = "killed-at-any-moment";

    private static final double FIRST_MOMENT = 5;
    private static final int LEAST_UP = 5;
    private static final int MOST_MOMENTS = 30;
    private static final double BEFORE = 8;
    private static final int MOMENTS = 100;
    private static final double TENTHS = 10;
    /** Of the flights with nothing that keeps them apart: fewer would prove little. */
    private static final String BREACHING = "0.8";

    @Test
    void allKeepApart() throws IOException, InterruptedException {
        String[] unit = UNIT.split("\\.", 2);
        String[] seeds = unit[1].split("-", 2);
        long last = Long.parseLong(seeds[seeds.length - 1]);
        delete(FOLDER);
        List<String> folders = new ArrayList<>();
        for (long seed = Long.parseLong(seeds[0]); seed <= last; seed++) {
            fly(unit[0], seed, folders);
        }

        assertThat(judged(folders)).as("flights in " + FOLDER.toAbsolutePath()).isZero();
        delete(FOLDER);
    }

    private static void fly(String name, long seed, List<String> folders) {
        if (name.equals(KILLED)) {
            keep(killed(seed), folders);
            return;
        }
        Optional<Scenario> scenario = Arrays.stream(Scenario.values())
                .filter(one -> one.words().equals(name))
                .findFirst();
        if (scenario.isPresent()) {
            SeparationFlight flight = SeparationFlight.of(scenario.get(), seed);
            keep(flight.together(Disturbance.NONE, 0), folders);
            return;
        }
        Disturbance disturbance = Arrays.stream(Disturbance.values())
                .filter(one -> one.words().equals(name))
                .findFirst()
                .orElseThrow(
                        () -> new IllegalArgumentException("There is neither a scenario nor a disturbance " + name));
        SeparationFlight flight = SeparationFlight.of(Scenario.TWO_RUNS, seed);
        double first = Math.round((flight.meeting().seconds() - BEFORE) * TENTHS) / TENTHS;
        for (int number = 0; number < MOMENTS; number++) {
            keep(flight.together(disturbance, first + number / TENTHS), folders);
        }
    }

    /** Vehicles are left to themselves for good, or for a while, while several of them are in the air. */
    private static FlownTogether killed(long seed) {
        SeparationFlight flight = SeparationFlight.of(Scenario.MIXED, seed);
        SplittableRandom chance = new SplittableRandom(seed);
        Disturbance how = chance.nextBoolean() ? Disturbance.KILLED : Disturbance.RESTARTED;
        for (int attempt = 0; attempt < MOST_MOMENTS; attempt++) {
            double moment = Math.round(chance.nextDouble(FIRST_MOMENT, flight.lastSecond()) * TENTHS) / TENTHS;
            FlownTogether flown = flight.together(how, moment);
            if (flown.airborneAt(moment) >= LEAST_UP) {
                return flown;
            }
        }
        throw new AssertionError(LEAST_UP + " of seed " + seed + " are never up at once");
    }

    private static void keep(FlownTogether flown, List<String> folders) {
        folders.add(flown.writeInto(FOLDER).toAbsolutePath().toString());
    }

    /** What the program ends with: 0 is well. */
    private static int judged(List<String> folders) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(
                "python3", ROOT.resolve("e2e/dronemap_e2e/separation_judge.py").toString()));
        command.addAll(folders);
        command.addAll(List.of(
                "--table", ROOT.resolve("docs/trials/separation-flights.tsv").toString()));
        if (!LaboratorySetup.isSeparationOn()) {
            boolean disturbed = Arrays.stream(Disturbance.values()).anyMatch(one -> UNIT.startsWith(one.words() + "."));
            command.addAll(List.of("--breaching", disturbed ? "0" : BREACHING));
        }
        return new ProcessBuilder(command).inheritIO().start().waitFor();
    }

    private static void delete(Path folder) throws IOException {
        if (Files.exists(folder)) {
            try (Stream<Path> all = Files.walk(folder)) {
                for (Path path : all.sorted(Comparator.reverseOrder()).toList()) {
                    Files.delete(path);
                }
            }
        }
    }
}
