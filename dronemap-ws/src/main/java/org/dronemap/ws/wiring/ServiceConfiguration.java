package org.dronemap.ws.wiring;

import java.time.Clock;
import org.dronemap.core.audit.AuditRecorder;
import org.dronemap.core.time.Time;
import org.dronemap.store.parquet.ParquetTrackWriter;
import org.dronemap.ws.account.AccountChanges;
import org.dronemap.ws.account.ExternalUsers;
import org.dronemap.ws.account.InitialPassword;
import org.dronemap.ws.account.PasswordHashing;
import org.dronemap.ws.audit.AuditService;
import org.dronemap.ws.budget.Budgets;
import org.dronemap.ws.command.BroadcastService;
import org.dronemap.ws.command.CommandService;
import org.dronemap.ws.control.ControlService;
import org.dronemap.ws.control.SteeringService;
import org.dronemap.ws.drone.DronePlaceNames;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.drone.DroneViewMapper;
import org.dronemap.ws.drone.SensingService;
import org.dronemap.ws.drone.UnrestoredParameterService;
import org.dronemap.ws.enrol.EnrolmentService;
import org.dronemap.ws.fence.FenceService;
import org.dronemap.ws.history.FlightService;
import org.dronemap.ws.history.HistoryStatusService;
import org.dronemap.ws.history.TelemetryExporter;
import org.dronemap.ws.history.TelemetryService;
import org.dronemap.ws.key.AccessKeyService;
import org.dronemap.ws.link.DtlsKeyService;
import org.dronemap.ws.link.EndpointService;
import org.dronemap.ws.link.LinkSecurityService;
import org.dronemap.ws.log.OnboardLogArchive;
import org.dronemap.ws.log.OnboardLogService;
import org.dronemap.ws.mission.MissionService;
import org.dronemap.ws.organisation.GrantChanges;
import org.dronemap.ws.organisation.OrganisationService;
import org.dronemap.ws.outlet.OutletService;
import org.dronemap.ws.parameter.ParameterService;
import org.dronemap.ws.place.PlaceNames;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.reading.SecretGenerator;
import org.dronemap.ws.recording.RecordingService;
import org.dronemap.ws.recording.ReplayOwners;
import org.dronemap.ws.recording.ReplayService;
import org.dronemap.ws.recording.TlogExporter;
import org.dronemap.ws.robotkey.RobotKeyService;
import org.dronemap.ws.security.CallerAuthenticator;
import org.dronemap.ws.security.CurrentPrincipal;
import org.dronemap.ws.security.InitialAdministrator;
import org.dronemap.ws.security.oidc.OidcSettings;
import org.dronemap.ws.security.oidc.OidcSignIn;
import org.dronemap.ws.server.BuildVersion;
import org.dronemap.ws.server.DroneIdGenerator;
import org.dronemap.ws.server.ServerComponents;
import org.dronemap.ws.settings.ServerSettings;
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

/** Spring configuration of the sign-in and of the services that all faces share. */
@Configuration(proxyBeanMethods = false)
public class ServiceConfiguration {

    @Bean
    Time time(ServerComponents house) {
        return house.time();
    }

    @Bean
    Clock clock(Time time) {
        return time.clock();
    }

    @Bean
    SecretGenerator secrets() {
        return new SecretGenerator();
    }

    @Bean
    PasswordHashing passwordHashing(ServerComponents house) {
        return house.passwords();
    }

    @Bean
    InitialPassword firstPassword(
            ServerComponents house, PasswordHashing passwords, SecretGenerator secrets, ServerSettings settings) {
        return InitialAdministrator.prepare(
                house.access(), passwords, secrets, settings.dataDirectory(), settings.publicMode());
    }

    @Bean
    CallerAuthenticator authentication(
            ServerComponents house,
            PasswordHashing passwords,
            SecretGenerator secrets,
            InitialPassword firstPassword,
            ServerSettings settings,
            Clock clock) {
        String localKey = InitialAdministrator.localKey(secrets, settings.dataDirectory());
        return new CallerAuthenticator(
                house.access(),
                new CallerAuthenticator.Verifiers(passwords, secrets, localKey, house.grantBook()),
                firstPassword,
                clock);
    }

    @Bean
    AccountChanges accounts(ServerComponents house) {
        return new AccountChanges(house.access());
    }

    @Bean
    UserService userService(
            ServerComponents house,
            AccountChanges accounts,
            PasswordHashing passwords,
            SecretGenerator secrets,
            GrantChanges grants) {
        return new UserService(house.access(), accounts, passwords, secrets, grants);
    }

    @Bean
    AccountService accountService(
            ServerComponents house,
            AccountChanges accounts,
            PasswordHashing passwords,
            CallerAuthenticator authentication,
            InitialPassword firstPassword) {
        return new AccountService(house.access(), accounts, passwords, authentication, firstPassword);
    }

    @Bean
    AccessKeyService accessKeyService(
            ServerComponents house, AccountChanges accounts, SecretGenerator secrets, Clock clock) {
        return new AccessKeyService(house.access(), accounts, secrets, clock);
    }

    @Bean
    RegistrationService registrationService(
            ServerComponents house,
            AccountChanges accounts,
            PasswordHashing passwords,
            InitialPassword firstPassword,
            ServerSettings settings,
            Clock clock) {
        return new RegistrationService(
                house.access(), accounts, passwords, firstPassword, settings.registration(), clock);
    }

    /** Null: no provider is configured, which is an empty Optional to those who ask for one. */
    @Bean
    @Nullable
    OidcSignIn oidcSignIn(
            ServerComponents house,
            AccountChanges accounts,
            PasswordHashing passwords,
            CallerAuthenticator authentication,
            ServerSettings settings) {
        OidcSettings oidc = settings.oidc();
        ExternalUsers users = new ExternalUsers(house.access(), accounts, passwords, new SecretGenerator());
        return oidc == null
                ? null
                : new OidcSignIn(oidc, authentication, users, house.time().clock());
    }

    @Bean
    InvitationService invitationService(
            ServerComponents house, OrganisationService organisations, SecretGenerator secrets, Clock clock) {
        return new InvitationService(house.access(), organisations, secrets, clock);
    }

    @Bean
    Budgets budgets(ServerSettings settings, Time time) {
        return new Budgets(settings.protection().rates(), time::nanos);
    }

    @Bean
    AuditRecorder auditRecorder(ServerComponents house) {
        return house.audit().recorder();
    }

    @Bean
    AuditService auditService(ServerComponents house) {
        ServerComponents.AuditComponents audit = house.audit();
        return new AuditService(audit.store(), audit.keeper(), audit::verify);
    }

    @Bean
    CurrentPrincipal currentPrincipal() {
        return new CurrentPrincipal();
    }

    @Bean
    JsonCodec jsonReader() {
        return new JsonCodec();
    }

    @Bean
    DroneViewMapper droneViews(ServerComponents house) {
        DronePlaceNames places = new DronePlaceNames(PlaceNames.load()::near);
        house.cloud().addListener(places);
        return new DroneViewMapper(places, house.cloud().controls(), house.cloud()::sensed, house.cloud()::cloudLoss);
    }

    @Bean
    DroneService droneService(ServerComponents house, DroneViewMapper views) {
        return new DroneService(house.cloud(), views);
    }

    @Bean
    UnrestoredParameterService leftBehindService(ServerComponents house) {
        return new UnrestoredParameterService(house.cloud());
    }

    @Bean
    EnrolmentService waitingService(ServerComponents house, DroneViewMapper views, OrganisationService organisations) {
        return new EnrolmentService(house.cloud(), views, organisations);
    }

    @Bean
    CommandService commandService(ServerComponents house, DroneService drones, Budgets budgets) {
        return new CommandService(house.cloud(), drones, budgets, house.time());
    }

    @Bean
    SteeringService steeringService(ServerComponents house, DroneService drones, Budgets budgets) {
        return new SteeringService(house.cloud(), drones, budgets);
    }

    @Bean
    ControlService controlService(ServerComponents house, DroneService drones, AccountChanges accounts) {
        return new ControlService(
                house.cloud(),
                drones,
                house.access(),
                accounts,
                house.grantBook(),
                house.links().outlet());
    }

    @Bean
    BroadcastService broadcastService(ServerComponents house, CommandService commands) {
        return new BroadcastService(house.cloud(), commands);
    }

    @Bean
    ParameterService parameterService(ServerComponents house, DroneService drones, CommandService commands) {
        return new ParameterService(house.cloud(), drones, commands);
    }

    @Bean
    FenceService fenceService(ServerComponents house, DroneService drones, CommandService commands) {
        return new FenceService(house.cloud(), drones, commands, house.time().clock());
    }

    @Bean
    OnboardLogArchive vehicleLogArchive(ServerComponents house, ServerSettings settings) {
        return new OnboardLogArchive(settings.dataDirectory().resolve("vehicle-logs"), house.time());
    }

    @Bean
    OnboardLogService logService(
            ServerComponents house, DroneService drones, CommandService commands, OnboardLogArchive shelf) {
        return new OnboardLogService(house.cloud(), drones, commands, shelf);
    }

    @Bean
    MissionService missionService(ServerComponents house, Clock clock) {
        return new MissionService(house.missions(), clock);
    }

    @Bean
    ZoneService zoneService(ServerComponents house, DroneService drones, Clock clock) {
        return new ZoneService(
                new ZoneService.Stores(house.zones(), house.cloud().zones(), house.access()), drones, clock);
    }

    @Bean
    SystemService systemService(ServerComponents house, ServerSettings settings, StreamPort stream) {
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
                        BuildVersion.current(),
                        settings.publicMode(),
                        PhoneTrustStarter.url(PhoneTrustStarter.of(settings))));
    }

    @Bean
    LinkSecurityService linkSecurityService(ServerComponents house, DroneService drones) {
        return new LinkSecurityService(house.linkSecurity(), drones, house.time());
    }

    @Bean
    BackupService backupService(ServerComponents house, ServerSettings settings) {
        return new BackupService(house.backups(), settings.dataDirectory());
    }

    @Bean
    RecordingService recordingService(ServerComponents house, ReplayService replays) {
        return new RecordingService(house.archive(), replays);
    }

    @Bean
    FlightService flightService(ServerComponents house) {
        return new FlightService(house.history().flights(), house.archive());
    }

    @Bean
    TelemetryService telemetryService(ServerComponents house, DroneService drones, FlightService flights, Clock clock) {
        return new TelemetryService(house.history().telemetry(), drones, flights, clock);
    }

    @Bean
    TelemetryExporter telemetryFiles(ServerComponents house, ServerSettings settings) {
        return new TelemetryExporter(
                house.history().telemetry(),
                new TlogExporter(house.archive()),
                new ParquetTrackWriter(),
                settings.dataDirectory());
    }

    @Bean
    HistoryStatusService historyService(ServerComponents house) {
        return new HistoryStatusService(house.history());
    }

    @Bean
    ReplayService replayService(ServerComponents house, ReplayOwners owners, ServerSettings settings) {
        return new ReplayService(house.recordings(), owners, settings.dataDirectory());
    }

    @Bean
    OutletService outletService(ServerComponents house, AccountChanges accounts, SecretGenerator secrets) {
        return new OutletService(house.links().outlet(), house.access(), accounts, secrets);
    }

    @Bean
    EndpointService linkService(ServerComponents house, Clock clock) {
        return new EndpointService(house.links().vehicles(), house.links().store(), clock);
    }

    @Bean
    DtlsKeyService dtlsKeyService(ServerComponents house, Clock clock) {
        return new DtlsKeyService(house.links().keys(), house.links().vehicles(), house.cloud(), clock);
    }

    @Bean
    SensingService sensingService(ServerComponents house, DroneService drones) {
        return new SensingService(house.cloud(), drones);
    }

    @Bean
    RobotKeyService robotKeyService(
            ServerComponents house, OrganisationService organisations, SecretGenerator secrets, Clock clock) {
        RobotKeyService.Dependencies around =
                new RobotKeyService.Dependencies(house.links().vehicles(), house.cloud(), organisations);
        return new RobotKeyService(
                house.links().robotKeys(),
                around,
                secrets,
                clock,
                new DroneIdGenerator(house.time().random()));
    }

    @Bean
    ServerMetrics serverMetrics(ServerComponents house, ProtectionCounters protections) {
        return new ServerMetrics(
                house.cloud(),
                house.links().vehicles(),
                protections::refusals,
                house.history()::health,
                house.links().outlet()::status);
    }
}
