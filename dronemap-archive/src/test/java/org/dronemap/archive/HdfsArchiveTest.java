package org.dronemap.archive;

import java.io.IOException;
import java.util.concurrent.atomic.AtomicInteger;
import org.apache.hadoop.conf.Configuration;
import org.apache.hadoop.fs.Path;
import org.apache.hadoop.hdfs.MiniDFSCluster;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;

/** On a small HDFS. */
class HdfsArchiveTest extends ArchiveContract {
    private static final AtomicInteger NUMBERS = new AtomicInteger();
    private static MiniDFSCluster cluster;

    @BeforeAll
    static void start(@TempDir java.nio.file.Path folder) throws IOException {
        Configuration configuration = new Configuration();
        configuration.set(MiniDFSCluster.HDFS_MINIDFS_BASEDIR, folder.toString());
        cluster = new MiniDFSCluster.Builder(configuration).numDataNodes(1).build();
        cluster.waitActive();
    }

    @AfterAll
    static void stop() {
        cluster.shutdown(true);
    }

    @Override
    Path root() {
        return new Path(cluster.getURI() + "/archive-" + NUMBERS.incrementAndGet());
    }

    @Override
    Configuration configuration() {
        return cluster.getConfiguration(0);
    }
}
