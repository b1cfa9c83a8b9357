package org.dronemap.store.memory;

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
import org.dronemap.store.Stores;
import org.dronemap.store.secret.SecretBox;
import org.jspecify.annotations.Nullable;

/** All stores of a server in memory, for tests; their content outlives the servers that use them. */
public final class MemoryStores implements Stores {
    private final DroneStore drones = new MemoryDroneStore();
    private final MissionStore missions = new MemoryMissionStore();
    private final ZoneStore zones = new MemoryZoneStore();
    private final CommandStore commands = new MemoryCommandStore();
    private final AccessStore access = new MemoryAccessStore();
    private final GrantStore grants = new MemoryGrantStore();
    private final RecordingStore recordings = new MemoryRecordingStore();
    private final EndpointStore links = new MemoryEndpointStore();
    private final LeaseStore leases = new MemoryLeaseStore();
    private final ParameterOverrideStore owners = new MemoryParameterOverrideStore();
    private final VirtualDroneStore virtualDrones = new MemoryVirtualDroneStore();
    private final OperationStore operations = new MemoryOperationStore();
    private final TelemetryStore telemetry = new MemoryTelemetryStore();
    private final FlightStore flights = new MemoryFlightStore();
    private final LinkSecurityStore linkSecurity = new MemoryLinkSecurityStore(drones);
    private final OutletStore outlet = new MemoryOutletStore(access, drones);
    private @Nullable AuditStore audit;

    @Override
    public DroneStore drones() {
        return drones;
    }

    @Override
    public MissionStore missions() {
        return missions;
    }

    @Override
    public ZoneStore zones() {
        return zones;
    }

    @Override
    public CommandStore commands() {
        return commands;
    }

    @Override
    public AccessStore access() {
        return access;
    }

    @Override
    public GrantStore grants() {
        return grants;
    }

    @Override
    public RecordingStore recordings() {
        return recordings;
    }

    @Override
    public EndpointStore links() {
        return links;
    }

    @Override
    public LeaseStore leases() {
        return leases;
    }

    @Override
    public ParameterOverrideStore owners() {
        return owners;
    }

    @Override
    public VirtualDroneStore virtualDrones() {
        return virtualDrones;
    }

    @Override
    public OperationStore operations() {
        return operations;
    }

    @Override
    public TelemetryStore telemetry() {
        return telemetry;
    }

    @Override
    public FlightStore flights() {
        return flights;
    }

    @Override
    public LinkSecurityStore linkSecurity(SecretBox box) {
        return linkSecurity;
    }

    @Override
    public OutletStore outlet(SecretBox box) {
        return outlet;
    }

    @Override
    public synchronized AuditStore audit(AuditChain chain) {
        AuditStore known = audit;
        AuditStore one = known == null ? new MemoryAuditStore(chain) : known;
        audit = one;
        return one;
    }

    @Override
    public boolean isUp() {
        return true;
    }

    @Override
    public void backUp(OutputStream out) throws IOException {
        throw new IOException("What is kept in memory alone cannot be backed up.");
    }

    @Override
    public void close() {
        // It outlives the server that closes it.
    }
}
