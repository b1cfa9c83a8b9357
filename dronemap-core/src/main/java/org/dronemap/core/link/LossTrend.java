package org.dronemap.core.link;

/**
 * The loss of messages on one link over time, by counts: whether the last seconds are beyond chance worse than usual, by
 * the ratio of likelihoods, and how quickly it grows. A single gap counts for nothing, however much was lost in it; a
 * link whose losses come in bursts has to get worse by more. What is usual is learned from seconds that are over for
 * long, so that a link that fades does not become usual. Owned by whoever measures the link.
 */
final class LossTrend {
    private static final int WINDOW = 30;
    private static final int[] WINDOWS = {5, 8, 12, 17, 23, WINDOW};
    private static final int FIRST = 20;
    private static final int FEWEST = 6;
    /** Of fewer it is not known what is usual. */
    private static final double FEWEST_MESSAGES = 40;

    private static final int NEWEST = 5;
    private static final int USUAL_WINDOW = 15;
    /** Of messages from which a slope can be read; one that is heard often shows it sooner. */
    private static final double SLOPE_MESSAGES = 80;

    private static final int SHORTEST_SLOPE = 10;
    private static final double MEMORY = 240;
    /** A link that is worse all the time becomes usual, but slowly. */
    private static final double WORSE_WEIGHT = 0.1;

    /** By chance alone once in some e^9 looks at most, and there are a few thousand in a flight: it has to last, too. */
    private static final double UNLIKELY = 10;

    /** Messages a second. */
    private static final double OFTEN = 2.5;

    private static final double NEAR = 2;
    private static final double LEAST_CHANGE = 0.1;
    private static final double LEAST_USUAL = 0.01;
    private static final double WORST = 0.9;
    private static final int BLOCK = 5;
    private static final double MOST_SPREAD = 100;
    private static final double UNSURE_DEVIATIONS = 1.5;

    private final double[] received = new double[WINDOW];
    private final double[] lost = new double[WINDOW];
    private int samples;
    private int first;
    private double usualReceived;
    private double usualLost;
    private double blockAll;
    private double blockLost;
    private int blockSamples;
    private double spread = 8;
    private double spreadWeight = 4;
    private double newest;

    /** {@code share}: lost of some 5 s, as it is shown. */
    void add(long newlyReceived, long newlyLost, double share) {
        int slot = samples % WINDOW;
        if (samples >= FIRST + WINDOW) {
            learn(received[slot], lost[slot], isWorse() ? WORSE_WEIGHT : 1);
        }
        received[slot] = newlyReceived;
        // Less than none: some of what was missing before came late.
        lost[slot] = Math.max(0, newlyLost);
        if (samples < FIRST) {
            learn(received[slot], lost[slot], 1);
        }
        newest = share;
        samples++;
    }

    private void learn(double came, double missing, double weight) {
        double all = came + missing;
        if (all == 0) {
            return;
        }
        double kept = 1 - weight / MEMORY;
        usualReceived = usualReceived * kept + weight * came;
        usualLost = usualLost * kept + weight * missing;
        blockAll += all;
        blockLost += missing;
        if (++blockSamples == BLOCK) {
            learnSpread(weight);
        }
    }

    /** Of some seconds together, since bursts are longer than one. */
    private void learnSpread(double weight) {
        double share = Math.max(LEAST_USUAL, usual());
        double away = blockLost - blockAll * share;
        double times = Math.min(MOST_SPREAD, away * away / (blockAll * share * (1 - share)));
        double kept = 1 - weight * BLOCK / MEMORY;
        spread = spread * kept + weight * times;
        spreadWeight = spreadWeight * kept + weight;
        blockAll = 0;
        blockLost = 0;
        blockSamples = 0;
    }

    /** What was before a silence is no part of what comes after it. */
    void begin() {
        first = samples;
    }

    boolean isKnown() {
        return samples >= FIRST;
    }

    double usual() {
        double all = usualReceived + usualLost;
        return all == 0 ? 0 : usualLost / all;
    }

    double newest() {
        return newest;
    }

    /** In what chance may do, as other measures count their margins. */
    double excess() {
        return strongest() / UNLIKELY;
    }

    boolean isWorse() {
        return isKnown() && usualReceived + usualLost >= FEWEST_MESSAGES && strongest() > UNLIKELY;
    }

    /** As it usually is again; between this and worse nothing is decided. */
    boolean isUsual() {
        return !isKnown() || evidence(window(USUAL_WINDOW), false) < NEAR;
    }

    boolean isWorst() {
        return samples > FEWEST && newest >= WORST;
    }

    /** Seconds until it is as good as lost if it goes on as in the last seconds; infinite where it does not grow. */
    double secondsLeft() {
        int count = slopeWindow();
        if (count < FEWEST || evidence(window(NEWEST), false) < NEAR) {
            return Double.POSITIVE_INFINITY;
        }
        return untilWorst(count);
    }

    /** By the straight line through the shares, each as heavy as it has messages. */
    private double untilWorst(int count) {
        double weight = 0;
        double times = 0;
        double shares = 0;
        for (int age = 0; age < count; age++) {
            weight += sent(age);
            times -= sent(age) * age;
            shares += lost[slot(age)];
        }
        double time = times / weight;
        double share = shares / weight;
        double products = 0;
        double squares = 0;
        for (int age = 0; age < count; age++) {
            double away = -age - time;
            products += away * (lost[slot(age)] - sent(age) * share);
            squares += sent(age) * away * away;
        }
        double slope = squares == 0 ? 0 : products / squares;
        double now = share - slope * time;
        return slope <= 0 ? Double.POSITIVE_INFINITY : Math.max(0, WORST - now) / slope;
    }

    private int slopeWindow() {
        double messages = 0;
        int most = window(WINDOW);
        for (int count = 1; count <= most; count++) {
            messages += sent(count - 1);
            if (count >= SHORTEST_SLOPE && messages >= SLOPE_MESSAGES) {
                return count;
            }
        }
        return most;
    }

    private double strongest() {
        double strongest = 0;
        for (int length : WINDOWS) {
            strongest = Math.max(strongest, evidence(window(length), true));
        }
        return strongest;
    }

    /**
     * Logarithm of how much likelier the last {@code count} samples are with their own loss than with the usual one;
     * {@code withoutWorst}: the worst of them counts as the one next to it.
     */
    private double evidence(int count, boolean withoutWorst) {
        double came = 0;
        double missing = 0;
        double most = 0;
        double second = 0;
        for (int age = 0; age < count; age++) {
            double of = lost[slot(age)];
            came += received[slot(age)];
            missing += of;
            second = Math.max(second, Math.min(of, most));
            most = Math.max(most, of);
        }
        if (withoutWorst) {
            // A vehicle that is heard often shows it soon enough without its worst two seconds, as bursts may be.
            missing -= came + missing > OFTEN * count ? most + second : most - second;
        }
        double all = came + missing;
        double expected = expected();
        double share = all == 0 ? 0 : missing / all;
        if (share <= expected + (withoutWorst ? LEAST_CHANGE : 0)) {
            return 0;
        }
        double ratio =
                missing * Math.log(share / expected) + (came == 0 ? 0 : came * Math.log((1 - share) / (1 - expected)));
        return ratio / Math.max(1, spread / spreadWeight);
    }

    /** The usual loss, and what chance may have hidden of it. */
    private double expected() {
        double all = Math.max(1, usualReceived + usualLost);
        double share = Math.max(LEAST_USUAL, usual());
        return Math.min(0.8, share + UNSURE_DEVIATIONS * Math.sqrt(share * (1 - share) / all));
    }

    private int window(int length) {
        return Math.min(length, samples - Math.max(first, FIRST));
    }

    private int slot(int age) {
        return (samples - 1 - age) % WINDOW;
    }

    private double sent(int age) {
        return received[slot(age)] + lost[slot(age)];
    }
}
