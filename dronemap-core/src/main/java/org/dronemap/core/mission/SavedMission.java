package org.dronemap.core.mission;

import java.time.Instant;
import org.dronemap.core.organisation.OrganisationId;

/** A mission of an organisation's library, with who changed it last. */
public record SavedMission(
        String id, String name, Mission mission, String changedBy, Instant changedAt, OrganisationId organisation) {
    /** Of the default organisation. */
    public SavedMission(String id, String name, Mission mission, String changedBy, Instant changedAt) {
        this(id, name, mission, changedBy, changedAt, OrganisationId.HOME);
    }
}
