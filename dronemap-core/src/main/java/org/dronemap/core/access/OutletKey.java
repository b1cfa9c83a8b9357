package org.dronemap.core.access;

/**
 * What a user signs with when attaching a ground station of another maker; it never shows itself.
 *
 * @param stamp the last number that a message signed with it carried; only rises
 */
public record OutletKey(String user, LinkKey key, long stamp) {}
