package org.dronemap.ws.service;

import java.util.List;
import org.dronemap.core.history.Flight;
import org.dronemap.core.history.HistoryEvent;

/** What a drone did while it belonged to others, without the names of their people and the words that they wrote. */
final class Nameless {
    /** Stands for whoever it was. */
    static final String OTHERS = "another organisation";

    private Nameless() {}

    static Flight flight(Flight flight) {
        return new Flight(
                flight.id(),
                flight.drone(),
                flight.droneName(),
                flight.start(),
                flight.end(),
                flight.state(),
                flight.heard(),
                flight.measures(),
                flight.users().isEmpty() ? List.of() : List.of(OTHERS),
                null,
                flight.notice(),
                "");
    }

    static HistoryEvent event(HistoryEvent event) {
        boolean names = event.kind() == HistoryEvent.Kind.CONTROL
                || (event.kind() == HistoryEvent.Kind.MESSAGE && event.by() != null);
        return new HistoryEvent(
                event.drone(),
                event.at(),
                event.kind(),
                names ? "Control changed." : event.text(),
                event.severity(),
                event.by() == null ? null : OTHERS,
                event.command(),
                event.result(),
                null);
    }

    static CommandView command(CommandView command) {
        CommandView.OutcomeView outcome = command.outcome();
        return new CommandView(
                command.id(),
                command.drone(),
                OTHERS,
                command.face(),
                command.type(),
                command.summary(),
                command.at(),
                command.phase(),
                outcome == null ? null : new CommandView.OutcomeView(outcome.result(), outcome.by(), null),
                command.finishedAt(),
                command.progress(),
                command.epoch(),
                List.of());
    }
}
