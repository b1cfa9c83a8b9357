package org.dronemap.store.parquet;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.zip.GZIPOutputStream;
import org.apache.parquet.format.DataPageHeader;
import org.apache.parquet.format.Encoding;
import org.apache.parquet.format.PageHeader;
import org.apache.parquet.format.PageType;
import org.apache.parquet.format.Util;
import org.dronemap.core.history.TelemetryColumn;
import org.dronemap.core.history.TelemetryPoint;

/** Writes the values of one telemetry column to a Parquet file, page by page. One thread. */
final class ColumnPages {
    /** Keeps a page below a megabyte, as readers like it. */
    private static final int ROWS_OF_A_PAGE = 20_000;

    private final TelemetryColumn column;
    private long unpackedBytes;

    ColumnPages(TelemetryColumn column) {
        this.column = column;
    }

    /** Of all that was written, headers included. */
    long unpackedBytes() {
        return unpackedBytes;
    }

    void write(List<TelemetryPoint> points, OutputStream out) throws IOException {
        for (int from = 0; from < points.size(); from += ROWS_OF_A_PAGE) {
            page(points.subList(from, Math.min(points.size(), from + ROWS_OF_A_PAGE)), out);
        }
    }

    private void page(List<TelemetryPoint> rows, OutputStream out) throws IOException {
        PlainEncoding values = new PlainEncoding();
        BitRun known = new BitRun();
        for (TelemetryPoint row : rows) {
            Object value = column.of(row);
            known.add(value != null);
            if (value != null) {
                values.add(value);
            }
        }
        ByteArrayOutputStream page = new ByteArrayOutputStream();
        if (!column.required()) {
            known.writeLevels(page);
        }
        values.writeTo(page);
        byte[] packed = packed(page);
        PageHeader header = new PageHeader(PageType.DATA_PAGE, page.size(), packed.length)
                .setData_page_header(new DataPageHeader(rows.size(), Encoding.PLAIN, Encoding.RLE, Encoding.RLE));
        ByteArrayOutputStream head = new ByteArrayOutputStream();
        Util.writePageHeader(header, head);
        head.writeTo(out);
        out.write(packed);
        unpackedBytes += head.size() + page.size();
    }

    private static byte[] packed(ByteArrayOutputStream page) throws IOException {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (GZIPOutputStream gzip = new GZIPOutputStream(packed)) {
            page.writeTo(gzip);
        }
        return packed.toByteArray();
    }
}
