package org.dronemap.core.access;

/** Who asks, once it is proved. */
public record Principal(String name, Role role) {
    public boolean may(Role needed) {
        return role.includes(needed);
    }
}
