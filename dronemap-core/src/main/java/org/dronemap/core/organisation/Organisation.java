package org.dronemap.core.organisation;

import java.time.Instant;

/** A group of users and drones that is invisible to other organisations. */
public record Organisation(OrganisationId id, String name, Instant madeAt) {}
