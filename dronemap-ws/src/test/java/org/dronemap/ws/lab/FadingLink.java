package org.dronemap.ws.lab;

import java.time.Duration;
import java.util.SplittableRandom;

/** Lets the link of a vehicle be as it usually is, and then fade: it loses more and more, later and later, until nothing comes. */
public final class FadingLink {
    private static final Duration STEP = Duration.ofSeconds(1);

    private final Laboratory lab;
    private final LabVehicleLink wire;
    private final LabVehicleLink.Quality usual;
    private final double bend;

    /** {@code seed}: whether it fades rather at first or rather at last. */
    public FadingLink(Laboratory lab, LabVehicleLink wire, LabVehicleLink.Quality usual, long seed) {
        this.lab = lab;
        this.wire = wire;
        this.usual = usual;
        this.bend = 0.7 + 0.8 * new SplittableRandom(seed).nextDouble();
        wire.is(usual);
    }

    /** What is asked each second. */
    public interface Question {
        boolean isSo();
    }

    /** Lets it fade over so many seconds; true when that became so before the end. */
    public boolean fades(int seconds, Question question) {
        for (int second = 1; second <= seconds; second++) {
            wire.is(after(second / (double) seconds));
            lab.goOn(STEP);
            if (question.isSo()) {
                return true;
            }
        }
        return false;
    }

    /** It is as it usually was again. */
    public void recovers() {
        wire.is(usual);
    }

    private LabVehicleLink.Quality after(double share) {
        double gone = Math.pow(share, bend);
        long later = Math.round(300 * gone);
        return new LabVehicleLink.Quality(
                usual.loss() + (1 - usual.loss()) * gone,
                usual.delay().plusMillis(later),
                usual.scatter().plusMillis(later));
    }
}
