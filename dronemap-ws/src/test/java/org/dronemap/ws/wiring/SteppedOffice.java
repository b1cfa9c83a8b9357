package org.dronemap.ws.wiring;

import org.dronemap.store.parquet.ParquetTrack;
import org.dronemap.ws.service.DroneService;
import org.dronemap.ws.service.DroneViews;
import org.dronemap.ws.service.DtlsKeyService;
import org.dronemap.ws.service.FlightService;
import org.dronemap.ws.service.GrantChanges;
import org.dronemap.ws.service.LinkSecurityService;
import org.dronemap.ws.service.OrganisationService;
import org.dronemap.ws.service.RecordingService;
import org.dronemap.ws.service.ReplayService;
import org.dronemap.ws.service.TelemetryFiles;
import org.dronemap.ws.service.TelemetryService;
import org.dronemap.ws.service.TlogCut;
import org.dronemap.ws.service.WaitingService;
import org.dronemap.ws.service.ZoneService;

/** The use cases of a {@link SteppedServer} around links, recordings and what is remembered. */
public record SteppedOffice(
        LinkSecurityService linkSecurity,
        WaitingService waiting,
        RecordingService recordings,
        ReplayService replays,
        FlightService flights,
        TelemetryService telemetry,
        TelemetryFiles files,
        DtlsKeyService dtlsKeys) {

    static SteppedOffice of(House house, Settings settings, DroneService drones, DroneViews views, ZoneService zones) {
        ServiceConfiguration services = new ServiceConfiguration();
        GrantConfiguration granting = new GrantConfiguration();
        GrantChanges grants = granting.grantChanges(house);
        OrganisationService organisations =
                granting.organisationService(house, grants, zones, house.time().clock());
        ReplayService replays = services.replayService(house, granting.replayOwners(house), settings);
        FlightService flights = services.flightService(house);
        return new SteppedOffice(
                services.linkSecurityService(house, drones),
                services.waitingService(house, views, organisations),
                services.recordingService(house, replays),
                replays,
                flights,
                services.telemetryService(house, drones, flights, house.time().clock()),
                new TelemetryFiles(
                        house.history().telemetry(),
                        new TlogCut(house.archive()),
                        new ParquetTrack(),
                        settings.dataDirectory()),
                services.dtlsKeyService(house, house.time().clock()));
    }
}
