package org.dronemap.ws.wiring;

import org.dronemap.store.parquet.ParquetTrack;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.drone.DroneViews;
import org.dronemap.ws.enrol.WaitingService;
import org.dronemap.ws.history.FlightService;
import org.dronemap.ws.history.TelemetryFiles;
import org.dronemap.ws.history.TelemetryService;
import org.dronemap.ws.link.DtlsKeyService;
import org.dronemap.ws.link.LinkSecurityService;
import org.dronemap.ws.organisation.GrantChanges;
import org.dronemap.ws.organisation.OrganisationService;
import org.dronemap.ws.recording.RecordingService;
import org.dronemap.ws.recording.ReplayService;
import org.dronemap.ws.recording.TlogCut;
import org.dronemap.ws.server.House;
import org.dronemap.ws.settings.Settings;
import org.dronemap.ws.zone.ZoneService;

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
