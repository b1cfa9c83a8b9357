package org.dronemap.ws.history;

import java.io.IOException;
import java.io.Writer;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.VisibilityLevel;
import org.dronemap.core.history.Flight;
import org.dronemap.core.history.FlightQuery;
import org.dronemap.core.history.FlightRegistry;
import org.dronemap.core.recording.Recording;
import org.dronemap.core.recording.RecordingArchive;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.problem.DroneProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.Csv;
import org.jspecify.annotations.Nullable;

/** Lists and shows flights for users, stores their notes and writes the logbook. Any thread. */
public final class FlightService {
    private static final int USUAL = 50;
    private static final int MOST = 200;
    private static final List<String> LOGBOOK = List.of(
            "flight",
            "drone",
            "droneName",
            "start",
            "end",
            "state",
            "seconds",
            "distanceMeters",
            "highestMeters",
            "fastestMetersPerSecond",
            "farthestMeters",
            "batteryUsedPercent",
            "fromLatitude",
            "fromLongitude",
            "lastLatitude",
            "lastLongitude",
            "users",
            "operation",
            "notice",
            "notes");

    private final FlightRegistry flights;
    private final RecordingArchive recordings;

    public FlightService(FlightRegistry flights, RecordingArchive recordings) {
        this.flights = flights;
        this.recordings = recordings;
    }

    /** Newest first; {@code before}: the id of the last flight of the page before. */
    public FlightView.Flights page(
            Principal principal, FlightSearchRequest search, @Nullable String before, @Nullable Integer limit) {
        int most = limit(limit);
        FlightQuery query = search.query();
        Flight after = before == null || before.isBlank() ? null : after(principal, before);
        List<Flight> found = seen(principal, query, after, most + 1);
        List<Flight> page = found.size() > most ? found.subList(0, most) : found;
        List<Recording> known = recordings.recordings();
        return new FlightView.Flights(
                page.stream().map(flight -> view(principal, flight, known)).toList(),
                found.size() > most ? page.get(most - 1).id() : null);
    }

    private static int limit(@Nullable Integer limit) {
        if (limit == null) {
            return USUAL;
        }
        if (limit < 1 || limit > MOST) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    "limit",
                    "1 to " + MOST,
                    limit,
                    ProblemParameter.LEAST.is(1),
                    ProblemParameter.MOST.is(MOST));
        }
        return limit;
    }

    private Flight after(Principal principal, String id) {
        return flights.flight(id)
                .filter(flight -> sight(principal, flight) != VisibilityLevel.NONE)
                .orElseThrow(() -> InvalidInput.outside(
                        ValueProblem.REFERENCE_UNKNOWN, "before", "the id of a flight", "\"" + id + "\""));
    }

    /** Rights are not the store's: it is asked again until there are enough that the asker sees. */
    private List<Flight> seen(Principal principal, FlightQuery query, @Nullable Flight after, int most) {
        List<Flight> seen = new ArrayList<>();
        Flight last = after;
        while (seen.size() < most) {
            List<Flight> some = flights.flights(query, last, MOST);
            some.stream().filter(flight -> isFound(principal, query, flight)).forEach(seen::add);
            if (some.size() < MOST) {
                break;
            }
            last = some.get(MOST - 1);
        }
        return seen.size() > most ? seen.subList(0, most) : seen;
    }

    /** Who looks for people or words finds nothing where these are not shown. */
    private static boolean isFound(Principal principal, FlightQuery query, Flight flight) {
        return switch (sight(principal, flight)) {
            case NONE -> false;
            case WITHOUT_NAMES -> query.user() == null && query.words() == null;
            case ALL -> true;
        };
    }

    /** A flight belongs to whom the drone belonged to when it began: nobody gives one away that flies. */
    private static VisibilityLevel sight(Principal principal, Flight flight) {
        return principal.sight(flight.drone(), flight.start());
    }

    private static Flight shown(Principal principal, Flight flight) {
        return sight(principal, flight) == VisibilityLevel.ALL ? flight : NameRedaction.flight(flight);
    }

    public FlightView flight(Principal principal, String id) {
        return view(principal, find(principal, id), recordings.recordings());
    }

    public FlightView annotate(Principal principal, String id, FlightNotes notes) {
        RoleChecks.require(principal, Role.OPERATOR);
        String written = notes.checked();
        Flight flight = find(principal, id);
        RoleChecks.require(principal, Role.OPERATOR, flight.drone());
        if (sight(principal, flight) != VisibilityLevel.ALL) {
            throw Rejection.of(
                    DroneProblem.OF_ANOTHER_ORGANISATION,
                    "The drone was another organisation's then; only that one writes notes.");
        }
        flights.annotate(id, written);
        return flight(principal, id);
    }

    /** All that are looked for, as a table; page by page, so that a slow reader holds nothing up. */
    public void logbook(Principal principal, FlightSearchRequest search, Writer out) throws IOException {
        FlightQuery query = search.query();
        out.write(Csv.line(LOGBOOK));
        List<Flight> page = seen(principal, query, null, MOST);
        while (!page.isEmpty()) {
            for (Flight flight : page) {
                out.write(row(FlightView.of(shown(principal, flight), List.of())));
            }
            page = page.size() < MOST ? List.of() : seen(principal, query, page.get(MOST - 1), MOST);
        }
    }

    private static String row(FlightView flight) {
        FlightView.SpotView from = flight.takeOff();
        FlightView.SpotView last = flight.last();
        return Csv.line(Arrays.asList(
                flight.id(),
                flight.drone(),
                flight.droneName(),
                flight.start(),
                flight.end(),
                flight.state(),
                flight.seconds(),
                flight.distance(),
                flight.highest(),
                flight.fastest(),
                flight.farthest(),
                flight.battery().used(),
                from == null ? null : from.latitude(),
                from == null ? null : from.longitude(),
                last == null ? null : last.latitude(),
                last == null ? null : last.longitude(),
                String.join(" ", flight.users()),
                flight.operation(),
                flight.notice(),
                flight.notes()));
    }

    /** What the asker may not see is told from what is not there by nothing. */
    Flight find(Principal principal, String id) {
        return flights.flight(id)
                .filter(flight -> sight(principal, flight) != VisibilityLevel.NONE)
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.FLIGHT, id));
    }

    private static FlightView view(Principal principal, Flight flight, List<Recording> known) {
        return FlightView.of(
                shown(principal, flight),
                known.stream()
                        .filter(recording -> isOf(recording, flight))
                        .map(Recording::id)
                        .toList());
    }

    private static boolean isOf(Recording recording, Flight flight) {
        Instant end = recording.end();
        Instant until = flight.end() == null ? flight.lastHeardAt() : flight.end();
        return recording.drone().equals(flight.drone())
                && !recording.start().isAfter(until)
                && (end == null || !end.isBefore(flight.start()));
    }
}
