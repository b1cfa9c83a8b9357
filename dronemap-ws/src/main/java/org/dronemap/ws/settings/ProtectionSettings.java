package org.dronemap.ws.settings;

import java.time.Duration;
import java.util.EnumMap;
import java.util.Map;
import org.dronemap.ws.budget.Rates;
import org.dronemap.ws.budget.Work;
import org.dronemap.ws.guard.ClientLimits;
import org.dronemap.ws.setting.Variables;

/** Reads the limits on clients from the environment. */
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
        Variables variables = new Variables(environment);
        ClientLimits otherwise = ClientLimits.DEFAULT;
        ClientLimits clients = new ClientLimits(
                variables.whole(CONNECTIONS, 1, MOST_CONNECTIONS, otherwise.connectionsPerHost()),
                otherwise.requestsPerHost(),
                Duration.ofSeconds(variables.whole(
                        PATIENCE, 1, MOST_PATIENCE, (int) otherwise.patience().toSeconds())));
        int streams = variables.whole(STREAMS, 1, MOST_CONNECTIONS, Settings.Protection.DEFAULT_STREAMS);
        return new Settings.Protection(clients, rates(variables), streams);
    }

    /** 0: no bound. */
    private static Rates rates(Variables variables) {
        Map<Work, Double> rates = new EnumMap<>(Work.class);
        RATES.forEach((work, name) -> {
            double otherwise = Rates.DEFAULT.perSecond().getOrDefault(work, 0.0);
            int rate = variables.whole(name, 0, MOST_PER_SECOND, (int) otherwise);
            if (rate > 0) {
                rates.put(work, (double) rate);
            }
        });
        return new Rates(rates);
    }
}
