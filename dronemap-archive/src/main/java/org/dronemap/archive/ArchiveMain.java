package org.dronemap.archive;

import java.io.IOException;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.time.Instant;
import java.time.LocalDate;
import org.apache.hadoop.conf.Configuration;
import org.apache.hadoop.fs.Path;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Command-line program that archives the finished days of telemetry: {@code ArchiveMain jdbc:postgresql://…
 * file:///archive}.
 */
public final class ArchiveMain {
    private static final Logger LOG = LoggerFactory.getLogger(ArchiveMain.class);
    private static final int ARGUMENTS = 2;

    private ArchiveMain() {}

    public static void main(String[] arguments) {
        if (arguments.length != ARGUMENTS || !arguments[0].startsWith("jdbc:postgresql:")) {
            LOG.error(
                    "Say which database and where to: jdbc:postgresql://host/name?user=…&password=… hdfs://host/path");
            System.exit(2);
        }
        try {
            keepAll(arguments[0], new Path(arguments[1]));
        } catch (SQLException | IOException | IllegalArgumentException e) {
            LOG.error("The archive is not whole; what is in it was verified, and nothing was deleted.", e);
            System.exit(1);
        }
    }

    private static void keepAll(String database, Path root) throws SQLException, IOException {
        try (DatabaseRowSource rows = new DatabaseRowSource(DriverManager.getConnection(database))) {
            DayArchive archive = new DayArchive(root, new Configuration(), rows);
            for (LocalDate day : rows.finished(Instant.now())) {
                DayArchive.Result result = archive.keep(day);
                switch (result.outcome()) {
                    case WRITTEN -> LOG.info("{}: {} rows written and read back", day, result.rowCount());
                    case THERE -> LOG.info("{} is there already", day);
                    case EMPTY -> LOG.info("{}: nothing was kept of that day", day);
                }
            }
        }
    }
}
