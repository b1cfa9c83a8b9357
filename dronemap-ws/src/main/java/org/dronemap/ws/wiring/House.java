package org.dronemap.ws.wiring;

import java.util.function.BooleanSupplier;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.mission.MissionStore;
import org.dronemap.core.recording.RecordingArchive;
import org.dronemap.ws.service.BackupService;
import org.dronemap.ws.service.LinkSecurityControl;
import org.dronemap.ws.service.Recordings;

/** Everything behind the faces, built and running. */
public record House(
        CloudManager cloud,
        AccessStore access,
        MissionStore missions,
        Recordings recordings,
        RecordingArchive archive,
        BooleanSupplier databaseUp,
        BackupService.BackupWriter backups,
        LinkSecurityControl linkSecurity) {}
