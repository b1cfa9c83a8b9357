package org.dronemap.ws.history;

import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.nio.file.Files;
import org.springframework.http.HttpHeaders;

/** Sends an exported telemetry file as the response, and deletes it afterwards. */
final class TemporaryFileResponse {
    private TemporaryFileResponse() {}

    static void send(TelemetryExporter.Export export, HttpServletResponse response) throws IOException {
        try {
            response.setContentType(export.mediaType());
            response.setHeader(HttpHeaders.CONTENT_DISPOSITION, "attachment; filename=\"" + export.name() + "\"");
            response.setContentLengthLong(Files.size(export.file()));
            Files.copy(export.file(), response.getOutputStream());
        } finally {
            Files.deleteIfExists(export.file());
        }
    }
}
