package org.dronemap.ws.server;

import java.nio.file.Path;
import org.dronemap.core.audit.AuditChain;
import org.dronemap.core.audit.AuditEntry;
import org.dronemap.core.audit.AuditHeads;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.core.audit.AuditStore;
import org.dronemap.core.audit.AuditVerdict;
import org.dronemap.core.audit.HeadKeeper;
import org.dronemap.core.audit.SignedHead;
import org.dronemap.core.time.Time;
import org.dronemap.store.Stores;
import org.dronemap.store.file.HeadsFile;
import org.dronemap.store.secret.ServerSecret;
import org.dronemap.ws.settings.Settings;
import org.jspecify.annotations.Nullable;

/** Opens the audit log of what is stored: its key and its heads lie beside the database, not in it. */
final class AuditBuilder {
    private final AuditChain chain;
    private final AuditHeads heads;
    private final Time time;

    AuditBuilder(Settings settings, Time time) {
        Path directory = settings.dataDirectory();
        this.chain = new AuditChain(
                ServerSecret.seal(Settings.Hidden.shown(settings.auditKey()), directory.resolve("audit-key")));
        this.heads = new HeadsFile(directory.resolve("audit-heads"));
        this.time = time;
    }

    /** From here on each change leaves its record. */
    House.AuditSide open(Stores stores, Closing closing) {
        AuditStore store = stores.audit(chain);
        HeadKeeper keeper = new HeadKeeper(store, heads, chain, time);
        keeper.start();
        closing.add("the heads of the audit log", keeper);
        return new House.AuditSide(store, heads, chain, keeper);
    }

    /** For a server that does not run. */
    AuditVerdict verify(Stores stores, @Nullable SignedHead receipt) {
        AuditStore store = stores.audit(chain);
        return new House.AuditSide(store, heads, chain, new HeadKeeper(store, heads, chain, time)).verify(receipt);
    }

    /** The chain goes on from what the backup held, and says so. */
    void restored(Stores stores, Path backup) {
        AuditStore store = stores.audit(chain);
        try (HeadKeeper keeper = new HeadKeeper(store, heads, chain, time)) {
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
