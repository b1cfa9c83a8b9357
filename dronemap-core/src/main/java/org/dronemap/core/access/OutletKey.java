package org.dronemap.core.access;

/**
 * Signing key of a user's own ground stations; its secret is never shown.
 *
 * @param stamp the last number that a message signed with it carried; only rises
 */
public record OutletKey(String user, LinkKey key, long stamp) {}
