package org.dronemap.ws.wiring;

import java.time.Clock;
import org.dronemap.core.audit.AuditDesk;
import org.dronemap.core.time.Time;
import org.dronemap.store.parquet.ParquetTrack;
import org.dronemap.ws.account.Accounts;
import org.dronemap.ws.account.ExternalUsers;
import org.dronemap.ws.account.FirstPassword;
import org.dronemap.ws.account.PasswordHashing;
import org.dronemap.ws.audit.AuditService;
import org.dronemap.ws.budget.Budgets;
import org.dronemap.ws.command.BroadcastService;
import org.dronemap.ws.command.CommandService;
import org.dronemap.ws.control.ControlService;
import org.dronemap.ws.control.SteeringService;
import org.dronemap.ws.drone.DronePlaces;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.drone.DroneViews;
import org.dronemap.ws.drone.LeftBehindService;
import org.dronemap.ws.drone.SensingService;
import org.dronemap.ws.enrol.WaitingService;
import org.dronemap.ws.fence.FenceService;
import org.dronemap.ws.history.FlightService;
import org.dronemap.ws.history.HistoryService;
import org.dronemap.ws.history.TelemetryFiles;
import org.dronemap.ws.history.TelemetryService;
import org.dronemap.ws.key.AccessKeyService;
import org.dronemap.ws.link.DtlsKeyService;
import org.dronemap.ws.link.LinkSecurityService;
import org.dronemap.ws.link.LinkService;
import org.dronemap.ws.log.LogService;
import org.dronemap.ws.log.LogShelf;
import org.dronemap.ws.mission.MissionService;
import org.dronemap.ws.organisation.GrantChanges;
import org.dronemap.ws.organisation.OrganisationService;
import org.dronemap.ws.outlet.OutletService;
import org.dronemap.ws.parameter.ParameterService;
import org.dronemap.ws.place.PlaceNames;
import org.dronemap.ws.reading.JsonReader;
import org.dronemap.ws.reading.Secrets;
import org.dronemap.ws.recording.RecordingService;
import org.dronemap.ws.recording.ReplayOwners;
import org.dronemap.ws.recording.ReplayService;
import org.dronemap.ws.recording.TlogCut;
import org.dronemap.ws.robotkey.RobotKeyService;
import org.dronemap.ws.security.Authentication;
import org.dronemap.ws.security.CurrentPrincipal;
import org.dronemap.ws.security.FirstStart;
import org.dronemap.ws.security.oidc.OidcSettings;
import org.dronemap.ws.security.oidc.OidcSignIn;
import org.dronemap.ws.server.DroneIds;
import org.dronemap.ws.server.House;
import org.dronemap.ws.server.Version;
import org.dronemap.ws.settings.Settings;
import org.dronemap.ws.system.BackupService;
import org.dronemap.ws.system.ServerMetrics;
import org.dronemap.ws.system.SystemService;
import org.dronemap.ws.user.AccountService;
import org.dronemap.ws.user.InvitationService;
import org.dronemap.ws.user.RegistrationService;
import org.dronemap.ws.user.UserService;
import org.dronemap.ws.zone.ZoneService;
import org.jspecify.annotations.Nullable;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;

/** Constructs the use cases and the sign-in around a {@link House}. */
@Configuration(proxyBeanMethods = false)
public class ServiceConfiguration {

    @Bean
    Time time(House house) {
        return house.time();
    }

    @Bean
    Clock clock(Time time) {
        return time.clock();
    }

    @Bean
    Secrets secrets() {
        return new Secrets();
    }

    @Bean
    PasswordHashing passwordHashing(House house) {
        return house.passwords();
    }

    @Bean
    FirstPassword firstPassword(House house, PasswordHashing passwords, Secrets secrets, Settings settings) {
        return FirstStart.prepare(house.access(), passwords, secrets, settings.dataDirectory(), settings.publicMode());
    }

    @Bean
    Authentication authentication(
            House house,
            PasswordHashing passwords,
            Secrets secrets,
            FirstPassword firstPassword,
            Settings settings,
            Clock clock) {
        String localKey = FirstStart.localKey(secrets, settings.dataDirectory());
        return new Authentication(
                house.access(),
                new Authentication.Means(passwords, secrets, localKey, house.grantBook()),
                firstPassword,
                clock);
    }

    @Bean
    Accounts accounts(House house) {
        return new Accounts(house.access());
    }

    @Bean
    UserService userService(
            House house, Accounts accounts, PasswordHashing passwords, Secrets secrets, GrantChanges grants) {
        return new UserService(house.access(), accounts, passwords, secrets, grants);
    }

    @Bean
    AccountService accountService(
            House house,
            Accounts accounts,
            PasswordHashing passwords,
            Authentication authentication,
            FirstPassword firstPassword) {
        return new AccountService(house.access(), accounts, passwords, authentication, firstPassword);
    }

    @Bean
    AccessKeyService accessKeyService(House house, Accounts accounts, Secrets secrets, Clock clock) {
        return new AccessKeyService(house.access(), accounts, secrets, clock);
    }

    @Bean
    RegistrationService registrationService(
            House house,
            Accounts accounts,
            PasswordHashing passwords,
            FirstPassword firstPassword,
            Settings settings,
            Clock clock) {
        return new RegistrationService(
                house.access(), accounts, passwords, firstPassword, settings.registration(), clock);
    }

    /** Null: no provider is configured, which is an empty Optional to those who ask for one. */
    @Bean
    @Nullable
    OidcSignIn oidcSignIn(
            House house,
            Accounts accounts,
            PasswordHashing passwords,
            Authentication authentication,
            Settings settings) {
        OidcSettings oidc = settings.oidc();
        ExternalUsers users = new ExternalUsers(house.access(), accounts, passwords, new Secrets());
        return oidc == null
                ? null
                : new OidcSignIn(oidc, authentication, users, house.time().clock());
    }

    @Bean
    InvitationService invitationService(House house, OrganisationService organisations, Secrets secrets, Clock clock) {
        return new InvitationService(house.access(), organisations, secrets, clock);
    }

    @Bean
    Budgets budgets(Settings settings, Time time) {
        return new Budgets(settings.protection().rates(), time::nanos);
    }

    @Bean
    AuditDesk auditDesk(House house, Clock clock) {
        return new AuditDesk(house.audit().store(), clock, house.time()::nanos);
    }

    @Bean
    AuditService auditService(House house) {
        House.AuditSide audit = house.audit();
        return new AuditService(audit.store(), audit.keeper(), audit::verify);
    }

    @Bean
    CurrentPrincipal currentPrincipal() {
        return new CurrentPrincipal();
    }

    @Bean
    JsonReader jsonReader() {
        return new JsonReader();
    }

    @Bean
    DroneViews droneViews(House house) {
        DronePlaces places = new DronePlaces(PlaceNames.load()::near);
        house.cloud().addListener(places);
        return new DroneViews(places, house.cloud().controls(), house.cloud()::sensed, house.cloud()::cloudLoss);
    }

    @Bean
    DroneService droneService(House house, DroneViews views) {
        return new DroneService(house.cloud(), views);
    }

    @Bean
    LeftBehindService leftBehindService(House house) {
        return new LeftBehindService(house.cloud());
    }

    @Bean
    WaitingService waitingService(House house, DroneViews views, OrganisationService organisations) {
        return new WaitingService(house.cloud(), views, organisations);
    }

    @Bean
    CommandService commandService(House house, DroneService drones, Budgets budgets) {
        return new CommandService(house.cloud(), drones, budgets, house.time());
    }

    @Bean
    SteeringService steeringService(House house, DroneService drones, Budgets budgets) {
        return new SteeringService(house.cloud(), drones, budgets);
    }

    @Bean
    ControlService controlService(House house, DroneService drones, Accounts accounts) {
        return new ControlService(
                house.cloud(),
                drones,
                house.access(),
                accounts,
                house.grantBook(),
                house.links().outlet());
    }

    @Bean
    BroadcastService broadcastService(House house, CommandService commands) {
        return new BroadcastService(house.cloud(), commands);
    }

    @Bean
    ParameterService parameterService(House house, DroneService drones, CommandService commands) {
        return new ParameterService(house.cloud(), drones, commands);
    }

    @Bean
    FenceService fenceService(House house, DroneService drones, CommandService commands) {
        return new FenceService(house.cloud(), drones, commands, house.time().clock());
    }

    @Bean
    LogShelf logShelf(House house, Settings settings) {
        return new LogShelf(settings.dataDirectory().resolve("vehicle-logs"), house.time());
    }

    @Bean
    LogService logService(House house, DroneService drones, CommandService commands, LogShelf shelf) {
        return new LogService(house.cloud(), drones, commands, shelf);
    }

    @Bean
    MissionService missionService(House house, Clock clock) {
        return new MissionService(house.missions(), clock);
    }

    @Bean
    ZoneService zoneService(House house, DroneService drones, Clock clock) {
        return new ZoneService(
                new ZoneService.Keeping(house.zones(), house.cloud().zones(), house.access()), drones, clock);
    }

    @Bean
    SystemService systemService(House house, Settings settings, StreamPort stream) {
        return new SystemService(
                house.cloud(),
                new SystemService.Checks(
                        house.databaseUp(),
                        house.links().open(),
                        () -> house.history().health().isUp(),
                        () -> house.runs().operations().troubles().isEmpty(),
                        house.parts()),
                house.beginning(),
                new SystemService.SettingsView(
                        stream.number(),
                        settings.tileAddress(),
                        Version.current(),
                        settings.publicMode(),
                        PhoneDoors.url(PhoneDoors.of(settings))));
    }

    @Bean
    LinkSecurityService linkSecurityService(House house, DroneService drones) {
        return new LinkSecurityService(house.linkSecurity(), drones, house.time());
    }

    @Bean
    BackupService backupService(House house, Settings settings) {
        return new BackupService(house.backups(), settings.dataDirectory());
    }

    @Bean
    RecordingService recordingService(House house, ReplayService replays) {
        return new RecordingService(house.archive(), replays);
    }

    @Bean
    FlightService flightService(House house) {
        return new FlightService(house.history().flights(), house.archive());
    }

    @Bean
    TelemetryService telemetryService(House house, DroneService drones, FlightService flights, Clock clock) {
        return new TelemetryService(house.history().telemetry(), drones, flights, clock);
    }

    @Bean
    TelemetryFiles telemetryFiles(House house, Settings settings) {
        return new TelemetryFiles(
                house.history().telemetry(),
                new TlogCut(house.archive()),
                new ParquetTrack(),
                settings.dataDirectory());
    }

    @Bean
    HistoryService historyService(House house) {
        return new HistoryService(house.history());
    }

    @Bean
    ReplayService replayService(House house, ReplayOwners owners, Settings settings) {
        return new ReplayService(house.recordings(), owners, settings.dataDirectory());
    }

    @Bean
    OutletService outletService(House house, Accounts accounts, Secrets secrets) {
        return new OutletService(house.links().outlet(), house.access(), accounts, secrets);
    }

    @Bean
    LinkService linkService(House house, Clock clock) {
        return new LinkService(house.links().vehicles(), house.links().store(), clock);
    }

    @Bean
    DtlsKeyService dtlsKeyService(House house, Clock clock) {
        return new DtlsKeyService(house.links().keys(), house.links().vehicles(), house.cloud(), clock);
    }

    @Bean
    SensingService sensingService(House house, DroneService drones) {
        return new SensingService(house.cloud(), drones);
    }

    @Bean
    RobotKeyService robotKeyService(House house, OrganisationService organisations, Secrets secrets, Clock clock) {
        RobotKeyService.Surroundings around =
                new RobotKeyService.Surroundings(house.links().vehicles(), house.cloud(), organisations);
        return new RobotKeyService(
                house.links().robotKeys(),
                around,
                secrets,
                clock,
                new DroneIds(house.time().random()));
    }

    @Bean
    ServerMetrics serverMetrics(House house, Protections protections) {
        return new ServerMetrics(
                house.cloud(),
                house.links().vehicles(),
                protections::refusals,
                house.history()::health,
                house.links().outlet()::status);
    }
}
