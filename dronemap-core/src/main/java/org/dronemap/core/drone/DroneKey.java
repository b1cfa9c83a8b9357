package org.dronemap.core.drone;

/** The key of a link session: IP:port:sysid of the vehicle (seed system Dronemap Planner, section IV). */
public record DroneKey(String address, int port, int systemId) {
    @Override
    public String toString() {
        return address + ":" + port + ":" + systemId;
    }
}
