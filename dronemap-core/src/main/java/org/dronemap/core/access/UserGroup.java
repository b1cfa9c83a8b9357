package org.dronemap.core.access;

import java.util.Set;
import org.dronemap.core.organisation.OrganisationId;

/** A named set of users of one organisation. */
public record UserGroup(String id, OrganisationId organisation, String name, Set<String> members) {
    public UserGroup {
        members = Set.copyOf(members);
    }
}
