package org.dronemap.ws.history;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletResponse;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import org.dronemap.core.access.Principal;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.RequestCost;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.drone.DroneEventView;
import org.dronemap.ws.http.FileMediaTypes;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.reading.TelemetryPointView;
import org.dronemap.ws.security.CurrentPrincipal;
import org.jspecify.annotations.Nullable;
import org.springdoc.core.annotations.ParameterObject;
import org.springframework.http.HttpHeaders;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.ModelAttribute;
import org.springframework.web.bind.annotation.PatchMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers that list past and current flights, with their telemetry, events, notes and logbook. */
@RestController
@RequestMapping("/api/v1/flights")
@Tag(
        name = "Flights",
        description = "Each flight from arming to disarming, or until the drone was heard no more: who, where, how far,"
                + " what was measured and what happened.")
class FlightController {
    private final FlightService flights;
    private final TelemetryService telemetry;
    private final TelemetryExporter files;
    private final CurrentPrincipal current;

    FlightController(
            FlightService flights, TelemetryService telemetry, TelemetryExporter files, CurrentPrincipal current) {
        this.flights = flights;
        this.telemetry = telemetry;
        this.files = files;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(
            operationId = "listFlights",
            summary = "Look for flights",
            description =
                    "Newest first, 50 unless limit says otherwise (1 to 200); go on with before = next. Times are as"
                            + " 2026-03-04T05:06:07Z.")
    public FlightView.Flights flights(
            @ParameterObject @ModelAttribute FlightSearchRequest search,
            @RequestParam(required = false) @Nullable String before,
            @RequestParam(required = false) @Nullable Integer limit) {
        return flights.page(current.principal(), search, before, limit);
    }

    @GetMapping("/logbook")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE, costs = RequestCost.EXPORT)
    @FileMediaTypes(produces = "text/csv")
    @Operation(operationId = "exportLogbook", summary = "Take all flights that are looked for along as a table (CSV)")
    public void logbook(
            @ParameterObject @ModelAttribute FlightSearchRequest search,
            @Parameter(hidden = true) HttpServletResponse response)
            throws IOException {
        Principal principal = current.principal();
        response.setContentType("text/csv;charset=UTF-8");
        response.setHeader(HttpHeaders.CONTENT_DISPOSITION, "attachment; filename=\"logbook.csv\"");
        Writer out = new BufferedWriter(new OutputStreamWriter(response.getOutputStream(), StandardCharsets.UTF_8));
        flights.logbook(principal, search, out);
        out.flush();
    }

    @GetMapping("/{id}")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(operationId = "getFlight", summary = "Look at one flight")
    public FlightView flight(@PathVariable String id) {
        return flights.flight(current.principal(), id);
    }

    @PatchMapping("/{id}")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.DRONE)
    @Operation(operationId = "annotateFlight", summary = "Write notes about a flight (operator)")
    public FlightView annotate(@PathVariable String id, @RequestBody FlightNotes notes) {
        return flights.annotate(current.principal(), id, notes);
    }

    @GetMapping("/{id}/telemetry")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(
            operationId = "getFlightTelemetry",
            summary = "Look at numbers over a flight",
            description =
                    "For each of the fields the least and the greatest value of each slot, 1000 slots unless asked"
                            + " otherwise (1 to 5000); from and until make it a part of the flight.")
    public SeriesView series(@PathVariable String id, @ParameterObject @ModelAttribute TelemetrySearchRequest search) {
        return telemetry.series(telemetry.flight(current.principal(), id), search);
    }

    @GetMapping("/{id}/telemetry/points")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(
            operationId = "listFlightTelemetryPoints",
            summary = "Look at the states of a flight",
            description =
                    "All that are kept, or when these are more than most (1 to 20000, usually 5000), so many evenly"
                            + " over the time.")
    public TelemetryPointView.Points points(
            @PathVariable String id, @ParameterObject @ModelAttribute TelemetrySearchRequest search) {
        return telemetry.points(telemetry.flight(current.principal(), id), search);
    }

    @GetMapping("/{id}/telemetry/file")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE, costs = RequestCost.EXPORT)
    @ResponseStatuses(refuses = 409)
    @FileMediaTypes(
            produces = {
                "text/csv",
                "application/geo+json",
                "application/vnd.google-earth.kml+xml",
                "application/gpx+xml",
                "application/vnd.apache.parquet",
                "application/octet-stream"
            })
    @Operation(
            operationId = "exportFlightTelemetry",
            summary = "Take a flight along as a file",
            description =
                    "form: csv, geojson, kml, gpx, parquet (the columns of the archive) or tlog (where it was recorded).")
    public void file(
            @PathVariable String id,
            @ParameterObject @ModelAttribute TelemetrySearchRequest search,
            @RequestParam(defaultValue = "csv") String form,
            @Parameter(hidden = true) HttpServletResponse response)
            throws IOException {
        TemporaryFileResponse.send(files.export(telemetry.flight(current.principal(), id), search, form), response);
    }

    @GetMapping("/{id}/events")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(
            operationId = "listFlightEvents",
            summary = "Look at what happened in a flight",
            description =
                    "Messages, modes, commands with their outcomes and so on, from ten seconds before to ten after.")
    public DroneEventView.Events events(
            @PathVariable String id, @ParameterObject @ModelAttribute TelemetrySearchRequest search) {
        return telemetry.events(telemetry.flight(current.principal(), id), search);
    }
}
