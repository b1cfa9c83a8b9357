package org.dronemap.ws.wiring;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronemap.core.audit.AuditVerdict;
import org.dronemap.ws.service.JsonReader;
import org.dronemap.ws.service.ReceiptView;
import org.jspecify.annotations.Nullable;

/** What the owner of the machine asks of a server that does not run. */
final class OwnerTasks {
    private static final String RESTORE = "--restore";
    private static final String VERIFY = "--verify-audit";
    private static final int NOT_SOUND = 10;

    private final Settings settings;
    private final Closing closing;

    OwnerTasks(Settings settings, Closing closing) {
        this.settings = settings;
        this.closing = closing;
    }

    /** The exit code. */
    int run(List<String> arguments) {
        if (arguments.size() == 2 && arguments.get(0).equals(RESTORE)) {
            new HouseBuilder(settings, closing).restore(readable(arguments.get(1), "backup"));
            return 0;
        }
        if (arguments.size() <= 2 && arguments.get(0).equals(VERIFY)) {
            return verify(arguments.size() == 1 ? null : readable(arguments.get(1), "receipt"));
        }
        throw new SetupException("Unknown arguments: " + String.join(" ", arguments) + "; there are only " + RESTORE
                + " FILE and " + VERIFY + " [RECEIPT], everything else is set by the environment.");
    }

    private int verify(@Nullable Path receipt) {
        AuditVerdict verdict = new HouseBuilder(settings, closing).verifyAudit(receipt == null ? null : read(receipt));
        System.out.println("VERDICT " + verdict.sentence());
        return verdict.isSound() ? 0 : NOT_SOUND;
    }

    private static ReceiptView read(Path receipt) {
        try {
            return new JsonReader().read(Files.readString(receipt, StandardCharsets.UTF_8), ReceiptView.class);
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
