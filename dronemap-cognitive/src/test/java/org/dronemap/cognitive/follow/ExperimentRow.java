package org.dronemap.cognitive.follow;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.dronemap.cognitive.follow.FollowTrial.Noise;
import org.dronemap.cognitive.follow.FollowTrial.Result;
import org.dronemap.cognitive.follow.FollowTrial.Way;

/**
 * What came of one kind of walk, followed in one way, once for each seed.
 *
 * @param vehicle what followed
 * @param settled nothing was counted before, in seconds
 */
record ExperimentRow(
        String vehicle, String walk, String link, Noise noise, Way way, double settled, List<Result> flown) {
    private static final int HUNDRED = 100;
    private static final int EVERY = 10;

    /** One line; over time, it tells of the first one alone. */
    String json() {
        Result all = new Result(new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
        for (Result one : flown) {
            all.error().addAll(one.error());
            all.reported().addAll(one.reported());
            all.noise().addAll(one.noise());
        }
        List<Double> quantiles = new ArrayList<>();
        for (int percent = 0; percent <= HUNDRED; percent++) {
            quantiles.add(all.quantile(percent / 100.0));
        }
        List<Double> first = flown.get(0).error();
        List<Double> series = new ArrayList<>();
        for (int sample = 0; sample < first.size(); sample += EVERY) {
            series.add(first.get(sample));
        }
        return String.format(
                Locale.ROOT,
                "{\"walk\":\"%s\",\"link\":\"%s\",\"noise\":\"%s\",\"way\":\"%s\",\"mean\":%.3f,\"reported\":%.3f,"
                        + "\"phone\":%.3f,\"quantiles\":%s,\"settled\":%.1f,\"step\":%.2f,\"series\":%s,"
                        + "\"vehicle\":\"%s\"}",
                walk,
                link,
                noise,
                way,
                all.mean(),
                Result.mean(all.reported()),
                Result.mean(all.noise()),
                json(quantiles),
                settled,
                EVERY * TargetPath.STEP_SECONDS,
                json(series),
                vehicle);
    }

    private static String json(List<Double> values) {
        return values.stream()
                .map(value -> String.format(Locale.ROOT, "%.2f", value))
                .collect(Collectors.joining(",", "[", "]"));
    }
}
