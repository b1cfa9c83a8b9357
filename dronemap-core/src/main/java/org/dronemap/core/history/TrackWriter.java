package org.dronemap.core.history;

import java.io.IOException;
import java.io.OutputStream;
import java.util.List;

/** Writes telemetry points of a drone to an export file, such as Parquet. Any thread. */
@FunctionalInterface
public interface TrackWriter {
    /** All points, in the order that they come in; {@code out} stays open. */
    void write(List<TelemetryPoint> points, OutputStream out) throws IOException;
}
