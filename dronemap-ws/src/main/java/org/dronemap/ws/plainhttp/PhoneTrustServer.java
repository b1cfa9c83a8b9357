package org.dronemap.ws.plainhttp;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.cert.CertificateEncodingException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/**
 * Plain HTTP server with one page, from which phones get the certificate authority of a server that uses TLS. A server
 * of its own, so that nothing else can ever be had by it. Any thread.
 */
public final class PhoneTrustServer implements AutoCloseable {
    private static final String CERTIFICATE = "/dronemap-authority.crt";
    private static final int THREADS = 2;
    private static final int WAITING = 64;
    private static final int CLOSING_SECONDS = 1;
    /** Seconds for which a client may take to ask, and to take the answer. */
    private static final String PATIENCE = "10";

    private final HttpServer server;
    private final ExecutorService workers;
    private final PhoneTrustPage page;
    private final byte[] authority;

    /**
     * Address and port of the server, and the certificates and TLS port that it announces.
     *
     * @param authority PEM file of the authority that signed the certificate
     * @param certificate PEM file of the server's certificate
     * @param securePort where the server speaks TLS
     */
    public record Configuration(String address, int port, Path authority, Path certificate, int securePort) {
        /** What a phone opens first. */
        public String url() throws IOException {
            String name = LocalCertificateAuthority.read(authority, certificate).name();
            return "http://" + (name.contains(":") ? "[" + name + "]" : name) + ":" + port + "/";
        }
    }

    private PhoneTrustServer(HttpServer server, PhoneTrustPage page, byte[] authority) {
        this.server = server;
        this.page = page;
        this.authority = authority;
        workers = new ThreadPoolExecutor(
                THREADS,
                THREADS,
                1,
                TimeUnit.MINUTES,
                new LinkedBlockingQueue<>(WAITING),
                task -> {
                    Thread thread = new Thread(task, "phone-door");
                    thread.setDaemon(true);
                    return thread;
                },
                new ThreadPoolExecutor.CallerRunsPolicy());
    }

    /** Opens it; fails when the port is taken or the certificates cannot be read. */
    public static PhoneTrustServer open(Configuration place) throws IOException {
        LocalCertificateAuthority authority = LocalCertificateAuthority.read(place.authority(), place.certificate());
        System.setProperty("sun.net.httpserver.maxReqTime", PATIENCE);
        System.setProperty("sun.net.httpserver.maxRspTime", PATIENCE);
        byte[] encoded;
        try {
            encoded = authority.certificate().getEncoded();
        } catch (CertificateEncodingException e) {
            throw new IOException("The certificate " + place.authority() + " cannot be handed out.", e);
        }
        HttpServer server = HttpServer.create(new InetSocketAddress(place.address(), place.port()), WAITING);
        PhoneTrustServer door =
                new PhoneTrustServer(server, new PhoneTrustPage(authority, place.securePort()), encoded);
        server.setExecutor(door.workers);
        server.createContext("/", door::answer);
        server.start();
        return door;
    }

    public int port() {
        return server.getAddress().getPort();
    }

    private void answer(HttpExchange exchange) throws IOException {
        try (exchange) {
            Headers headers = exchange.getResponseHeaders();
            headers.set("X-Content-Type-Options", "nosniff");
            headers.set("Cache-Control", "no-store");
            headers.set("Referrer-Policy", "no-referrer");
            headers.set(
                    "Content-Security-Policy",
                    "default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'");
            boolean reads = exchange.getRequestMethod().equals("GET");
            if (!reads && !exchange.getRequestMethod().equals("HEAD")) {
                headers.set("Allow", "GET, HEAD");
                exchange.sendResponseHeaders(405, -1);
            } else if (exchange.getRequestURI().getPath().equals(CERTIFICATE)) {
                headers.set("Content-Disposition", "attachment; filename=dronemap-authority.crt");
                send(exchange, "application/x-x509-ca-cert", authority);
            } else {
                String host = exchange.getRequestHeaders().getFirst("Host");
                send(
                        exchange,
                        "text/html; charset=utf-8",
                        page.html(nameOf(host), port()).getBytes(StandardCharsets.UTF_8));
            }
        }
    }

    private static void send(HttpExchange exchange, String type, byte[] body) throws IOException {
        exchange.getResponseHeaders().set("Content-Type", type);
        if (exchange.getRequestMethod().equals("HEAD")) {
            exchange.sendResponseHeaders(200, -1);
        } else {
            exchange.sendResponseHeaders(200, body.length);
            exchange.getResponseBody().write(body);
        }
    }

    private static String nameOf(@Nullable String host) {
        return host == null ? "" : host.replaceFirst(":\\d+$", "").replaceAll("[\\[\\]]", "");
    }

    @Override
    public void close() {
        server.stop(CLOSING_SECONDS);
        workers.shutdownNow();
    }
}
