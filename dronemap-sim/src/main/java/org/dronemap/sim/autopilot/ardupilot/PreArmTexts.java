package org.dronemap.sim.autopilot.ardupilot;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** The texts of a simulated ArduPilot vehicle about what keeps it from arming, every half minute. Owned by its vehicle. */
final class PreArmTexts {
    private static final long EVERY_MILLIS = 30_000;

    private final Supplier<List<String>> complaints;
    private final Consumer<String> out;
    private long reportedAt;

    PreArmTexts(Supplier<List<String>> complaints, Consumer<String> out) {
        this.complaints = complaints;
        this.out = out;
    }

    void step(boolean armed, long nowMillis) {
        if (!armed && nowMillis - reportedAt >= EVERY_MILLIS) {
            report(nowMillis);
        }
    }

    void report(long nowMillis) {
        reportedAt = nowMillis;
        complaints.get().forEach(text -> out.accept("PreArm: " + text));
    }
}
