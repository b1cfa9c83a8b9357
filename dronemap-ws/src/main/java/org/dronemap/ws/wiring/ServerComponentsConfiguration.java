package org.dronemap.ws.wiring;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import java.time.Clock;
import org.dronemap.cognitive.operation.dispatch.DispatchInput;
import org.dronemap.cognitive.operation.dispatch.DispatchState;
import org.dronemap.cognitive.operation.follow.FollowInput;
import org.dronemap.cognitive.operation.follow.FollowState;
import org.dronemap.cognitive.operation.recovery.RecoveryInput;
import org.dronemap.cognitive.operation.recovery.RecoveryState;
import org.dronemap.cognitive.operation.run.RunState;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.core.access.GrantStore;
import org.dronemap.core.audit.AuditHeadWriter;
import org.dronemap.core.audit.AuditRecorder;
import org.dronemap.core.audit.AuditStore;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.conduct.Operations;
import org.dronemap.core.conduct.TakeOffClearance;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.history.FlightRegistry;
import org.dronemap.core.history.HistoryRecorder;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.link.EndpointStore;
import org.dronemap.core.mission.MissionStore;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.process.ProcessStart;
import org.dronemap.core.recording.RecordingArchive;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.time.Time;
import org.dronemap.core.zone.ZoneRegistry;
import org.dronemap.core.zone.ZoneStore;
import org.dronemap.ws.account.PasswordHashing;
import org.dronemap.ws.audit.AuditService;
import org.dronemap.ws.link.DtlsKeyRing;
import org.dronemap.ws.link.LinkSecurityGateway;
import org.dronemap.ws.link.VehicleEndpointGateway;
import org.dronemap.ws.outlet.OutletGateway;
import org.dronemap.ws.recording.ReplayGateway;
import org.dronemap.ws.robotkey.RobotKeyRing;
import org.dronemap.ws.server.ServerComponents;
import org.dronemap.ws.system.BackupService;
import org.dronemap.ws.system.SystemService;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;

/** Spring configuration that provides the parts of {@link ServerComponents} to the rooms, which do not see the whole. */
@Configuration(proxyBeanMethods = false)
class ServerComponentsConfiguration {
    /** A part that was built before the faces and is closed after them, by others. */
    @Bean(destroyMethod = "")
    @Retention(RetentionPolicy.RUNTIME)
    @Target(ElementType.METHOD)
    private @interface Part {}

    @Part
    Time time(ServerComponents server) {
        return server.time();
    }

    @Part
    Clock clock(Time time) {
        return time.clock();
    }

    @Part
    CloudManager cloudManager(ServerComponents server) {
        return server.cloud();
    }

    @Part
    ZoneRegistry zoneRegistry(ServerComponents server) {
        return server.cloud().zones();
    }

    @Part
    AccessStore accessStore(ServerComponents server) {
        return server.access();
    }

    @Part
    GrantStore grantStore(ServerComponents server) {
        return server.grants();
    }

    @Part
    GrantRegistry grantRegistry(ServerComponents server) {
        return server.grantBook();
    }

    @Part
    PasswordHashing passwordHashing(ServerComponents server) {
        return server.passwords();
    }

    @Part
    MissionStore missionStore(ServerComponents server) {
        return server.missions();
    }

    @Part
    ZoneStore zoneStore(ServerComponents server) {
        return server.zones();
    }

    @Part
    RecordingArchive recordingArchive(ServerComponents server) {
        return server.archive();
    }

    @Part
    ReplayGateway replayGateway(ServerComponents server) {
        return server.recordings();
    }

    @Part
    HistoryRecorder historyRecorder(ServerComponents server) {
        return server.history();
    }

    @Part
    TelemetryStore telemetryStore(ServerComponents server) {
        return server.history().telemetry();
    }

    @Part
    FlightRegistry flightRegistry(ServerComponents server) {
        return server.history().flights();
    }

    @Part
    VehicleEndpointGateway vehicleEndpoints(ServerComponents server) {
        return server.links().vehicles();
    }

    @Part
    EndpointStore endpointStore(ServerComponents server) {
        return server.links().store();
    }

    @Part
    DtlsKeyRing dtlsKeyRing(ServerComponents server) {
        return server.links().keys();
    }

    @Part
    RobotKeyRing robotKeyRing(ServerComponents server) {
        return server.links().robotKeys();
    }

    @Part
    OutletGateway outletGateway(ServerComponents server) {
        return server.links().outlet();
    }

    @Part
    LinkSecurityGateway linkSecurityGateway(ServerComponents server) {
        return server.linkSecurity();
    }

    @Part
    BackupService.BackupWriter backupWriter(ServerComponents server) {
        return server.backups();
    }

    @Part
    VirtualDrones virtualDrones(ServerComponents server) {
        return server.virtuals();
    }

    @Part
    Operations operations(ServerComponents server) {
        return server.runs().operations();
    }

    @Part
    TakeOffClearance takeOffClearance(ServerComponents server) {
        return new TakeOffClearance(server.runs().board(), server.time());
    }

    @Part
    OperationKind<RunState, RunInput> runKind(ServerComponents server) {
        return server.runs().kind();
    }

    @Part
    OperationKind<FollowState, FollowInput> followKind(ServerComponents server) {
        return server.runs().follows();
    }

    @Part
    OperationKind<DispatchState, DispatchInput> dispatchKind(ServerComponents server) {
        return server.runs().dispatches();
    }

    @Part
    OperationKind<RecoveryState, RecoveryInput> recoveryKind(ServerComponents server) {
        return server.runs().recoveries();
    }

    @Part
    Separation separation(ServerComponents server) {
        return server.runs().apart();
    }

    @Part
    AuditStore auditStore(ServerComponents server) {
        return server.audit().store();
    }

    @Part
    AuditHeadWriter auditHeads(ServerComponents server) {
        return server.audit().keeper();
    }

    @Part
    AuditRecorder auditRecorder(ServerComponents server) {
        return server.audit().recorder();
    }

    @Part
    AuditService.Verification auditVerification(ServerComponents server) {
        return server.audit()::verify;
    }

    @Part
    ProcessStart processStart(ServerComponents server) {
        return server.beginning();
    }

    @Part
    SystemService.Checks systemChecks(ServerComponents server) {
        return new SystemService.Checks(
                server.databaseUp(),
                server.links().open(),
                () -> server.history().health().isUp(),
                () -> server.runs().operations().troubles().isEmpty(),
                server.parts());
    }
}
