package org.dronemap.ws.wiring;

import java.time.Clock;
import java.util.Map;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.store.parquet.ParquetTrackWriter;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.drone.DroneViewMapper;
import org.dronemap.ws.enrol.EnrolmentService;
import org.dronemap.ws.environment.EnvironmentVariables;
import org.dronemap.ws.history.FlightService;
import org.dronemap.ws.history.TelemetryExporter;
import org.dronemap.ws.history.TelemetryService;
import org.dronemap.ws.link.DtlsKeyService;
import org.dronemap.ws.link.LinkSecurityService;
import org.dronemap.ws.organisation.GrantChanges;
import org.dronemap.ws.organisation.OrganisationService;
import org.dronemap.ws.recording.RecordingService;
import org.dronemap.ws.recording.ReplayOwners;
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
        Clock clock = house.time().clock();
        CloudManager cloud = house.cloud();
        GrantChanges grants = new GrantChanges(house.grants(), house.grantBook());
        OrganisationService organisations = new OrganisationService(
                grants, house.access(), cloud, zones, clock, new EnvironmentVariables(Map.of()));
        ReplayOwners owners = ReplayOwners.of(house.grantBook(), cloud);
        ReplayService replays = new ReplayService(house.recordings(), owners, settings.dataDirectory());
        FlightService flights = new FlightService(house.history().flights(), house.archive());
        return new SteppedLinkServices(
                new LinkSecurityService(house.linkSecurity(), drones, house.time()),
                new EnrolmentService(cloud, views, organisations),
                new RecordingService(house.archive(), replays),
                replays,
                flights,
                new TelemetryService(house.history().telemetry(), drones, flights, clock),
                new TelemetryExporter(
                        house.history().telemetry(),
                        new TlogExporter(house.archive()),
                        new ParquetTrackWriter(),
                        settings.dataDirectory()),
                new DtlsKeyService(house.links().keys(), house.links().vehicles(), cloud, clock));
    }
}
