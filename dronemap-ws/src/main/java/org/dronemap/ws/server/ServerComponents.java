package org.dronemap.ws.server;

import java.util.List;
import java.util.function.BooleanSupplier;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.core.access.GrantStore;
import org.dronemap.core.audit.AuditChain;
import org.dronemap.core.audit.AuditHeadStore;
import org.dronemap.core.audit.AuditHeadWriter;
import org.dronemap.core.audit.AuditRecorder;
import org.dronemap.core.audit.AuditStore;
import org.dronemap.core.audit.AuditVerdict;
import org.dronemap.core.audit.AuditVerifier;
import org.dronemap.core.audit.SignedAuditHead;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.history.HistoryRecorder;
import org.dronemap.core.link.EndpointStore;
import org.dronemap.core.mission.MissionStore;
import org.dronemap.core.process.ProcessStart;
import org.dronemap.core.recording.RecordingArchive;
import org.dronemap.core.time.Time;
import org.dronemap.core.zone.ZoneStore;
import org.dronemap.ws.account.PasswordHashing;
import org.dronemap.ws.link.DtlsKeyRing;
import org.dronemap.ws.link.LinkSecurityGateway;
import org.dronemap.ws.link.VehicleEndpointGateway;
import org.dronemap.ws.outlet.OutletGateway;
import org.dronemap.ws.recording.ReplayGateway;
import org.dronemap.ws.robotkey.RobotKeyRing;
import org.dronemap.ws.system.BackupService;
import org.dronemap.ws.system.ServerPart;
import org.jspecify.annotations.Nullable;

/** The components of a running server that the REST, SOAP and stream faces are built on. */
public record ServerComponents(
        Time time,
        CloudManager cloud,
        AccessStore access,
        MissionStore missions,
        ZoneStore zones,
        ReplayGateway recordings,
        RecordingArchive archive,
        HistoryRecorder history,
        LinkComponents links,
        BooleanSupplier databaseUp,
        BackupService.BackupWriter backups,
        LinkSecurityGateway linkSecurity,
        GrantStore grants,
        GrantRegistry grantBook,
        VirtualDrones virtuals,
        OperationComponents runs,
        AuditComponents audit,
        PasswordHashing passwords,
        List<ServerPart> parts,
        ProcessStart beginning) {

    /** Components of the audit trail: its store, what writes it, and the signed heads kept beside the database. */
    public record AuditComponents(
            AuditStore store, AuditHeadStore heads, AuditChain chain, AuditHeadWriter keeper, AuditRecorder recorder) {
        public AuditVerdict verify(@Nullable SignedAuditHead receipt) {
            return new AuditVerifier(store, heads, chain).verify(receipt);
        }
    }

    /**
     * The ways in for vehicles, where added ones are kept, and the keys that vehicles prove themselves with; and the way in
     * for ground stations of other makers.
     *
     * @param open all ways in are open: those for vehicles before the faces start, that for ground stations after them
     */
    public record LinkComponents(
            VehicleEndpointGateway vehicles,
            EndpointStore store,
            DtlsKeyRing keys,
            RobotKeyRing robotKeys,
            OutletGateway outlet,
            BooleanSupplier open) {}
}
