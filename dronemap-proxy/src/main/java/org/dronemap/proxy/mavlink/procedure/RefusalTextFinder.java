package org.dronemap.proxy.mavlink.procedure;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.dronemap.core.drone.Severity;
import org.jspecify.annotations.Nullable;

/** Finds the STATUSTEXT by which a vehicle explains why it refused a command, shortly before or after. */
final class RefusalTextFinder {
    private static final long BEFORE_NANOS = 500_000_000L;
    private static final long AFTER_NANOS = 1_000_000_000L;
    private static final long MORE_NANOS = 250_000_000L;
    private static final int MAX_SENTENCES = 4;

    private record Sentence(Severity severity, String text, long atNanos) {}

    private final List<Sentence> sentences = new ArrayList<>();

    void textReceived(Severity severity, String text, long nowNanos) {
        if (sentences.size() == MAX_SENTENCES) {
            sentences.remove(0);
        }
        sentences.add(new Sentence(severity, text, nowNanos));
    }

    /** The reason once it is complete; null while more may come. {@code fallback} when the vehicle said nothing. */
    @Nullable
    String of(long refusedNanos, String fallback, long nowNanos) {
        Set<String> grave = new LinkedHashSet<>();
        Set<String> any = new LinkedHashSet<>();
        long newest = refusedNanos;
        for (Sentence sentence : sentences) {
            if (sentence.atNanos() >= refusedNanos - BEFORE_NANOS) {
                any.add(sentence.text());
                newest = Math.max(newest, sentence.atNanos());
                if (sentence.severity().compareTo(Severity.WARNING) <= 0) {
                    grave.add(sentence.text());
                }
            }
        }
        boolean enough = !grave.isEmpty() && nowNanos - newest >= MORE_NANOS;
        if (!enough && nowNanos - refusedNanos < AFTER_NANOS) {
            return null;
        }
        Set<String> reasons = grave.isEmpty() ? any : grave;
        return reasons.isEmpty() ? fallback : String.join("; ", reasons);
    }
}
