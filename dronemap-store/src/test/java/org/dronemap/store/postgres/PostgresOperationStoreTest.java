package org.dronemap.store.postgres;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.operation.JournalEntry;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationStore;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.store.contract.OperationStoreContract;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PostgresOperationStoreTest extends OperationStoreContract {
    private final PostgresStores database = SharedDatabase.empty();

    @TempDir
    private Path temporary;

    @Override
    protected OperationStore emptyStore() {
        return database.operations();
    }

    @Test
    void comesBackFromABackupWithItsJournal() throws IOException {
        Instant at = Instant.parse("2026-03-04T05:06:07.123456Z");
        SavedOperation begun = SavedOperation.begun(
                        new OperationId("r1"),
                        "mission",
                        new SavedOperation.Owner("ann", "#1", OrganisationId.HOME),
                        "roofs",
                        at)
                .beginning("{\"text\":\"tab\\there, \\\\N\"}");
        JournalEntry first = new JournalEntry(0, at, begun.state(), "");
        database.operations().begin(begun, first);
        Path zip = temporary.resolve("backup.zip");
        try (OutputStream out = Files.newOutputStream(zip)) {
            database.backup().write(out);
        }
        SharedDatabase.empty();
        assertThat(database.operations().underWay()).isEmpty();

        database.backup().restore(zip);

        assertThat(database.operations().underWay()).isEqualTo(List.of(begun));
        assertThat(database.operations().journal(begun.id(), 0, 10)).containsExactly(first);
    }
}
