package org.dronemap.proxy.endpoint;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Where vehicles may call in, such as {@code udpserver://127.0.0.1:14550}; port 0 takes any free one. */
public record EndpointUrl(Transport transport, String host, int port) {
    private static final Pattern FORM = Pattern.compile("([a-z]+)://(\\[[0-9a-fA-F:.]+]|[^:/\\[\\]]+):(\\d{1,5})/?");

    /** How bytes travel. */
    public enum Transport {
        UDP("udpserver", "udp"),
        TCP("tcpserver", "tcp");

        private final String scheme;
        private final String label;

        Transport(String scheme, String label) {
            this.scheme = scheme;
            this.label = label;
        }

        /** The word that users know. */
        public String label() {
            return label;
        }
    }

    /**
     * Reads a URL.
     *
     * @throws IllegalArgumentException with a sentence that says what is wrong
     */
    public static EndpointUrl parse(String text) {
        Matcher parts = FORM.matcher(text.strip().toLowerCase(Locale.ROOT));
        if (!parts.matches()) {
            throw new IllegalArgumentException("\"" + text
                    + "\" is no endpoint; write udpserver://ADDRESS:PORT or tcpserver://ADDRESS:PORT, such as"
                    + " udpserver://127.0.0.1:14550.");
        }
        int port = Integer.parseInt(parts.group(3));
        if (port > 65_535) {
            throw new IllegalArgumentException(
                    "\"" + text + "\" names port " + port + "; a port is 0 to 65535 (0: any free one).");
        }
        return new EndpointUrl(transport(text, parts.group(1)), parts.group(2), port);
    }

    private static Transport transport(String text, String scheme) {
        for (Transport transport : Transport.values()) {
            if (transport.scheme.equals(scheme)) {
                return transport;
            }
        }
        throw new IllegalArgumentException(
                "\"" + text + "\" begins with " + scheme + "://; only udpserver:// and tcpserver:// are known.");
    }

    EndpointUrl withPort(int bound) {
        return new EndpointUrl(transport, host, bound);
    }

    @Override
    public String toString() {
        return transport.scheme + "://" + host + ":" + port;
    }
}
