package org.dronemap.ws.soap;

import java.time.Duration;
import org.dronemap.core.access.Principal;
import org.dronemap.ws.service.CommandRequest;
import org.dronemap.ws.service.CommandService;
import org.dronemap.ws.service.CommandView;
import org.dronemap.ws.service.Rejection;

/** Commands over SOAP. Any thread; an action keeps its own for up to 30 s. */
public final class SoapActions {
    private static final Duration LONGEST_WAIT = Duration.ofSeconds(30);

    private final SoapCaller caller;
    private final CommandService commands;

    public SoapActions(SoapCaller caller, CommandService commands) {
        this.caller = caller;
        this.commands = commands;
    }

    SoapOutcome one(String command) {
        return SoapOutcome.of(commands.command(caller.reading(), command));
    }

    SoapOutcome act(String droneId, CommandRequest request) throws DronemapFault {
        return Answering.answer(() -> {
            Principal principal = caller.principal();
            try {
                CommandView sent = commands.submit(principal, "soap", droneId, request);
                return SoapOutcome.of(commands.awaitEnd(sent, LONGEST_WAIT).join());
            } catch (Rejection refused) {
                String id = refused.commandId();
                if (id == null) {
                    throw refused;
                }
                return SoapOutcome.refused(id, refused);
            }
        });
    }
}
