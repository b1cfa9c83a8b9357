package org.dronemap.core.access;

/**
 * The key that a user's own ground stations sign MAVLink messages with at the outlet; its secret is never shown.
 *
 * @param stamp the last number that a message signed with it carried; only rises
 */
public record OutletKey(String user, LinkKey key, long stamp) {}
