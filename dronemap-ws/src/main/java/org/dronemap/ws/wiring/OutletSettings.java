package org.dronemap.ws.wiring;

import java.util.Arrays;
import java.util.List;
import java.util.Map;

/**
 * Where ground stations of other makers attach.
 *
 * @param urls empty: nowhere
 * @param usual nobody has chosen these
 */
public record OutletSettings(List<String> urls, boolean usual) {
    /** Nothing listens. */
    public static final OutletSettings OFF = new OutletSettings(List.of(), false);

    public OutletSettings {
        urls = List.copyOf(urls);
    }

    /** {@code host} as it stands in a URL. */
    static OutletSettings of(Map<String, String> environment, String host) {
        String value = environment.getOrDefault("DRONEMAP_OUTLET", "").strip();
        if (value.isEmpty()) {
            return new OutletSettings(List.of("udpserver://" + host + ":14560", "tcpserver://" + host + ":5790"), true);
        }
        if (value.equals("off")) {
            return OFF;
        }
        return new OutletSettings(
                Arrays.stream(value.split(",", -1))
                        .map(String::strip)
                        .filter(url -> !url.isEmpty())
                        .toList(),
                false);
    }
}
