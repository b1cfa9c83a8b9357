package org.dronemap.ws.settings;

import java.time.Duration;
import java.util.EnumMap;
import java.util.Map;
import org.dronemap.ws.budget.BudgetRates;
import org.dronemap.ws.budget.WorkKind;
import org.dronemap.ws.environment.EnvironmentVariables;
import org.dronemap.ws.limit.ClientLimits;

/** Reads the limits on clients from the environment. */
final class ProtectionSettingsReader {
    private static final Map<WorkKind, String> RATES = Map.of(
            WorkKind.REQUEST, "DRONEMAP_RATE_REQUESTS",
            WorkKind.COMMAND, "DRONEMAP_RATE_COMMANDS",
            WorkKind.EXPORT, "DRONEMAP_RATE_EXPORTS",
            WorkKind.SIGN_IN, "DRONEMAP_RATE_SIGN_INS");
    private static final String CONNECTIONS = "DRONEMAP_CONNECTIONS_PER_ADDRESS";
    private static final String STREAMS = "DRONEMAP_STREAMS_PER_USER";
    private static final String PATIENCE = "DRONEMAP_SLOW_CLIENT_SECONDS";
    private static final int MOST_PER_SECOND = 1_000_000;
    private static final int MOST_CONNECTIONS = 2_000;
    private static final int MOST_PATIENCE = 300;

    private ProtectionSettingsReader() {}

    static ServerSettings.Protection of(Map<String, String> environment) {
        EnvironmentVariables variables = new EnvironmentVariables(environment);
        ClientLimits otherwise = ClientLimits.DEFAULT;
        ClientLimits clients = new ClientLimits(
                variables.whole(CONNECTIONS, 1, MOST_CONNECTIONS, otherwise.connectionsPerHost()),
                otherwise.requestsPerHost(),
                Duration.ofSeconds(variables.whole(
                        PATIENCE, 1, MOST_PATIENCE, (int) otherwise.patience().toSeconds())));
        int streams = variables.whole(STREAMS, 1, MOST_CONNECTIONS, ServerSettings.Protection.DEFAULT_STREAMS);
        return new ServerSettings.Protection(clients, rates(variables), streams);
    }

    /** 0: no bound. */
    private static BudgetRates rates(EnvironmentVariables variables) {
        Map<WorkKind, Double> rates = new EnumMap<>(WorkKind.class);
        RATES.forEach((work, name) -> {
            double otherwise = BudgetRates.DEFAULT.perSecond().getOrDefault(work, 0.0);
            int rate = variables.whole(name, 0, MOST_PER_SECOND, (int) otherwise);
            if (rate > 0) {
                rates.put(work, (double) rate);
            }
        });
        return new BudgetRates(rates);
    }
}
