package org.dronemap.core.link;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * One measure of a link (loss, round trip, jitter) over time: its usual mean and spread, and how it changed in the last
 * seconds. A link that gets worse does not become usual: what is beyond the usual moves the mean slowly, and the spread
 * not at all. Owned by whoever measures the link.
 */
final class LinkMeasure {
    private static final int NEWEST = 15;
    private static final int FEWEST = 6;
    /** From where on the mean follows no faster. */
    private static final double MEMORY_SAMPLES = 120;

    private static final double FIRST_SAMPLES = 20;
    private static final double SPREADS = 6;
    private static final double CLIPPED_SPREADS = 3;
    private static final double NEAR_SPREADS = 2;
    /** Of a mean deviation, as it is of a normal distribution. */
    private static final double SPREAD_OF_DEVIATION = 1.25;

    private final Kind kind;
    private final double[] newest = new double[NEWEST];
    private int samples;
    private int first;
    private double mean;
    private double deviation;
    private double last;

    /**
     * The measured quantity, and what counts of it.
     *
     * @param least change that means anything
     * @param share of what is usual that a change has to be
     * @param worst with so much a link is as good as lost
     * @param urgent with less it is not expected to be lost, however quickly it grows
     */
    record Kind(double least, double share, double worst, double urgent) {}

    LinkMeasure(Kind kind) {
        this.kind = kind;
    }

    void add(@Nullable Double value) {
        if (value == null) {
            return;
        }
        last = value;
        newest[samples % NEWEST] = value;
        learn(value);
        samples++;
    }

    private void learn(double value) {
        double away = value - mean;
        if (samples < FIRST_SAMPLES) {
            mean += away / (samples + 1);
            deviation += (Math.abs(value - mean) - deviation) / (samples + 1);
            return;
        }
        double gain = 1 / Math.min(MEMORY_SAMPLES, samples);
        double clip = CLIPPED_SPREADS * spread();
        if (!isWorse()) {
            deviation += gain * (Math.min(Math.abs(away), clip) - deviation);
        }
        mean += gain * Math.max(-clip, Math.min(clip, away));
    }

    private double spread() {
        return Math.max(kind.least() / SPREADS, SPREAD_OF_DEVIATION * deviation);
    }

    /** What was before a silence is no part of what comes after it. */
    void begin() {
        first = samples;
    }

    /** It has been measured for long enough to know what is usual. */
    boolean isKnown() {
        return samples >= FIRST_SAMPLES;
    }

    double usual() {
        return mean;
    }

    double newest() {
        return last;
    }

    /** The wider, the less was seen of what is usual. */
    private double margin() {
        double unsure = 1 + FIRST_SAMPLES / Math.max(1, samples);
        return unsure * Math.max(Math.max(kind.least(), kind.share() * mean), SPREADS * spread());
    }

    /** How far it is from the usual, in margins of it. */
    double excess() {
        return (last - mean) / margin();
    }

    /** Worse than it usually is, beyond chance. */
    boolean isWorse() {
        return isKnown() && last > mean + margin();
    }

    /** As it usually is again; between this and worse nothing is decided. */
    boolean isUsual() {
        return !isKnown() || last <= mean + margin() / 2;
    }

    /** As good as lost. */
    boolean isWorst() {
        return samples > FEWEST && last >= kind.worst();
    }

    /**
     * Seconds until it is as good as lost if it goes on as in the last seconds; infinite where it does not grow. One that was
     * worse a moment ago does not grow: a single gap is past.
     */
    double secondsLeft() {
        int count = Math.min(NEWEST, samples - first);
        if (count < FEWEST || last < kind.urgent()) {
            return Double.POSITIVE_INFINITY;
        }
        double[] values = new double[count];
        for (int i = 0; i < count; i++) {
            values[i] = newest[(samples - count + i) % NEWEST];
        }
        double highest = Arrays.stream(values).max().orElse(0);
        double slope = slope(values);
        return slope <= 0 || last < highest - NEAR_SPREADS * spread()
                ? Double.POSITIVE_INFINITY
                : Math.max(0, kind.worst() - last) / slope;
    }

    /** Of the straight line through the values, by least squares. */
    private static double slope(double[] values) {
        double middle = (values.length - 1) / 2.0;
        double average = Arrays.stream(values).average().orElse(0);
        double products = 0;
        double squares = 0;
        for (int i = 0; i < values.length; i++) {
            products += (i - middle) * (values[i] - average);
            squares += (i - middle) * (i - middle);
        }
        return products / squares;
    }
}
