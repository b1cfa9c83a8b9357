package org.dronemap.core.link;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkTrend;
import org.jspecify.annotations.Nullable;

/**
 * Follows the quality of one link, once a second, and compares it with how that link usually is: steady, worse, or so
 * quickly worse that it is expected to be lost. It is slow to change its mind either way, so that nothing flaps which
 * follows from it. Bounded memory; owned by whoever measures the link.
 */
public final class LinkTrendEstimator {
    /** Nobody acts on what may happen later. */
    static final double HORIZON_SECONDS = 120;

    // Waiting messages make a round trip longer, too, without an end of the link: half of what is of no use is to be
    // seen.
    private static final LinkMeasure.Kind ROUND_TRIP = new LinkMeasure.Kind(250, 1, 3_000, 1_500);
    private static final LinkMeasure.Kind JITTER = new LinkMeasure.Kind(150, 1, 1_500, 750);

    private static final LinkTrend SELDOM =
            new LinkTrend(LinkTrend.State.UNKNOWN, null, "It speaks too seldom to tell how its link changes.");
    private static final LinkTrend STEADY =
            new LinkTrend(LinkTrend.State.STEADY, null, "Its link is as it usually is.");

    private static final int SIGNS = 4;
    private static final int WORSE_SAMPLES = 3;
    private static final int USUAL_SAMPLES = 10;
    private static final int NOT_GROWING_SAMPLES = 20;
    private static final double OFTEN_ENOUGH = 0.3;
    private static final double MEMORY_SECONDS = 60;
    private static final double SILENCE_SECONDS = 5;
    private static final int STEP_SECONDS = 5;

    private final LossTrend loss = new LossTrend();
    private final LinkMeasure roundTrip = new LinkMeasure(ROUND_TRIP);
    private final LinkMeasure jitter = new LinkMeasure(JITTER);
    private final List<LinkMeasure> measures = List.of(roundTrip, jitter);
    private LinkTrend trend = LinkTrend.UNKNOWN;
    private double heardShare = 1;
    private double silentSeconds;
    private int worse;
    private int usual;
    private int signs;
    private int notGrowing;

    /** {@code received} and {@code lost}: messages since the sample before, {@code seconds} ago. */
    public LinkTrend sample(LinkQuality quality, long received, long lost, double seconds) {
        boolean heard = received > 0;
        double kept = Math.exp(-seconds / MEMORY_SECONDS);
        heardShare = heardShare * kept + (heard ? 1 - kept : 0);
        silentSeconds = heard ? 0 : silentSeconds + seconds;
        if (!heard) {
            if (silentSeconds >= SILENCE_SECONDS) {
                begin();
            }
            // What was measured before says nothing about now, nor does silence by itself: it has a watch of its own.
            trend = heardShare < OFTEN_ENOUGH ? SELDOM : trend;
            return trend;
        }
        loss.add(received, lost, quality.lossShort() == null ? 0 : quality.lossShort());
        roundTrip.add(quality.roundTripMillis());
        jitter.add(quality.jitterMillis());
        trend = heardShare < OFTEN_ENOUGH ? SELDOM : judge();
        return trend;
    }

    public LinkTrend trend() {
        return trend;
    }

    private void begin() {
        loss.begin();
        measures.forEach(LinkMeasure::begin);
        signs = 0;
    }

    private LinkTrend judge() {
        boolean bad = loss.isWorse() || measures.stream().anyMatch(LinkMeasure::isWorse);
        boolean lost = loss.isWorst();
        double left = lost ? 0 : secondsLeft();
        boolean growing = left <= HORIZON_SECONDS;
        worse = bad ? worse + 1 : 0;
        usual = loss.isUsual() && measures.stream().allMatch(LinkMeasure::isUsual) ? usual + 1 : 0;
        signs = Math.max(0, Math.min(SIGNS, signs + (growing ? 1 : -1)));
        notGrowing = growing ? 0 : notGrowing + 1;
        LinkTrend.State next = next(trend.state());
        return switch (next) {
            case FALLING -> new LinkTrend(next, rounded(left), words(left));
            case WORSE -> new LinkTrend(next, null, "Its link is worse than it usually is: " + figures() + ".");
            case STEADY -> STEADY;
            case UNKNOWN -> LinkTrend.UNKNOWN;
        };
    }

    private LinkTrend.State next(LinkTrend.State now) {
        boolean bad = now != LinkTrend.State.UNKNOWN && now != LinkTrend.State.STEADY;
        if (signs >= SIGNS
                || (now == LinkTrend.State.FALLING && usual < USUAL_SAMPLES && notGrowing < NOT_GROWING_SAMPLES)) {
            return LinkTrend.State.FALLING;
        }
        if (bad ? usual < USUAL_SAMPLES : worse >= WORSE_SAMPLES) {
            return LinkTrend.State.WORSE;
        }
        return loss.isKnown() ? LinkTrend.State.STEADY : LinkTrend.State.UNKNOWN;
    }

    /** By that which brings the end first; only what is worse than usual counts. */
    private double secondsLeft() {
        double others = measures.stream()
                .filter(LinkMeasure::isWorse)
                .mapToDouble(LinkMeasure::secondsLeft)
                .min()
                .orElse(Double.POSITIVE_INFINITY);
        return loss.isWorse() ? Math.min(others, loss.secondsLeft()) : others;
    }

    /** A figure that changes each second would be news each second. */
    private static @Nullable Integer rounded(double seconds) {
        return seconds > HORIZON_SECONDS ? null : (Integer) (int) (Math.ceil(seconds / STEP_SECONDS) * STEP_SECONDS);
    }

    private String words(double left) {
        Integer seconds = rounded(left);
        if (seconds == null) {
            return "Its link got much worse (" + figures() + ") and is not better yet.";
        }
        String when =
                seconds == 0 ? "it may be lost at any moment" : "it is expected to be lost in about " + seconds + " s";
        return "Its link gets worse (" + figures() + "): " + when + ".";
    }

    /** Of what is the farthest from what is usual. */
    private String figures() {
        LinkMeasure farthest = measures.stream()
                .max(Comparator.comparingDouble(LinkTrendEstimator::excess))
                .orElse(roundTrip);
        if (loss.excess() >= excess(farthest)) {
            return String.format(
                    Locale.ROOT,
                    "%.0f %% of its messages are lost, usually %.0f %%",
                    loss.newest() * 100,
                    loss.usual() * 100);
        }
        return String.format(
                Locale.ROOT,
                "%s %.0f ms, usually %.0f ms",
                farthest == roundTrip ? "answers take" : "its messages jitter by",
                farthest.newest(),
                farthest.usual());
    }

    private static double excess(LinkMeasure measure) {
        return measure.isKnown() ? measure.excess() : Double.NEGATIVE_INFINITY;
    }
}
