package org.dronemap.core.access;

import org.dronemap.core.stored.Stored;

/** What keys and grants leave of what a role allows. */
@Stored(names = "VIEW PLAN COMMAND ADMINISTER")
public enum Permission {
    VIEW,
    /** Missions, fences and rally points: saved ones, and those that drones carry. */
    PLAN,
    /** All other commands, and what operators do with recordings and logs. */
    COMMAND,
    /** What only administrators may. */
    ADMINISTER
}
