package org.dronemap.core.zone;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** No accepted mission touches a keep-out, and hardly any that keeps its distance is refused. */
class ZonePropertyTest {
    @Test
    void acceptsWhatIsClearAndNothingThatTouches() {
        new ZoneTrial(20_260_504).run(2_000);
    }

    @Test
    @Tag("soak")
    void acceptsWhatIsClearAndNothingThatTouchesForLong() {
        long seed = System.nanoTime();
        ZoneTrial trial = new ZoneTrial(seed);
        trial.run(100_000);
        System.out.println(trial.figures() + "; seed " + seed);
    }
}
