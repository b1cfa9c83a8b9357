package org.dronemap.ws.soap;

import java.util.List;
import java.util.function.Supplier;
import org.dronemap.ws.service.FlightSearch;
import org.dronemap.ws.service.FlightService;
import org.dronemap.ws.service.Outages;
import org.jspecify.annotations.Nullable;

/** Flights over SOAP. Any thread. */
public final class SoapFlights {
    private final SoapCaller caller;
    private final FlightService flights;
    private final Outages outages;

    public SoapFlights(SoapCaller caller, FlightService flights, Outages outages) {
        this.caller = caller;
        this.flights = flights;
        this.outages = outages;
    }

    List<SoapFlight> some(FlightSearch search, @Nullable String before) {
        return found(() -> flights.page(caller.reading(), search, before, null).flights().stream()
                .map(SoapFlight::of)
                .toList());
    }

    SoapFlight one(@Nullable String id) {
        return found(() -> SoapFlight.of(flights.flight(caller.reading(), id == null ? "" : id)));
    }

    private <T> T found(Supplier<T> work) {
        try {
            return work.get();
        } catch (RuntimeException e) {
            throw outages.of(e).<RuntimeException>map(outage -> outage).orElse(e);
        }
    }
}
