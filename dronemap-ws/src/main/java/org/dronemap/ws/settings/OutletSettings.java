package org.dronemap.ws.settings;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronemap.proxy.outlet.rights.PortRange;
import org.dronemap.ws.environment.SetupException;

/**
 * Settings of the outlet: addresses at which third-party ground stations attach, and ports users may open.
 *
 * @param urls empty: nowhere
 * @param usual nobody has chosen these
 * @param personal where users may open ports of their own
 */
public record OutletSettings(List<String> urls, boolean usual, PortRange personal) {
    /** Nothing listens. */
    public static final OutletSettings OFF = new OutletSettings(List.of(), false, PortRange.NONE);

    private static final PortRange USUAL_PORTS = new PortRange(14_561, 14_580);
    private static final int HIGHEST_PORT = 65_535;
    private static final Pattern RANGE = Pattern.compile("(\\d{1,5})-(\\d{1,5})");

    public OutletSettings {
        urls = List.copyOf(urls);
    }

    /** {@code host} as it stands in a URL. */
    static OutletSettings of(Map<String, String> environment, String host) {
        String value = environment.getOrDefault("DRONEMAP_OUTLET", "").strip();
        if (value.isEmpty()) {
            return new OutletSettings(
                    List.of("udpserver://" + host + ":14560", "tcpserver://" + host + ":5790"),
                    true,
                    personal(environment));
        }
        if (value.equals("off")) {
            return OFF;
        }
        return new OutletSettings(
                Arrays.stream(value.split(",", -1))
                        .map(String::strip)
                        .filter(url -> !url.isEmpty())
                        .toList(),
                false,
                personal(environment));
    }

    private static PortRange personal(Map<String, String> environment) {
        String value = environment.getOrDefault("DRONEMAP_OUTLET_PORTS", "").strip();
        if (value.isEmpty()) {
            return USUAL_PORTS;
        }
        if (value.equals("off")) {
            return PortRange.NONE;
        }
        Matcher range = RANGE.matcher(value);
        if (range.matches()) {
            int first = Integer.parseInt(range.group(1));
            int last = Integer.parseInt(range.group(2));
            if (first >= 1 && first <= last && last <= HIGHEST_PORT) {
                return new PortRange(first, last);
            }
        }
        throw new SetupException(
                "DRONEMAP_OUTLET_PORTS: \"" + value + "\" is no range of ports; write 14561-14580, or off.");
    }
}
