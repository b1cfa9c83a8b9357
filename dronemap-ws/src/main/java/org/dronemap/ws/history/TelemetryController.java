package org.dronemap.ws.history;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.RequestCost;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.drone.DroneEventView;
import org.dronemap.ws.http.FileMediaTypes;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.reading.TelemetryPointView;
import org.dronemap.ws.security.CurrentPrincipal;
import org.springdoc.core.annotations.ParameterObject;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.ModelAttribute;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers for the stored telemetry and events of a drone, as series, points or files. */
@RestController
@RequestMapping("/api/v1/drones/{id}")
@Tag(
        name = "Telemetry",
        description =
                "What was measured of a drone over time, and what happened to it: of the last hour, unless from and"
                        + " until say otherwise.")
class TelemetryController {
    private final TelemetryService telemetry;
    private final TelemetryExporter files;
    private final CurrentPrincipal current;

    TelemetryController(TelemetryService telemetry, TelemetryExporter files, CurrentPrincipal current) {
        this.telemetry = telemetry;
        this.files = files;
        this.current = current;
    }

    @GetMapping("/telemetry")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(
            operationId = "getDroneTelemetry",
            summary = "Look at numbers over time",
            description =
                    "For each of the fields the least and the greatest value of each slot, 1000 slots unless asked"
                            + " otherwise (1 to 5000); at most 31 days.")
    public SeriesView series(@PathVariable String id, @ParameterObject @ModelAttribute TelemetrySearchRequest search) {
        return telemetry.series(telemetry.drone(current.principal(), id), search);
    }

    @GetMapping("/telemetry/points")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(
            operationId = "listDroneTelemetryPoints",
            summary = "Look at states over time",
            description =
                    "All that are kept, or when these are more than most (1 to 20000, usually 5000), so many evenly"
                            + " over the time.")
    public TelemetryPointView.Points points(
            @PathVariable String id, @ParameterObject @ModelAttribute TelemetrySearchRequest search) {
        return telemetry.points(telemetry.drone(current.principal(), id), search);
    }

    @GetMapping("/telemetry/file")
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
            operationId = "exportDroneTelemetry",
            summary = "Take telemetry along as a file",
            description =
                    "form: csv, geojson, kml, gpx, parquet (the columns of the archive) or tlog (where it was recorded).")
    public void file(
            @PathVariable String id,
            @ParameterObject @ModelAttribute TelemetrySearchRequest search,
            @RequestParam(defaultValue = "csv") String form,
            @Parameter(hidden = true) HttpServletResponse response)
            throws IOException {
        TemporaryFileResponse.send(files.export(telemetry.drone(current.principal(), id), search, form), response);
    }

    @GetMapping("/events")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(
            operationId = "listDroneEvents",
            summary = "Look at what happened to a drone",
            description = "Oldest first, at most 5000.")
    public DroneEventView.Events events(
            @PathVariable String id, @ParameterObject @ModelAttribute TelemetrySearchRequest search) {
        return telemetry.events(telemetry.drone(current.principal(), id), search);
    }
}
