package org.dronemap.archive;

import org.apache.hadoop.conf.Configuration;
import org.apache.hadoop.fs.Path;
import org.junit.jupiter.api.io.TempDir;

/** In a folder of this machine. */
class FileArchiveTest extends ArchiveContract {
    @TempDir
    private java.nio.file.Path folder;

    @Override
    Path root() {
        return new Path(folder.toUri());
    }

    @Override
    Configuration configuration() {
        return new Configuration();
    }
}
