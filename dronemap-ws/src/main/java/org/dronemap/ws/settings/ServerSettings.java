package org.dronemap.ws.settings;

import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.history.HistoryPolicy;
import org.dronemap.core.lease.LeaseRules;
import org.dronemap.core.recording.RecordingPolicy;
import org.dronemap.core.separation.Separation;
import org.dronemap.proxy.session.Enrolment;
import org.dronemap.ws.budget.BudgetRates;
import org.dronemap.ws.environment.SetupException;
import org.dronemap.ws.limit.ClientLimits;
import org.dronemap.ws.security.oidc.OidcSettings;
import org.dronemap.ws.user.RegistrationPolicy;
import org.jspecify.annotations.Nullable;

/**
 * All settings of the server, read from the environment and checked at construction.
 *
 * @param outlet where ground stations of other makers attach
 * @param robots where robots call in
 * @param enrolment from where unknown vehicles come in by themselves
 * @param databaseUrl null: the server runs its own database in the data directory
 * @param tls null: plain HTTP and WebSocket
 * @param tileAddress null: only the base map that ships
 * @param control how long control of a drone lasts, and what happens when its holder is lost
 * @param lossSeconds after which a vehicle that does not hear the cloud any more comes home by itself
 * @param history how much of drones is remembered, and for how long
 * @param mongodbUrl where telemetry is kept; null: beside everything else
 * @param linkSecret seals the keys of vehicles; null: it lies in a file of the data directory
 * @param auditKey chains the records of what was done; null: it lies in a file of the data directory
 * @param registration who may make an account
 * @param protection how much clients may cost
 * @param oidc the provider that users may sign in with; null: none
 * @param virtualSilence so long a silent drone that serves a virtual one counts as flying, beside its mission
 * @param apart what drones that follow keep from others in the air
 * @param originalAddresses SOAP and REST also at the ports of the original Dronemap Planner
 */
public record ServerSettings(
        Path dataDirectory,
        String bindAddress,
        int httpPort,
        int streamPort,
        List<String> endpoints,
        OutletSettings outlet,
        RobotSettings robots,
        Enrolment enrolment,
        @Nullable String databaseUrl,
        boolean publicMode,
        @Nullable Tls tls,
        @Nullable String tileAddress,
        Watchdog watchdog,
        LeaseRules control,
        int lossSeconds,
        RecordingPolicy recording,
        HistoryPolicy history,
        @Nullable Hidden mongodbUrl,
        @Nullable Hidden linkSecret,
        @Nullable Hidden auditKey,
        RegistrationPolicy registration,
        Protection protection,
        @Nullable OidcSettings oidc,
        Duration virtualSilence,
        Separation apart,
        boolean originalAddresses) {

    private static final int DEFAULT_HTTP_PORT = 8080;
    private static final int DEFAULT_STREAM_PORT = 8081;

    /** A secret that no log shows. */
    public record Hidden(String text) {
        public static @Nullable String shown(@Nullable Hidden hidden) {
            return hidden == null ? null : hidden.text();
        }

        @Override
        public String toString() {
            return "[hidden]";
        }
    }

    /** Limits on the load that clients, authenticated or not, may cause. */
    public record Protection(ClientLimits clients, BudgetRates rates, int streamsPerUser) {
        /** More than anybody has windows and programs, and a small part of what the server has room for. */
        public static final int DEFAULT_STREAMS = 100;

        public static final Protection DEFAULT = new Protection(ClientLimits.DEFAULT, BudgetRates.DEFAULT);

        public Protection(ClientLimits clients, BudgetRates rates) {
            this(clients, rates, DEFAULT_STREAMS);
        }
    }

    /**
     * PEM files of the certificate chain and its private key.
     *
     * @param authority the local authority that signed it, which phones are to trust; null: one that everybody trusts did
     * @param phonePort where phones are told so, by plain HTTP
     */
    public record Tls(Path certificate, Path key, @Nullable Path authority, int phonePort) {
        private static final int DEFAULT_PHONE_PORT = 8082;

        public Tls(Path certificate, Path key) {
            this(certificate, key, null, DEFAULT_PHONE_PORT);
        }
    }

    public ServerSettings {
        endpoints = List.copyOf(endpoints);
        if (httpPort != 0 && httpPort == streamPort) {
            throw new SetupException("DRONEMAP_HTTP_PORT and DRONEMAP_STREAM_PORT are both " + httpPort
                    + "; they must be different ports.");
        }
    }

    public static ServerSettings fromEnvironment(Map<String, String> environment) {
        String bind = environment.getOrDefault("DRONEMAP_BIND", "127.0.0.1").strip();
        String tile = text(environment, "DRONEMAP_TILE_ADDRESS");
        boolean publicMode = flag(environment, "DRONEMAP_PUBLIC");
        Tls tls = tls(environment);
        if (publicMode && tls == null) {
            throw new SetupException("DRONEMAP_PUBLIC is on without TLS: passwords would cross the network in clear;"
                    + " set DRONEMAP_TLS_CERT and DRONEMAP_TLS_KEY.");
        }
        if (tile != null) {
            checkTile(tile);
        }
        return new ServerSettings(
                Path.of(environment.getOrDefault("DRONEMAP_DATA_DIR", ".data")).toAbsolutePath(),
                bind,
                port(environment, "DRONEMAP_HTTP_PORT", DEFAULT_HTTP_PORT),
                port(environment, "DRONEMAP_STREAM_PORT", DEFAULT_STREAM_PORT),
                endpoints(environment, bind),
                OutletSettings.of(environment, host(bind)),
                RobotSettings.of(environment, host(bind)),
                enrolment(environment),
                text(environment, "DRONEMAP_DATABASE_URL"),
                publicMode,
                tls,
                tile,
                watchdog(environment),
                ControlSettingsReader.of(environment),
                ControlSettingsReader.lossSeconds(environment),
                RecordingSettingsReader.of(environment),
                HistorySettingsReader.of(environment),
                mongodb(environment),
                hidden(environment, "DRONEMAP_LINK_SECRET"),
                hidden(environment, "DRONEMAP_AUDIT_KEY"),
                registration(environment),
                ProtectionSettingsReader.of(environment),
                OidcSettingsReader.of(environment),
                ControlSettingsReader.virtualSilence(environment),
                SeparationSettingsReader.apart(environment),
                originalAddresses(environment, tls != null));
    }

    /** Programs of that time speak plain HTTP. */
    private static boolean originalAddresses(Map<String, String> environment, boolean encrypted) {
        boolean wanted = flag(environment, "DRONEMAP_ORIGINAL_ADDRESSES");
        if (wanted && encrypted) {
            throw new SetupException(
                    "DRONEMAP_ORIGINAL_ADDRESSES cannot be on with TLS: those addresses are plain HTTP,"
                            + " where keys and passwords cross the network in clear; leave it off, or run without TLS on an"
                            + " address that only this machine reaches.");
        }
        return wanted;
    }

    private static RegistrationPolicy registration(Map<String, String> environment) {
        String value = text(environment, "DRONEMAP_REGISTRATION");
        return switch (value == null ? "approval" : value) {
            case "approval" -> RegistrationPolicy.APPROVAL;
            case "invitation" -> RegistrationPolicy.INVITATION;
            case "off" -> RegistrationPolicy.OFF;
            default ->
                throw new SetupException(
                        "DRONEMAP_REGISTRATION must be approval, invitation or off, not \"" + value + "\".");
        };
    }

    private static @Nullable String text(Map<String, String> environment, String name) {
        String value = environment.get(name);
        return value == null || value.isBlank() ? null : value.strip();
    }

    /** It may hold a password. */
    private static @Nullable Hidden mongodb(Map<String, String> environment) {
        String url = text(environment, "DRONEMAP_MONGODB_URL");
        return url == null ? null : new Hidden(url);
    }

    private static @Nullable Hidden hidden(Map<String, String> environment, String name) {
        String value = text(environment, name);
        if (value != null && !value.matches("[0-9a-fA-F]{64}")) {
            throw new SetupException(name + " must be 64 hexadecimal digits; this one has " + value.length()
                    + " characters or others than those.");
        }
        return value == null ? null : new Hidden(value);
    }

    private static int port(Map<String, String> environment, String name, int otherwise) {
        String value = text(environment, name);
        if (value == null) {
            return otherwise;
        }
        if (value.matches("\\d{1,5}")) {
            int port = Integer.parseInt(value);
            if (port <= 65_535) {
                return port;
            }
        }
        throw new SetupException(name + " must be a port from 0 to 65535 (0: any free one), not \"" + value + "\".");
    }

    private static boolean flag(Map<String, String> environment, String name) {
        String value = text(environment, name);
        return switch (value == null ? "false" : value) {
            case "1", "true", "yes" -> true;
            case "0", "false", "no" -> false;
            default -> throw new SetupException(name + " must be true or false, not \"" + value + "\".");
        };
    }

    private static List<String> endpoints(Map<String, String> environment, String bind) {
        String value = text(environment, "DRONEMAP_ENDPOINTS");
        if (value == null) {
            return List.of("udpserver://" + host(bind) + ":14550", "tcpserver://" + host(bind) + ":5760");
        }
        return Arrays.stream(value.split(",", -1))
                .map(String::strip)
                .filter(endpoint -> !endpoint.isEmpty())
                .toList();
    }

    /** As it stands in a URL. */
    private static String host(String bind) {
        return bind.contains(":") && !bind.startsWith("[") ? "[" + bind + "]" : bind;
    }

    private static Enrolment enrolment(Map<String, String> environment) {
        String value = text(environment, "DRONEMAP_ENROLMENT");
        return switch (value == null ? "loopback" : value) {
            case "loopback" -> Enrolment.LOOPBACK;
            case "everywhere" -> Enrolment.EVERYWHERE;
            case "nowhere" -> Enrolment.NOWHERE;
            default ->
                throw new SetupException(
                        "DRONEMAP_ENROLMENT must be loopback, everywhere or nowhere, not \"" + value + "\".");
        };
    }

    private static @Nullable Tls tls(Map<String, String> environment) {
        Path certificate = file(environment, "DRONEMAP_TLS_CERT");
        Path key = file(environment, "DRONEMAP_TLS_KEY");
        if (certificate == null && key == null) {
            return null;
        }
        if (certificate == null || key == null) {
            throw new SetupException(
                    "DRONEMAP_TLS_CERT and DRONEMAP_TLS_KEY belong together; only one of them is set.");
        }
        return new Tls(
                certificate,
                key,
                file(environment, "DRONEMAP_TLS_AUTHORITY"),
                port(environment, "DRONEMAP_PHONE_PORT", Tls.DEFAULT_PHONE_PORT));
    }

    private static @Nullable Path file(Map<String, String> environment, String name) {
        String value = text(environment, name);
        if (value == null) {
            return null;
        }
        Path file = Path.of(value).toAbsolutePath();
        if (!Files.isReadable(file)) {
            throw new SetupException(name + " names the file " + file + ", which is not there or cannot be read.");
        }
        return file;
    }

    private static Watchdog watchdog(Map<String, String> environment) {
        String value = text(environment, "DRONEMAP_WATCHDOG_LOST_SECONDS");
        if (value == null) {
            return Watchdog.DEFAULT;
        }
        if (!value.matches("\\d{1,4}(\\.\\d+)?") || Double.parseDouble(value) < 2 || Double.parseDouble(value) > 600) {
            throw new SetupException("DRONEMAP_WATCHDOG_LOST_SECONDS must be 2 to 600 seconds, not \"" + value + "\".");
        }
        Duration lost = Duration.ofMillis(Math.round(Double.parseDouble(value) * 1000));
        Duration probe = lost.multipliedBy(3).dividedBy(5);
        return new Watchdog(probe, probe, lost);
    }

    private static void checkTile(String address) {
        String plain = address.replace("{s}", "a").replaceAll("[{][a-z]+[}]", "0");
        try {
            String scheme = URI.create(plain).getScheme();
            if ("http".equals(scheme) || "https".equals(scheme)) {
                return;
            }
        } catch (IllegalArgumentException notAnAddress) {
            // answered below
        }
        throw new SetupException(
                "DRONEMAP_TILE_ADDRESS must be an address such as https://tiles.example/{z}/{x}/{y}.png," + " not \""
                        + address + "\".");
    }
}
