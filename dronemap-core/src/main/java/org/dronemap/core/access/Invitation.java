package org.dronemap.core.access;

import java.time.Instant;

/**
 * Lets one person make an active account without waiting; the code only as a SHA-256 hash (hexadecimal), since it is
 * 256 random bits.
 *
 * @param label for whom, in the inviting administrator's words
 */
public record Invitation(String id, String label, Role role, String codeHash, String invitedBy, Instant expiresAt) {}
