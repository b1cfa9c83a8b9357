package org.dronemap.ws.wiring;

import org.dronemap.store.parquet.ParquetTrackWriter;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.drone.DroneViewMapper;
import org.dronemap.ws.enrol.EnrolmentService;
import org.dronemap.ws.history.FlightService;
import org.dronemap.ws.history.TelemetryExporter;
import org.dronemap.ws.history.TelemetryService;
import org.dronemap.ws.link.DtlsKeyService;
import org.dronemap.ws.link.LinkSecurityService;
import org.dronemap.ws.organisation.GrantChanges;
import org.dronemap.ws.organisation.OrganisationService;
import org.dronemap.ws.recording.RecordingService;
import org.dronemap.ws.recording.ReplayService;
import org.dronemap.ws.recording.TlogExporter;
import org.dronemap.ws.server.ServerComponents;
import org.dronemap.ws.settings.ServerSettings;
import org.dronemap.ws.zone.ZoneService;

/** The use cases of a {@link SteppedServer} around links, recordings and what is remembered. */
public record SteppedLinkServices(
        LinkSecurityService linkSecurity,
        EnrolmentService waiting,
        RecordingService recordings,
        ReplayService replays,
        FlightService flights,
        TelemetryService telemetry,
        TelemetryExporter files,
        DtlsKeyService dtlsKeys) {

    static SteppedLinkServices of(
            ServerComponents house,
            ServerSettings settings,
            DroneService drones,
            DroneViewMapper views,
            ZoneService zones) {
        ServiceConfiguration services = new ServiceConfiguration();
        GrantConfiguration granting = new GrantConfiguration();
        GrantChanges grants = granting.grantChanges(house);
        OrganisationService organisations =
                granting.organisationService(house, grants, zones, house.time().clock());
        ReplayService replays = services.replayService(house, granting.replayOwners(house), settings);
        FlightService flights = services.flightService(house);
        return new SteppedLinkServices(
                services.linkSecurityService(house, drones),
                services.waitingService(house, views, organisations),
                services.recordingService(house, replays),
                replays,
                flights,
                services.telemetryService(house, drones, flights, house.time().clock()),
                new TelemetryExporter(
                        house.history().telemetry(),
                        new TlogExporter(house.archive()),
                        new ParquetTrackWriter(),
                        settings.dataDirectory()),
                services.dtlsKeyService(house, house.time().clock()));
    }
}
