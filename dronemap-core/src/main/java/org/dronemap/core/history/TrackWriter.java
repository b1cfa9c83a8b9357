package org.dronemap.core.history;

import java.io.IOException;
import java.io.OutputStream;
import java.util.List;

/** Makes a file of points that is the same wherever they were kept. Any thread. */
@FunctionalInterface
public interface TrackWriter {
    /** All points, in the order that they come in; {@code out} stays open. */
    void write(List<TelemetryPoint> points, OutputStream out) throws IOException;
}
