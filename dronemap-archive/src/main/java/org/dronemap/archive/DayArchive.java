package org.dronemap.archive;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.time.LocalDate;
import org.apache.hadoop.conf.Configuration;
import org.apache.hadoop.fs.FileSystem;
import org.apache.hadoop.fs.Path;
import org.apache.parquet.example.data.Group;
import org.apache.parquet.example.data.simple.SimpleGroup;
import org.apache.parquet.hadoop.ParquetReader;
import org.apache.parquet.hadoop.ParquetWriter;
import org.apache.parquet.hadoop.example.ExampleParquetWriter;
import org.apache.parquet.hadoop.example.GroupReadSupport;
import org.apache.parquet.hadoop.metadata.CompressionCodecName;
import org.apache.parquet.hadoop.util.HadoopOutputFile;
import org.apache.parquet.schema.MessageType;

/**
 * Archives telemetry as one verified Parquet file for each day, such as {@code day=2026-03-04/telemetry.parquet}. The
 * file has another name, which no reader takes for one of it, until all its rows were read back and compared with where
 * they came from. One thread, and one archive at a time in one place.
 */
public final class DayArchive {
    private static final String FILE = "telemetry.parquet";
    private static final String UNFINISHED = "_telemetry.writing";

    private final Path root;
    private final Configuration configuration;
    private final RowSource rows;
    private final MessageType schema = ParquetColumns.schema();

    /** The status of a day after archiving. */
    public enum Status {
        WRITTEN,
        /** It was written before. */
        THERE,
        /** Nothing was kept of that day. */
        EMPTY
    }

    /** {@code rowCount} of this time, 0 where nothing was written. */
    public record Result(Status outcome, long rowCount) {}

    /** {@code configuration} says how to reach the file system of {@code root}. */
    public DayArchive(Path root, Configuration configuration, RowSource rows) {
        this.root = root;
        this.configuration = configuration;
        this.rows = rows;
    }

    /** Where that day is once it is there. */
    public Path file(LocalDate day) {
        return new Path(folder(day), FILE);
    }

    private Path folder(LocalDate day) {
        return new Path(root, "day=" + day);
    }

    /** A finished day. What a crash left behind of it is written anew. */
    public Result keep(LocalDate day) throws IOException {
        FileSystem files = root.getFileSystem(configuration);
        if (files.exists(file(day))) {
            return new Result(Status.THERE, 0);
        }
        Path unfinished = new Path(folder(day), UNFINISHED);
        files.delete(unfinished, false);
        long written = write(day, unfinished);
        if (written == 0) {
            files.delete(folder(day), true);
            return new Result(Status.EMPTY, 0);
        }
        verify(day, unfinished, written);
        if (!files.rename(unfinished, file(day))) {
            throw new IOException(unfinished + " cannot be given its name " + FILE + ".");
        }
        return new Result(Status.WRITTEN, written);
    }

    private long write(LocalDate day, Path to) throws IOException {
        long[] count = {0};
        try (ParquetWriter<Group> writer = ExampleParquetWriter.builder(HadoopOutputFile.fromPath(to, configuration))
                .withConf(configuration)
                .withType(schema)
                .withCompressionCodec(CompressionCodecName.ZSTD)
                .build()) {
            rows.of(day, values -> {
                Group row = new SimpleGroup(schema);
                ParquetColumns.write(values, row);
                writer.write(row);
                count[0]++;
            });
        }
        return count[0];
    }

    private void verify(LocalDate day, Path written, long count) throws IOException {
        long[] seen = {0};
        try (ParquetReader<Group> reader = ParquetReader.builder(new GroupReadSupport(), written)
                .withConf(configuration)
                .build()) {
            rows.of(day, values -> {
                seen[0]++;
                Group row = reader.read();
                if (row == null || !values.equals(ParquetColumns.read(row))) {
                    throw new IOException("Row " + seen[0] + " of " + day + " was not read back as it is: "
                            + (row == null ? "it is missing" : ParquetColumns.read(row)) + " instead of " + values + ".");
                }
            });
            if (reader.read() != null || seen[0] != count) {
                throw new IOException(count + " rows of " + day + " were written and " + seen[0] + " are there.");
            }
        }
    }

    /** All rows of a day that is in the archive. */
    public void read(LocalDate day, RowSource.RowConsumer taker) throws IOException {
        if (!root.getFileSystem(configuration).exists(file(day))) {
            throw new FileNotFoundException("There is no " + file(day) + ".");
        }
        try (ParquetReader<Group> reader = ParquetReader.builder(new GroupReadSupport(), file(day))
                .withConf(configuration)
                .build()) {
            for (Group row = reader.read(); row != null; row = reader.read()) {
                taker.row(ParquetColumns.read(row));
            }
        }
    }
}
