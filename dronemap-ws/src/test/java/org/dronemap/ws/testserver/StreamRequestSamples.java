package org.dronemap.ws.testserver;

import java.util.Map;

/** What clients say on the stream, of each type, with what it needs. */
public final class StreamRequestSamples {
    private static final Map<String, String> MEMBERS = Map.of(
            "command", "\"drone\":\"%s\",\"command\":{\"type\":\"land\"}",
            "control", "\"drone\":\"%s\",\"action\":\"take\"",
            "steer", "\"drone\":\"%s\",\"velocity\":{\"forward\":1}",
            "letGo", "\"drone\":\"%s\"",
            "positions", "\"follow\":\"nosuchfollow\",\"sent\":\"2026-01-31T12:00:00Z\",\"positions\":[]");

    private StreamRequestSamples() {}

    /** A message of that type, about that drone if it is about one. */
    public static String about(String drone, String type) {
        String members = MEMBERS.getOrDefault(type, "").formatted(drone);
        return "{\"type\":\"" + type + "\"" + (members.isEmpty() ? "" : "," + members) + "}";
    }
}
