package org.dronemap.ws.testserver;

import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.dronemap.core.audit.AuditEntry;
import org.jspecify.annotations.Nullable;

/** Records of one deed that was done twice: what they have in common, whichever way in each took. */
public final class AuditRecordComparison {
    /** Drones, names and ports that are new for each deed. */
    private static final Pattern NEW = Pattern.compile("\\b(drone-|thing|127\\.0\\.0\\.1:)\\d+");

    private final String[] pattern;
    private final String[] path;

    /** {@code rest}: the operation of REST that the deed is, by method and path. */
    public AuditRecordComparison(String rest, SuccessfulCalls.PreparedCall deed) {
        pattern = rest.replaceFirst(".* ", "").split("/");
        path = deed.path().replaceFirst("\\?.*", "").split("/");
    }

    /** All but the way in, the moment and how long it took; what the address names stands as its variable. */
    public Map<String, String> told(AuditEntry entry) {
        Map<String, String> told = new TreeMap<>();
        told.put("by", String.valueOf(entry.by()));
        told.put("organisation", String.valueOf(entry.organisation()));
        told.put("key", String.valueOf(entry.key()));
        told.put("operation", entry.operation());
        told.put("drone", alike(entry.drone()));
        told.put("epoch", entry.epoch() == null ? "none" : "some");
        told.put("command", entry.command() == null ? "none" : "some");
        told.put("parameters", alike(entry.parameters()));
        told.put("outcome", entry.outcome().toString());
        told.put("reason", alike(entry.reason()));
        return told;
    }

    private String alike(@Nullable String text) {
        String alike = String.valueOf(text);
        for (int i = 0; i < pattern.length; i++) {
            if (pattern[i].startsWith("{")) {
                alike = alike.replaceAll("\\b" + Pattern.quote(path[i]) + "\\b", "<" + pattern[i] + ">");
            }
        }
        return NEW.matcher(alike).replaceAll("$1NEW");
    }
}
