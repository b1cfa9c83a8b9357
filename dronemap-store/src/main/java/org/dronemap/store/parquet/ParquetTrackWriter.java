package org.dronemap.store.parquet;

import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import org.apache.parquet.format.ColumnChunk;
import org.apache.parquet.format.ColumnMetaData;
import org.apache.parquet.format.CompressionCodec;
import org.apache.parquet.format.Encoding;
import org.apache.parquet.format.FileMetaData;
import org.apache.parquet.format.RowGroup;
import org.apache.parquet.format.Util;
import org.dronemap.core.history.TelemetryColumn;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.history.TrackWriter;

/**
 * Exports a drone's telemetry as a Parquet file with the archive's columns: one row group, pages packed with gzip. The
 * usual writer of such files wants Hadoop, which is larger than the server; what a track needs of the format is little.
 */
public final class ParquetTrackWriter implements TrackWriter {
    private static final byte[] MAGIC = {'P', 'A', 'R', '1'};
    private static final int VERSION = 1;
    private static final String CREATED_BY = "dronemap version 0.1.0 (build 0)";

    @Override
    public void write(List<TelemetryPoint> points, OutputStream to) throws IOException {
        CountingStream out = new CountingStream(to);
        out.write(MAGIC);
        List<ColumnChunk> chunks = new ArrayList<>();
        if (!points.isEmpty()) {
            for (TelemetryColumn column : TelemetryColumn.ALL) {
                chunks.add(chunk(column, points, out));
            }
        }
        long footer = out.count();
        Util.writeFileMetaData(metadata(points.size(), chunks), out);
        int length = (int) (out.count() - footer);
        out.write(new byte[] {(byte) length, (byte) (length >> 8), (byte) (length >> 16), (byte) (length >> 24)});
        out.write(MAGIC);
        out.flush();
    }

    private static ColumnChunk chunk(TelemetryColumn column, List<TelemetryPoint> points, CountingStream out)
            throws IOException {
        long start = out.count();
        ColumnPages pages = new ColumnPages(column);
        pages.write(points, out);
        long packed = out.count() - start;
        ColumnMetaData metadata = new ColumnMetaData(
                ColumnSchema.type(column),
                List.of(Encoding.PLAIN, Encoding.RLE),
                List.of(column.label()),
                CompressionCodec.GZIP,
                points.size(),
                pages.unpackedBytes(),
                packed,
                start);
        return new ColumnChunk(start).setMeta_data(metadata);
    }

    private static FileMetaData metadata(int rows, List<ColumnChunk> chunks) {
        List<RowGroup> groups = new ArrayList<>();
        if (!chunks.isEmpty()) {
            long unpacked = chunks.stream()
                    .mapToLong(chunk -> chunk.getMeta_data().getTotal_uncompressed_size())
                    .sum();
            groups.add(new RowGroup(chunks, unpacked, rows));
        }
        return new FileMetaData(VERSION, ColumnSchema.elements(), rows, groups).setCreated_by(CREATED_BY);
    }
}
