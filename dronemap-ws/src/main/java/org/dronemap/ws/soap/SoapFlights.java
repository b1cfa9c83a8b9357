package org.dronemap.ws.soap;

import java.util.List;
import org.dronemap.ws.service.FlightSearch;
import org.dronemap.ws.service.FlightService;
import org.jspecify.annotations.Nullable;

/** Flights over SOAP. Any thread. */
public final class SoapFlights {
    private final SoapCaller caller;
    private final FlightService flights;

    public SoapFlights(SoapCaller caller, FlightService flights) {
        this.caller = caller;
        this.flights = flights;
    }

    List<SoapFlight> some(FlightSearch search, @Nullable String before) {
        return flights.page(caller.reading(), search, before, null).flights().stream()
                .map(SoapFlight::of)
                .toList();
    }

    SoapFlight one(@Nullable String id) {
        return SoapFlight.of(flights.flight(caller.reading(), id == null ? "" : id));
    }
}
