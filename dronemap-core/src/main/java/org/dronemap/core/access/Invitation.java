package org.dronemap.core.access;

import java.time.Instant;
import org.dronemap.core.organisation.OrganisationId;

/**
 * Lets one person make an active account without waiting; the code only as a SHA-256 hash (hexadecimal), since it is
 * 256 random bits.
 *
 * @param label for whom, in the inviting administrator's words
 * @param invitedBy the name that its maker had then
 * @param account of its maker
 * @param organisation where whoever comes by it belongs
 */
public record Invitation(
        String id,
        String label,
        Role role,
        String codeHash,
        String invitedBy,
        String account,
        Instant expiresAt,
        OrganisationId organisation) {}
