package org.dronemap.ws.wiring;

import java.time.Duration;
import java.util.EnumMap;
import java.util.Map;
import org.dronemap.ws.guard.ClientLimits;
import org.dronemap.ws.service.Rates;
import org.dronemap.ws.service.Work;

/** What the environment says about how much clients may cost. */
final class ProtectionSettings {
    private static final Map<Work, String> RATES = Map.of(
            Work.REQUEST, "DRONEMAP_RATE_REQUESTS",
            Work.COMMAND, "DRONEMAP_RATE_COMMANDS",
            Work.EXPORT, "DRONEMAP_RATE_EXPORTS",
            Work.SIGN_IN, "DRONEMAP_RATE_SIGN_INS");
    private static final String CONNECTIONS = "DRONEMAP_CONNECTIONS_PER_ADDRESS";
    private static final String STREAMS = "DRONEMAP_STREAMS_PER_USER";
    private static final String PATIENCE = "DRONEMAP_SLOW_CLIENT_SECONDS";
    private static final int MOST_PER_SECOND = 1_000_000;
    private static final int MOST_CONNECTIONS = 2_000;
    private static final int MOST_PATIENCE = 300;

    private ProtectionSettings() {}

    static Settings.Protection of(Map<String, String> environment) {
        ClientLimits otherwise = ClientLimits.DEFAULT;
        ClientLimits clients = new ClientLimits(
                number(environment, CONNECTIONS, otherwise.connectionsPerHost(), 1, MOST_CONNECTIONS),
                otherwise.requestsPerHost(),
                Duration.ofSeconds(
                        number(environment, PATIENCE, (int) otherwise.patience().toSeconds(), 1, MOST_PATIENCE)));
        int streams = number(environment, STREAMS, Settings.Protection.DEFAULT_STREAMS, 1, MOST_CONNECTIONS);
        return new Settings.Protection(clients, rates(environment), streams);
    }

    /** 0: no bound. */
    private static Rates rates(Map<String, String> environment) {
        Map<Work, Double> rates = new EnumMap<>(Work.class);
        RATES.forEach((work, name) -> {
            double otherwise = Rates.DEFAULT.perSecond().getOrDefault(work, 0.0);
            int rate = number(environment, name, (int) otherwise, 0, MOST_PER_SECOND);
            if (rate > 0) {
                rates.put(work, (double) rate);
            }
        });
        return new Rates(rates);
    }

    private static int number(Map<String, String> environment, String name, int otherwise, int least, int most) {
        String value = environment.getOrDefault(name, "").strip();
        if (value.isEmpty()) {
            return otherwise;
        }
        if (value.matches("\\d{1,9}")) {
            int number = Integer.parseInt(value);
            if (number >= least && number <= most) {
                return number;
            }
        }
        throw new SetupException(
                name + " must be a whole number from " + least + " to " + most + ", not \"" + value + "\".");
    }
}
