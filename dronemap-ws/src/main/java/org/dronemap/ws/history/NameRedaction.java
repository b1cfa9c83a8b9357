package org.dronemap.ws.history;

import java.util.List;
import java.util.regex.Pattern;
import org.dronemap.core.history.Flight;
import org.dronemap.core.history.HistoryEvent;

/** Removes names of people and their words from a drone's history of the time when another organisation owned it. */
public final class NameRedaction {
    /** Stands for whoever it was. */
    public static final String OTHERS = "another organisation";

    /** Earlier versions kept messages about control without saying whom they name. */
    private static final Pattern OF_CONTROL = Pattern.compile("handed control over to |took control over from"
            + "|, who had control, |Nobody took control after | and has control now");

    private NameRedaction() {}

    static Flight flight(Flight flight) {
        return new Flight(
                flight.id(),
                flight.drone(),
                flight.droneName(),
                flight.start(),
                flight.end(),
                flight.state(),
                flight.lastHeardAt(),
                flight.measures(),
                flight.users().isEmpty() ? List.of() : List.of(OTHERS),
                null,
                flight.notice(),
                "");
    }

    static HistoryEvent event(HistoryEvent event) {
        boolean names = event.kind() == HistoryEvent.Kind.CONTROL
                || (event.kind() == HistoryEvent.Kind.MESSAGE
                        && (event.by() != null
                                || OF_CONTROL.matcher(event.text()).find()));
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
}
