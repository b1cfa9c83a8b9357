package org.dronemap.proxy.mavlink.procedure;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import org.dronemap.core.drone.Severity;
import org.jspecify.annotations.Nullable;

/**
 * Finds the STATUSTEXTs by which a vehicle explains why it refused a command, shortly before or after. A vehicle that
 * starts up says many other things in the same second, which are kept out by their severity and their words.
 */
final class RefusalTextFinder {
    private static final long BEFORE_NANOS = 500_000_000L;
    private static final long AFTER_NANOS = 1_000_000_000L;
    private static final long MORE_NANOS = 250_000_000L;
    /** Texts go one after the other: while they still come, the reason may be behind them. */
    private static final long LATEST_NANOS = 3_000_000_000L;

    private static final int MAX_SENTENCES = 8;
    private static final int ARM_DISARM = 400;
    private static final Pattern OF_ARMING =
            Pattern.compile("^(PreArm|Arm|Disarm|Preflight|Arming|Disarming)\\b.*", Pattern.CASE_INSENSITIVE);
    private static final Pattern OF_ANOTHER_COMMAND = Pattern.compile("^(Pre)?Arm: .*", Pattern.CASE_INSENSITIVE);
    private static final Pattern OF_OTHERS = Pattern.compile("^(Flight )?mode change .*", Pattern.CASE_INSENSITIVE);
    private static final Pattern WORDS = Pattern.compile(
            ".*\\b(denied|refused|rejected|failed|cannot|can't|unable|invalid|missing|needs?|requires?|not allowed"
                    + "|not ready|not possible|too (low|high|far|close))\\b.*",
            Pattern.CASE_INSENSITIVE);

    private record Sentence(String text, boolean named, long atNanos) {}

    private final int command;
    private final List<Sentence> reasons = new ArrayList<>();
    private long lastTextNanos;
    private boolean anyText;

    /** {@code command}: the MAV_CMD that is refused. */
    RefusalTextFinder(int command) {
        this.command = command;
    }

    void textReceived(Severity severity, String text, long nowNanos) {
        anyText = true;
        lastTextNanos = nowNanos;
        boolean named =
                (command == ARM_DISARM ? OF_ARMING : OF_OTHERS).matcher(text).matches();
        boolean another =
                command != ARM_DISARM && OF_ANOTHER_COMMAND.matcher(text).matches();
        boolean grave = severity.compareTo(Severity.WARNING) <= 0;
        if (another || !(named || grave || WORDS.matcher(text).matches())) {
            return;
        }
        if (reasons.size() == MAX_SENTENCES) {
            Sentence oldest = reasons.stream()
                    .filter(reason -> !reason.named())
                    .findFirst()
                    .orElse(reasons.get(0));
            reasons.remove(oldest);
        }
        reasons.add(new Sentence(text, named, nowNanos));
    }

    /** The reason once it is complete; null while more may come. {@code fallback} when the vehicle said nothing. */
    @Nullable
    String of(long refusedNanos, String fallback, long nowNanos) {
        Set<String> named = new LinkedHashSet<>();
        Set<String> any = new LinkedHashSet<>();
        for (Sentence sentence : reasons) {
            if (sentence.atNanos() >= refusedNanos - BEFORE_NANOS) {
                any.add(sentence.text());
                if (sentence.named()) {
                    named.add(sentence.text());
                }
            }
        }
        if (mayComeMore(refusedNanos, any, nowNanos)) {
            return null;
        }
        // What calls itself the reason is one; what else was grave in that second may be another story.
        Set<String> found = named.isEmpty() ? any : named;
        return found.isEmpty() ? fallback : String.join("; ", found);
    }

    private boolean mayComeMore(long refusedNanos, Set<String> found, long nowNanos) {
        long since = nowNanos - refusedNanos;
        boolean speaks = since < MORE_NANOS || (anyText && nowNanos - lastTextNanos < MORE_NANOS);
        return speaks ? since < LATEST_NANOS : found.isEmpty() && since < AFTER_NANOS;
    }
}
