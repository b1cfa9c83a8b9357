package org.dronemap.core.cloud;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Which refusals to steer are news: who goes on trying says the same up to fifty times a second. Holds the newest few; owned by
 * the drone's lane.
 */
final class HelmRefusals {
    static final long AGAIN_NANOS = 10_000_000_000L;
    private static final int MOST = 32;

    private final Map<Refusal, Long> said = new LinkedHashMap<>();

    private record Refusal(String by, String face, String why) {}

    /** True at first, and when ten seconds have gone by since it was true for the same. */
    boolean isNews(CommandGate.Source source, String why, long nowNanos) {
        Refusal refusal = new Refusal(source.principal().name(), source.face(), why);
        Long last = said.get(refusal);
        if (last != null && nowNanos - last < AGAIN_NANOS) {
            return false;
        }
        said.remove(refusal);
        said.put(refusal, nowNanos);
        if (said.size() > MOST) {
            said.remove(said.keySet().iterator().next());
        }
        return true;
    }
}
