package org.dronemap.archive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.apache.hadoop.conf.Configuration;
import org.apache.hadoop.fs.FileStatus;
import org.apache.hadoop.fs.FileSystem;
import org.apache.hadoop.fs.Path;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** What holds of an archive on any file system. */
@Tag("soak")
abstract class ArchiveContract {
    private final SimulatedRowSource day = new SimulatedRowSource();

    /** An empty place, another one for each test. */
    abstract Path root();

    abstract Configuration configuration();

    private DayArchive archive(Path root, RowSource rows) {
        return new DayArchive(root, configuration(), rows);
    }

    @Test
    void givesADayBackRowByRow() throws IOException {
        DayArchive archive = archive(root(), day);

        DayArchive.Result result = archive.keep(SimulatedRowSource.DAY);

        assertThat(result)
                .isEqualTo(new DayArchive.Result(
                        DayArchive.Status.WRITTEN, day.rows().size()));
        assertThat(readBack(archive)).isEqualTo(day.rows());
    }

    @Test
    void writesADayOnce() throws IOException {
        Path root = root();
        archive(root, day).keep(SimulatedRowSource.DAY);

        DayArchive again = archive(root, new SimulatedRowSource().failingAfter(0));

        assertThat(again.keep(SimulatedRowSource.DAY)).isEqualTo(new DayArchive.Result(DayArchive.Status.THERE, 0));
        assertThat(readBack(again)).isEqualTo(day.rows());
    }

    @Test
    void makesNothingOfADayOfWhichNothingWasKept() throws IOException {
        Path root = root();
        DayArchive archive = archive(root, day);

        assertThat(archive.keep(SimulatedRowSource.DAY.plusDays(1)).outcome()).isEqualTo(DayArchive.Status.EMPTY);
        assertThat(names(root, archive.file(SimulatedRowSource.DAY.plusDays(1)).getParent()))
                .isEmpty();
    }

    @Test
    void leavesNoFileThatCountsWhenItEndsInTheMiddleAndWritesAllTheNextTime() throws IOException {
        Path root = root();
        DayArchive dying = archive(root, new SimulatedRowSource().failingAfter(5_000));
        assertThatThrownBy(() -> dying.keep(SimulatedRowSource.DAY)).hasMessageContaining("the power is off");
        assertNothingCounts(root, dying);

        DayArchive archive = archive(root, day);
        assertThat(archive.keep(SimulatedRowSource.DAY).rowCount())
                .isEqualTo(day.rows().size());
        assertThat(readBack(archive)).isEqualTo(day.rows());
        assertThat(names(root, archive.file(SimulatedRowSource.DAY).getParent())).containsExactly("telemetry.parquet");
    }

    @Test
    void writesAnewWhatACrashLeftBehind() throws IOException {
        Path root = root();
        DayArchive archive = archive(root, day);
        Path left = new Path(archive.file(SimulatedRowSource.DAY).getParent(), "_telemetry.writing");
        try (OutputStream out = root.getFileSystem(configuration()).create(left)) {
            out.write(new byte[] {'P', 'A', 'R', '1', 0, 1, 2});
        }

        assertThat(archive.keep(SimulatedRowSource.DAY).outcome()).isEqualTo(DayArchive.Status.WRITTEN);
        assertThat(readBack(archive)).isEqualTo(day.rows());
    }

    @Test
    void doesNotCountWhatIsNotReadBackAsItIs() throws IOException {
        Path root = root();
        DayArchive archive = archive(root, new SimulatedRowSource().changing(7_000));

        assertThatThrownBy(() -> archive.keep(SimulatedRowSource.DAY))
                .hasMessageContaining("Row 7001 of 2026-03-04 was not read back as it is");
        assertNothingCounts(root, archive);
    }

    private void assertNothingCounts(Path root, DayArchive archive) throws IOException {
        assertThat(names(root, archive.file(SimulatedRowSource.DAY).getParent()))
                .noneMatch(name -> name.endsWith(".parquet"))
                .allMatch(name -> name.startsWith("_"));
        assertThatThrownBy(() -> readBack(archive)).isInstanceOf(FileNotFoundException.class);
    }

    private List<String> names(Path root, Path folder) throws IOException {
        FileSystem files = root.getFileSystem(configuration());
        return files.exists(folder)
                ? Arrays.stream(files.listStatus(folder))
                        .map(FileStatus::getPath)
                        .map(Path::getName)
                        .toList()
                : List.of();
    }

    private static List<List<@Nullable Object>> readBack(DayArchive archive) throws IOException {
        List<List<@Nullable Object>> rows = new ArrayList<>();
        archive.read(SimulatedRowSource.DAY, rows::add);
        return rows;
    }
}
