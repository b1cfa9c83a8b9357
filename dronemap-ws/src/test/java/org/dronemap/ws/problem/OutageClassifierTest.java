package org.dronemap.ws.problem;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileSystemException;
import java.sql.SQLException;
import java.util.concurrent.CompletionException;
import org.dronemap.store.StoreException;
import org.junit.jupiter.api.Test;

class OutageClassifierTest {
    private static int status(Throwable thrown) {
        return OutageClassifier.of(thrown).map(outage -> outage.kind().status()).orElse(500);
    }

    @Test
    void aFullDiskIsAnOutageHoweverItIsTold() {
        SQLException full = new SQLException("could not extend file", "53100");
        FileSystemException file = new FileSystemException("/data/x", null, "No space left on device");
        assertThat(status(StoreException.passing("full", full))).isEqualTo(503);
        assertThat(status(new CompletionException(StoreException.passing("full", full))))
                .isEqualTo(503);
        assertThat(status(new UncheckedIOException(file))).isEqualTo(503);
        assertThat(status(new UncheckedIOException(new IOException("Disk quota exceeded"))))
                .isEqualTo(503);
    }

    @Test
    void whatIsBrokenIsNone() {
        assertThat(status(new StoreException("a row that cannot be read"))).isEqualTo(500);
        assertThat(status(new UncheckedIOException(new IOException("Connection reset"))))
                .isEqualTo(500);
        assertThat(status(new IllegalStateException())).isEqualTo(500);
    }
}
