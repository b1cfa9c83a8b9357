package org.dronemap.store;

import java.io.IOException;
import java.io.OutputStream;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.GrantStore;
import org.dronemap.core.access.LinkSecurityStore;
import org.dronemap.core.access.OutletStore;
import org.dronemap.core.audit.AuditChain;
import org.dronemap.core.audit.AuditStore;
import org.dronemap.core.command.CommandStore;
import org.dronemap.core.drone.DroneStore;
import org.dronemap.core.drone.ParameterOverrideStore;
import org.dronemap.core.history.FlightStore;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.lease.LeaseStore;
import org.dronemap.core.link.EndpointStore;
import org.dronemap.core.mission.MissionStore;
import org.dronemap.core.operation.OperationStore;
import org.dronemap.core.recording.RecordingStore;
import org.dronemap.core.virtual.VirtualDroneStore;
import org.dronemap.core.zone.ZoneStore;
import org.dronemap.store.secret.SecretBox;

/** All stores of a server, open and migrated to the present schema. Any thread. */
public interface Stores extends AutoCloseable {
    DroneStore drones();

    MissionStore missions();

    ZoneStore zones();

    CommandStore commands();

    AccessStore access();

    GrantStore grants();

    RecordingStore recordings();

    EndpointStore links();

    LeaseStore leases();

    ParameterOverrideStore owners();

    VirtualDroneStore virtualDrones();

    OperationStore operations();

    TelemetryStore telemetry();

    FlightStore flights();

    /** Keys are sealed with {@code box} on their way in. */
    LinkSecurityStore linkSecurity(SecretBox box);

    /** Keys are sealed with {@code box} on their way in. */
    OutletStore outlet(SecretBox box);

    /** From now on each change takes along the record of the call that it belongs to. Once. */
    AuditStore audit(AuditChain chain);

    /** Whether it answers now. May block for some seconds. */
    boolean isUp();

    /** Writes everything into a file that a server that does not run can be restored from. */
    void backUp(OutputStream out) throws IOException;

    @Override
    void close();
}
