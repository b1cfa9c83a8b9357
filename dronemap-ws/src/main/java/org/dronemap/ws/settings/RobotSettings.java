package org.dronemap.ws.settings;

import java.util.Arrays;
import java.util.List;
import java.util.Map;

/**
 * Settings of the endpoints at which ROSLink robots connect.
 *
 * @param urls empty: nowhere
 * @param usual nobody has chosen these
 */
public record RobotSettings(List<String> urls, boolean usual) {
    /** Nothing listens. */
    public static final RobotSettings OFF = new RobotSettings(List.of(), false);

    public RobotSettings {
        urls = List.copyOf(urls);
    }

    /** {@code host} as it stands in a URL. */
    static RobotSettings of(Map<String, String> environment, String host) {
        String value = environment.getOrDefault("DRONEMAP_ROBOTS", "").strip();
        if (value.isEmpty()) {
            return new RobotSettings(List.of("udpserver://" + host + ":25500", "wsserver://" + host + ":9090"), true);
        }
        if (value.equals("off")) {
            return OFF;
        }
        return new RobotSettings(
                Arrays.stream(value.split(",", -1))
                        .map(String::strip)
                        .filter(url -> !url.isEmpty())
                        .toList(),
                false);
    }
}
