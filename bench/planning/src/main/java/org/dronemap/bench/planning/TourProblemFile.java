package org.dronemap.bench.planning;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * A problem as lines of words: {@code metric euclidean|att}, {@code aim longest|sum}, {@code depot X Y} for each drone,
 * {@code waypoint X Y}. It bears no name: who solves it does not know which one it is.
 */
public final class TourProblemFile {
    private TourProblemFile() {}

    public static TourProblem read(Path file) throws IOException {
        return of(Files.readAllLines(file));
    }

    static TourProblem of(List<String> lines) {
        Metric metric = Metric.EUCLIDEAN;
        boolean longest = true;
        List<TourPoint> depots = new ArrayList<>();
        List<TourPoint> waypoints = new ArrayList<>();
        for (String line : lines) {
            String[] words = line.trim().split("\\s+", -1);
            switch (words[0]) {
                case "metric" -> metric = Metric.valueOf(words[1].toUpperCase(Locale.ROOT));
                case "aim" -> longest = words[1].equals("longest");
                case "depot" -> depots.add(spot(words));
                case "waypoint" -> waypoints.add(spot(words));
                default -> throw new IllegalArgumentException("no line of a problem begins with '" + words[0] + "'");
            }
        }
        return new TourProblem(metric, longest, depots, waypoints);
    }

    private static TourPoint spot(String[] words) {
        return new TourPoint(Double.parseDouble(words[1]), Double.parseDouble(words[2]));
    }
}
