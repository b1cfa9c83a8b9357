package org.dronemap.core.access;

import java.time.Instant;
import org.dronemap.core.organisation.OrganisationId;

/**
 * An invitation code that lets one person create an active account; only the hash of the code is kept.
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
