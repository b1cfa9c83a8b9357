package org.dronemap.ws.server;

import java.util.List;
import java.util.function.BooleanSupplier;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.GrantBook;
import org.dronemap.core.access.GrantStore;
import org.dronemap.core.audit.AuditChain;
import org.dronemap.core.audit.AuditHeads;
import org.dronemap.core.audit.AuditStore;
import org.dronemap.core.audit.AuditVerdict;
import org.dronemap.core.audit.AuditVerifier;
import org.dronemap.core.audit.HeadKeeper;
import org.dronemap.core.audit.SignedHead;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.history.History;
import org.dronemap.core.link.LinkStore;
import org.dronemap.core.mission.MissionStore;
import org.dronemap.core.process.Beginning;
import org.dronemap.core.recording.RecordingArchive;
import org.dronemap.core.time.Time;
import org.dronemap.core.zone.ZoneStore;
import org.dronemap.ws.account.PasswordHashing;
import org.dronemap.ws.link.DtlsKeyRing;
import org.dronemap.ws.link.LinkSecurityControl;
import org.dronemap.ws.link.VehicleLinks;
import org.dronemap.ws.outlet.OutletControl;
import org.dronemap.ws.recording.Recordings;
import org.dronemap.ws.robotkey.RobotKeyRing;
import org.dronemap.ws.system.BackupService;
import org.dronemap.ws.system.ServerPart;
import org.jspecify.annotations.Nullable;

/** Components behind the faces, built and running. */
public record House(
        Time time,
        CloudManager cloud,
        AccessStore access,
        MissionStore missions,
        ZoneStore zones,
        Recordings recordings,
        RecordingArchive archive,
        History history,
        LinkSide links,
        BooleanSupplier databaseUp,
        BackupService.BackupWriter backups,
        LinkSecurityControl linkSecurity,
        GrantStore grants,
        GrantBook grantBook,
        VirtualDrones virtuals,
        RunSide runs,
        AuditSide audit,
        PasswordHashing passwords,
        List<ServerPart> parts,
        Beginning beginning) {

    /** Where it is kept what was done by whom, and what vouches for it beside the database. */
    public record AuditSide(AuditStore store, AuditHeads heads, AuditChain chain, HeadKeeper keeper) {
        AuditVerdict verify(@Nullable SignedHead receipt) {
            return new AuditVerifier(store, heads, chain).verify(receipt);
        }
    }

    /**
     * The ways in for vehicles, where added ones are kept, and the keys that vehicles prove themselves with; and the way in
     * for ground stations of other makers.
     *
     * @param open all ways in are open: those for vehicles before the faces start, that for ground stations after them
     */
    public record LinkSide(
            VehicleLinks vehicles,
            LinkStore store,
            DtlsKeyRing keys,
            RobotKeyRing robotKeys,
            OutletControl outlet,
            BooleanSupplier open) {}
}
