package org.dronemap.ws.system;

import io.prometheus.metrics.expositionformats.PrometheusTextFormatWriter;
import io.prometheus.metrics.model.snapshots.MetricSnapshots;
import io.swagger.v3.oas.annotations.Hidden;
import jakarta.servlet.http.HttpServletResponse;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import org.dronemap.core.access.Role;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.security.CurrentPrincipal;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.RestController;

/** Serves metrics of the server for Prometheus; a viewer's access key for all drones is enough. */
@RestController
@Hidden
class MetricsController {
    private static final PrometheusTextFormatWriter WRITER = PrometheusTextFormatWriter.create();

    private final ServerMetrics metrics;
    private final CurrentPrincipal current;

    MetricsController(ServerMetrics metrics, CurrentPrincipal current) {
        this.metrics = metrics;
        this.current = current;
    }

    @GetMapping("/metrics")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.SERVER)
    public void metrics(HttpServletResponse response) throws IOException {
        RoleChecks.requireServer(current.principal(), Role.VIEWER);
        MetricSnapshots now = metrics.now(current.principal());
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        WRITER.write(text, now);
        response.setContentType(PrometheusTextFormatWriter.CONTENT_TYPE);
        response.getOutputStream().write(text.toByteArray());
    }
}
