package org.dronemap.ws.server;

import java.nio.file.Path;
import org.dronemap.core.audit.AuditChain;
import org.dronemap.core.audit.AuditEntry;
import org.dronemap.core.audit.AuditHeadStore;
import org.dronemap.core.audit.AuditHeadWriter;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.core.audit.AuditRecorder;
import org.dronemap.core.audit.AuditStore;
import org.dronemap.core.audit.AuditVerdict;
import org.dronemap.core.audit.SignedAuditHead;
import org.dronemap.core.time.Time;
import org.dronemap.store.Stores;
import org.dronemap.store.file.FileAuditHeadStore;
import org.dronemap.store.secret.ServerSecret;
import org.dronemap.ws.settings.ServerSettings;
import org.jspecify.annotations.Nullable;

/** Opens the audit log at the start, whose key and signed heads lie in files beside the database. */
final class AuditBuilder {
    private final AuditChain chain;
    private final AuditHeadStore heads;
    private final Time time;

    AuditBuilder(ServerSettings settings, Time time) {
        Path directory = settings.dataDirectory();
        this.chain = new AuditChain(
                ServerSecret.seal(ServerSettings.Hidden.shown(settings.auditKey()), directory.resolve("audit-key")));
        this.heads = new FileAuditHeadStore(directory.resolve("audit-heads"));
        this.time = time;
    }

    /** From here on each change leaves its record. */
    ServerComponents.AuditComponents open(Stores stores, ShutdownSequence closing) {
        AuditStore store = stores.audit(chain);
        AuditHeadWriter keeper = new AuditHeadWriter(store, heads, chain, time);
        keeper.start();
        closing.add("the heads of the audit log", keeper);
        return components(store, keeper);
    }

    /** For a server that does not run. */
    AuditVerdict verify(Stores stores, @Nullable SignedAuditHead receipt) {
        AuditStore store = stores.audit(chain);
        return components(store, new AuditHeadWriter(store, heads, chain, time)).verify(receipt);
    }

    private ServerComponents.AuditComponents components(AuditStore store, AuditHeadWriter keeper) {
        AuditRecorder recorder = new AuditRecorder(store, time.clock(), time::nanos, AuditRecorder.ANONYMOUS_REFUSALS);
        return new ServerComponents.AuditComponents(store, heads, chain, keeper, recorder);
    }

    /** The chain goes on from what the backup held, and says so. */
    void restored(Stores stores, Path backup) {
        AuditStore store = stores.audit(chain);
        try (AuditHeadWriter keeper = new AuditHeadWriter(store, heads, chain, time)) {
            keeper.restored();
            store.append(new AuditEntry(
                    time.clock().instant(),
                    null,
                    null,
                    null,
                    "script",
                    "restore",
                    null,
                    null,
                    null,
                    "file=" + backup.getFileName(),
                    AuditOutcome.SUCCEEDED,
                    null,
                    null,
                    null));
        }
    }
}
