package org.dronemap.ws.testserver;

import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.GrantStore;
import org.dronemap.core.command.CommandStore;
import org.dronemap.core.drone.DroneStore;
import org.dronemap.core.drone.ParameterOverrideStore;
import org.dronemap.core.history.FlightStore;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.lease.LeaseStore;
import org.dronemap.core.link.EndpointStore;
import org.dronemap.core.mission.MissionStore;
import org.dronemap.core.operation.OperationStore;
import org.dronemap.core.virtual.VirtualDroneStore;
import org.dronemap.core.zone.ZoneStore;
import org.dronemap.store.memory.MemoryAccessStore;
import org.dronemap.store.memory.MemoryCommandStore;
import org.dronemap.store.memory.MemoryDroneStore;
import org.dronemap.store.memory.MemoryEndpointStore;
import org.dronemap.store.memory.MemoryFlightStore;
import org.dronemap.store.memory.MemoryGrantStore;
import org.dronemap.store.memory.MemoryLeaseStore;
import org.dronemap.store.memory.MemoryMissionStore;
import org.dronemap.store.memory.MemoryOperationStore;
import org.dronemap.store.memory.MemoryParameterOverrideStore;
import org.dronemap.store.memory.MemoryTelemetryStore;
import org.dronemap.store.memory.MemoryVirtualDroneStore;
import org.dronemap.store.memory.MemoryZoneStore;

/** Where a house keeps what it keeps, behind a switch, and what it remembers of drones behind another. */
final class FaultSwitchedStores {
    final StoreFaultSwitch all = new StoreFaultSwitch();
    final AccessStore access = all.before(AccessStore.class, new MemoryAccessStore());
    final GrantStore grants = all.before(GrantStore.class, new MemoryGrantStore());
    final EndpointStore links = all.before(EndpointStore.class, new MemoryEndpointStore());
    final MissionStore missions = all.before(MissionStore.class, new MemoryMissionStore());
    final ZoneStore zones = all.before(ZoneStore.class, new MemoryZoneStore());
    final DroneStore drones = all.before(DroneStore.class, new MemoryDroneStore());
    final CommandStore commands = all.before(CommandStore.class, new MemoryCommandStore());
    final LeaseStore leases = all.before(LeaseStore.class, new MemoryLeaseStore());
    final ParameterOverrideStore owners = all.before(ParameterOverrideStore.class, new MemoryParameterOverrideStore());
    final OperationStore operations = all.before(OperationStore.class, new MemoryOperationStore());
    final VirtualDroneStore virtuals = all.before(VirtualDroneStore.class, new MemoryVirtualDroneStore());
    final StoreFaultSwitch history = new StoreFaultSwitch();
    final TelemetryStore telemetry = history.before(TelemetryStore.class, new MemoryTelemetryStore());
    final FlightStore flights = history.before(FlightStore.class, new MemoryFlightStore());
}
