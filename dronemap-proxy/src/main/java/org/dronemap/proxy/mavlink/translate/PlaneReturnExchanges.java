package org.dronemap.proxy.mavlink.translate;

import java.time.Duration;
import java.util.function.Supplier;
import org.dronemap.core.command.Outcome;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.mavlink.procedure.CommandExchange;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.FallbackExchange;
import org.dronemap.proxy.mavlink.procedure.MavCommandRequest;

/** Makes the exchange that returns an ArduPilot plane by its landing sequence, or else by its return mode. */
final class PlaneReturnExchanges {
    private static final String AUTO = "AUTO";
    private static final Duration TO_BEGIN = Duration.ofSeconds(5);
    private static final String CIRCLES = "Its mission has no landing sequence (DO_LAND_START): unless it lands on"
            + " rotors, it flies home and circles there until it is landed by its pilot or by a mission, or its battery is"
            + " empty.";

    private PlaneReturnExchanges() {}

    /** {@code home}: the mode in which it flies home. */
    static Exchange begin(CommandContext cockpit, Supplier<Exchange> home) {
        MavCommandRequest.CompletionCheck proof = new MavCommandRequest.CompletionCheck(
                () -> cockpit.status().inMode(AUTO),
                TO_BEGIN,
                "The vehicle accepted the landing sequence, but does not fly it after 5 s.",
                Heartbeat.ID);
        CommandExchange landing = new CommandExchange(
                cockpit.target(),
                MavCommandRequest.ofLong(
                        cockpit.target(),
                        MissionCodec.DO_LAND_START,
                        new float[0],
                        MavCommandRequest.Retry.REPEATABLE,
                        proof),
                cockpit.observer());
        return new FallbackExchange(landing, ended -> !(ended instanceof Outcome.Succeeded), () -> {
            cockpit.warning().accept(CIRCLES);
            return home.get();
        });
    }
}
