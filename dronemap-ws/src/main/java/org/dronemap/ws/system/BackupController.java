package org.dronemap.ws.system;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.RequestCost;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.http.FileMediaTypes;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

/** REST handler that downloads a backup of all that the server stores. */
@RestController
@RequestMapping("/api/v1/backup")
@Tag(name = "Server")
class BackupController {
    private final BackupService backups;
    private final CurrentPrincipal current;

    BackupController(BackupService backups, CurrentPrincipal current) {
        this.backups = backups;
        this.current = current;
    }

    @PostMapping
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER, costs = RequestCost.EXPORT)
    @ResponseStatuses(never = 409)
    @FileMediaTypes(produces = "application/zip")
    @Operation(
            operationId = "makeBackup",
            summary = "Make a backup (administrator)",
            description = "The answer is a zip of all that is stored.")
    public void backup(HttpServletResponse response) throws IOException {
        Path file = backups.backup(current.principal());
        try {
            response.setContentType("application/zip");
            response.setHeader("Content-Disposition", "attachment; filename=\"dronemap-backup.zip\"");
            response.setContentLengthLong(Files.size(file));
            Files.copy(file, response.getOutputStream());
        } finally {
            Files.deleteIfExists(file);
        }
    }
}
