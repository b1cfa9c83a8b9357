package org.dronemap.core.organisation;

import java.time.Instant;

/** People and drones that belong together; those of other organisations do not exist for them. */
public record Organisation(OrganisationId id, String name, Instant madeAt) {}
