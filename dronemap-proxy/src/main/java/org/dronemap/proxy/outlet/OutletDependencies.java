package org.dronemap.proxy.outlet;

import org.dronemap.core.access.OutletStore;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.time.Time;
import org.dronemap.proxy.outlet.rights.OutletRights;
import org.dronemap.proxy.outlet.uplink.OutletLeaseAuthority;

/**
 * The services that the outlet depends on: cloud, store, journal, rights, lease control and time.
 *
 * @param store keys of users, and what they call drones
 * @param journal writes to it in the background
 * @param rights what users may do now
 * @param control does and takes down what users want with the control of drones
 * @param time what the outlet works in
 */
public record OutletDependencies(
        CloudManager cloud,
        OutletStore store,
        StoreWriter journal,
        OutletRights rights,
        OutletLeaseAuthority control,
        Time time) {}
