package org.dronemap.core.cloud;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Pattern;

/**
 * Limits records of refused setpoints: the same refusal at most every ten seconds. Holds the newest few; owned by the
 * drone's lane.
 */
final class SetpointRefusalFilter {
    static final long AGAIN_NANOS = 10_000_000_000L;
    private static final int MOST = 32;
    private static final Pattern NUMBERS = Pattern.compile("[-0-9.]+");

    private final Map<Refusal, Long> lastRecorded = new LinkedHashMap<>();

    private record Refusal(String by, String face, String kind) {}

    /** True at first, and when ten seconds have gone by since it was true for the same. */
    boolean isNews(CommandGate.Source source, String why, long nowNanos) {
        // The same with other numbers, such as metres to a zone, is the same.
        String kind = NUMBERS.matcher(why).replaceAll("#");
        Refusal refusal = new Refusal(source.principal().name(), source.face(), kind);
        Long last = lastRecorded.get(refusal);
        if (last != null && nowNanos - last < AGAIN_NANOS) {
            return false;
        }
        lastRecorded.remove(refusal);
        lastRecorded.put(refusal, nowNanos);
        if (lastRecorded.size() > MOST) {
            lastRecorded.remove(lastRecorded.keySet().iterator().next());
        }
        return true;
    }
}
