package org.dronemap.proxy.endpoint;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.dronemap.core.stored.Stored;
import org.dronemap.core.stored.StoredNames;

/**
 * The URL of an endpoint, such as {@code udpserver://127.0.0.1:14550} or {@code serial:///dev/ttyUSB0?baud=57600}.
 *
 * @param host empty for a serial line
 * @param path the device of a serial line, the path of a WebSocket, else empty
 * @param baud bits a second of a serial line, else 0
 */
public record EndpointUrl(Kind kind, String host, int port, String path, int baud) {
    private static final Pattern SCHEME = Pattern.compile("([a-zA-Z]+)://(.*)");
    private static final Pattern DEVICE = Pattern.compile("(/[^?#\\s]+)(?:\\?baud=(\\d{1,8}))?");
    private static final int DEFAULT_BAUD = 57_600;
    private static final int SLOWEST_BAUD = 1_200;
    private static final int FASTEST_BAUD = 4_000_000;
    private static final Pattern ADDRESS =
            Pattern.compile("(\\[[0-9a-fA-F:.]+]|[^:/?#@\\s\\[\\]]+):(\\d{1,5})(/[^?#\\s]*)?");

    /** Kinds of endpoints: the transport, and which end opens the connection. */
    @Stored(
            names = "udpserver udpclient tcpserver tcpclient serial wsserver wsclient wssserver wssclient "
                    + "dtlsserver")
    public enum Kind {
        UDPSERVER("udp", "udpserver://ADDRESS:PORT"),
        UDPCLIENT("udp", "udpclient://HOST:PORT"),
        TCPSERVER("tcp", "tcpserver://ADDRESS:PORT"),
        TCPCLIENT("tcp", "tcpclient://HOST:PORT"),
        SERIAL("serial", "serial:///dev/DEVICE?baud=57600"),
        WSSERVER("websocket", "wsserver://ADDRESS:PORT"),
        WSCLIENT("websocket", "wsclient://HOST:PORT/PATH"),
        WSSSERVER("websocket", "wssserver://ADDRESS:PORT"),
        WSSCLIENT("websocket", "wssclient://HOST:PORT/PATH"),
        DTLSSERVER("dtls", "dtlsserver://ADDRESS:PORT");

        private final String transport;
        private final String form;

        Kind(String transport, String form) {
            this.transport = transport;
            this.form = form;
        }

        /** The word that users know. */
        public String transport() {
            return transport;
        }

        String scheme() {
            return StoredNames.of(this);
        }

        /** True when vehicles call in here; false when this end dials, again and again. */
        public boolean isListener() {
            return name().endsWith("SERVER");
        }

        boolean isDatagram() {
            return transport.equals("udp");
        }

        static Optional<Kind> ofScheme(String scheme) {
            String known = scheme.equals("udpout") ? "udpclient" : scheme;
            return Arrays.stream(values())
                    .filter(kind -> kind.scheme().equals(known))
                    .findFirst();
        }

        static String forms() {
            return Arrays.stream(values()).map(kind -> kind.form).collect(Collectors.joining(", "));
        }
    }

    /**
     * Reads a URL.
     *
     * @throws IllegalArgumentException with a sentence that says what is wrong
     */
    public static EndpointUrl parse(String text) {
        Matcher parts = SCHEME.matcher(text.strip());
        if (!parts.matches()) {
            throw new IllegalArgumentException("\"" + text + "\" is no endpoint; write one of " + Kind.forms()
                    + ", such as udpserver://127.0.0.1:14550.");
        }
        String scheme = parts.group(1).toLowerCase(Locale.ROOT);
        Kind kind = Kind.ofScheme(scheme)
                .orElseThrow(() -> new IllegalArgumentException(
                        "\"" + text + "\" begins with " + scheme + "://; known are " + Kind.forms() + "."));
        return kind == Kind.SERIAL ? device(text, parts.group(2)) : address(text, kind, parts.group(2));
    }

    private static EndpointUrl address(String text, Kind kind, String rest) {
        Matcher address = ADDRESS.matcher(rest);
        String path = address.matches() && address.group(3) != null ? address.group(3) : "";
        if (!address.matches() || (kind != Kind.WSCLIENT && kind != Kind.WSSCLIENT && path.length() > 1)) {
            throw new IllegalArgumentException("\"" + text + "\" is no endpoint; write " + kind.form + ".");
        }
        int port = Integer.parseInt(address.group(2));
        if (port > 65_535 || (port == 0 && !kind.isListener())) {
            throw new IllegalArgumentException("\"" + text + "\" names port " + port + "; a port is "
                    + (kind.isListener() ? "0 to 65535 (0: any free one)." : "1 to 65535."));
        }
        String kept = path.length() > 1 ? path : "";
        return new EndpointUrl(kind, address.group(1).toLowerCase(Locale.ROOT), port, kept, 0);
    }

    private static EndpointUrl device(String text, String rest) {
        Matcher device = DEVICE.matcher(rest);
        if (!device.matches()) {
            throw new IllegalArgumentException("\"" + text + "\" is no endpoint; write " + Kind.SERIAL.form + ".");
        }
        int baud = device.group(2) == null ? DEFAULT_BAUD : Integer.parseInt(device.group(2));
        if (baud < SLOWEST_BAUD || baud > FASTEST_BAUD) {
            throw new IllegalArgumentException("\"" + text + "\" names " + baud + " baud; " + SLOWEST_BAUD + " to "
                    + FASTEST_BAUD + " are allowed.");
        }
        return new EndpointUrl(Kind.SERIAL, "", 0, device.group(1), baud);
    }

    EndpointUrl withPort(int bound) {
        return new EndpointUrl(kind, host, bound, path, baud);
    }

    @Override
    public String toString() {
        return kind == Kind.SERIAL
                ? "serial://" + path + "?baud=" + baud
                : kind.scheme() + "://" + host + ":" + port + path;
    }
}
