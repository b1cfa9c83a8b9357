package org.dronemap.proxy.mavlink.translate;

import java.time.Duration;
import java.util.function.Supplier;
import org.dronemap.core.command.Outcome;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.mavlink.procedure.Alternative;
import org.dronemap.proxy.mavlink.procedure.CommandExchange;
import org.dronemap.proxy.mavlink.procedure.CommandRequest;
import org.dronemap.proxy.mavlink.procedure.Exchange;

/** Makes the exchange that returns an ArduPilot plane by its landing sequence, or else by its return mode. */
final class PlaneReturns {
    private static final String AUTO = "AUTO";
    private static final Duration TO_BEGIN = Duration.ofSeconds(5);
    private static final String CIRCLES = "Its mission has no landing sequence (DO_LAND_START): unless it lands on"
            + " rotors, it flies home and circles there until it is landed by its pilot or by a mission, or its battery is"
            + " empty.";

    private PlaneReturns() {}

    /** {@code home}: the mode in which it flies home. */
    static Exchange begin(Cockpit cockpit, Supplier<Exchange> home) {
        CommandRequest.Proof proof = new CommandRequest.Proof(
                () -> cockpit.status().inMode(AUTO),
                TO_BEGIN,
                "The vehicle accepted the landing sequence, but does not fly it after 5 s.",
                Heartbeat.ID);
        CommandExchange landing = new CommandExchange(
                cockpit.target(),
                CommandRequest.ofLong(
                        cockpit.target(),
                        MissionCodec.DO_LAND_START,
                        new float[0],
                        CommandRequest.Retry.REPEATABLE,
                        proof),
                cockpit.observer());
        return new Alternative(landing, ended -> !(ended instanceof Outcome.Succeeded), () -> {
            cockpit.warning().accept(CIRCLES);
            return home.get();
        });
    }
}
