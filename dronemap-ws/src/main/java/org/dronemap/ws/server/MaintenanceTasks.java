package org.dronemap.ws.server;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronemap.core.audit.AuditVerdict;
import org.dronemap.core.audit.SignedAuditHead;
import org.dronemap.core.time.Time;
import org.dronemap.store.postgres.BackupSummary;
import org.dronemap.store.postgres.PostgresStores;
import org.dronemap.ws.audit.AuditReceiptView;
import org.dronemap.ws.environment.SetupException;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.settings.ServerSettings;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Command-line maintenance tasks, such as restoring a backup, that run while the server does not. */
public final class MaintenanceTasks {
    private static final Logger LOG = LoggerFactory.getLogger(MaintenanceTasks.class);
    private static final String RESTORE = "--restore";
    private static final String VERIFY = "--verify-audit";
    private static final int NOT_SOUND = 10;

    private final ServerSettings settings;
    private final ShutdownSequence closing;
    private final Time time;

    public MaintenanceTasks(ServerSettings settings, ShutdownSequence closing, Time time) {
        this.settings = settings;
        this.time = time;
        this.closing = closing;
    }

    /** The exit code. */
    public int run(List<String> arguments) {
        if (arguments.size() == 2 && arguments.get(0).equals(RESTORE)) {
            restore(readable(arguments.get(1), "backup"));
            return 0;
        }
        if (arguments.size() <= 2 && arguments.get(0).equals(VERIFY)) {
            return verify(arguments.size() == 1 ? null : readable(arguments.get(1), "receipt"));
        }
        throw new SetupException("Unknown arguments: " + String.join(" ", arguments) + "; there are only " + RESTORE
                + " FILE and " + VERIFY + " [RECEIPT], everything else is set by the environment.");
    }

    /** Replaces all that is stored by what a backup holds. */
    private void restore(Path backup) {
        PostgresStores database = new DatabaseBuilder(settings).open(closing);
        BackupSummary summary = database.backup().restore(backup);
        new AuditBuilder(settings, time).restored(database, backup);
        LOG.info("Restored from {}: {}", backup, summary);
    }

    private int verify(@Nullable Path receipt) {
        SignedAuditHead head = receipt == null ? null : read(receipt).signedHead();
        PostgresStores database = new DatabaseBuilder(settings).open(closing);
        AuditVerdict verdict = new AuditBuilder(settings, time).verify(database, head);
        System.out.println("VERDICT " + verdict.sentence());
        return verdict.isSound() ? 0 : NOT_SOUND;
    }

    private static AuditReceiptView read(Path receipt) {
        try {
            return new JsonCodec().read(Files.readString(receipt, StandardCharsets.UTF_8), AuditReceiptView.class);
        } catch (IOException e) {
            throw new SetupException("The receipt " + receipt + " cannot be read: " + e.getMessage(), e);
        }
    }

    private static Path readable(String name, String what) {
        Path file = Path.of(name).toAbsolutePath();
        if (!Files.isReadable(file)) {
            throw new SetupException("There is no readable " + what + " " + file + ".");
        }
        return file;
    }
}
