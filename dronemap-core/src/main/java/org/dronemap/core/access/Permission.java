package org.dronemap.core.access;

import org.dronemap.core.stored.Stored;

/** A permission (view, plan, command, administer) to which an access key or a grant can restrict a role. */
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
