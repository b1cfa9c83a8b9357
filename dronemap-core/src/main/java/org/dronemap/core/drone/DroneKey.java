package org.dronemap.core.drone;

/** Network address and system id (IP:port:sysid) by which a vehicle's session is identified; not a secret. */
public record DroneKey(String address, int port, int systemId) {
    @Override
    public String toString() {
        return address + ":" + port + ":" + systemId;
    }
}
