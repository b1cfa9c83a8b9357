package org.dronemap.ws.settings;

import java.time.Duration;
import java.util.Map;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.lease.LeaseRules;
import org.dronemap.core.virtual.VirtualRunMachine;
import org.dronemap.ws.environment.SetupException;

/** Reads the settings of drone control from the environment. */
final class ControlSettingsReader {
    private static final String SILENCE = "DRONEMAP_CONTROL_LOST_SECONDS";
    private static final String IDLE = "DRONEMAP_CONTROL_IDLE_SECONDS";
    private static final String ON_LOSS = "DRONEMAP_CONTROL_LOST";
    private static final String VIRTUAL_SILENCE = "DRONEMAP_VIRTUAL_SILENT_SECONDS";
    private static final String UNTIL_RETURN = "DRONEMAP_CONTROL_RETURN_SECONDS";

    private static final String CLOUD_LOSS = "DRONEMAP_CLOUD_LOSS_SECONDS";

    private ControlSettingsReader() {}

    static LeaseRules of(Map<String, String> environment) {
        LeaseRules otherwise = LeaseRules.DEFAULT;
        return new LeaseRules(
                seconds(environment, SILENCE, otherwise.silence(), 3, 60),
                seconds(environment, IDLE, otherwise.idle(), 1, 600),
                otherwise.asking(),
                onLoss(environment.getOrDefault(ON_LOSS, "").strip()),
                seconds(environment, UNTIL_RETURN, otherwise.untilReturn(), 0, 600));
    }

    /** After so long a vehicle that does not hear the cloud any more comes home by itself. */
    static int lossSeconds(Map<String, String> environment) {
        Duration usual = Duration.ofSeconds(CloudManager.Rules.USUAL_LOSS_SECONDS);
        // What lies ahead of a silent vehicle is kept for it no longer than usual.
        return (int) seconds(environment, CLOUD_LOSS, usual, 5, (int) usual.toSeconds())
                .toSeconds();
    }

    static Duration virtualSilence(Map<String, String> environment) {
        return seconds(environment, VIRTUAL_SILENCE, VirtualRunMachine.USUAL_SILENCE, 10, 900);
    }

    private static LeaseRules.OnLoss onLoss(String value) {
        return switch (value) {
            case "", "return" -> LeaseRules.OnLoss.RETURN;
            case "hold" -> LeaseRules.OnLoss.HOLD;
            case "nothing" -> LeaseRules.OnLoss.NOTHING;
            default -> throw new SetupException(ON_LOSS + " must be return, hold or nothing, not \"" + value + "\".");
        };
    }

    private static Duration seconds(
            Map<String, String> environment, String name, Duration otherwise, int least, int most) {
        String value = environment.getOrDefault(name, "").strip();
        if (value.isEmpty()) {
            return otherwise;
        }
        if (value.matches("\\d{1,3}")) {
            int seconds = Integer.parseInt(value);
            if (seconds >= least && seconds <= most) {
                return Duration.ofSeconds(seconds);
            }
        }
        throw new SetupException(
                name + " must be a whole number of seconds from " + least + " to " + most + ", not \"" + value + "\".");
    }
}
