package org.dronemap.core.access;

/** What keys and grants leave of what a role allows. */
public enum Permission {
    VIEW,
    /** Missions, fences and rally points: saved ones, and those that drones carry. */
    PLAN,
    /** All other commands, and what operators do with recordings and logs. */
    COMMAND,
    /** What only administrators may. */
    ADMINISTER
}
