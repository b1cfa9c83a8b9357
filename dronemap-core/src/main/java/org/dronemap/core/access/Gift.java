package org.dronemap.core.access;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;

/**
 * A transfer of a drone from one organisation to another, which may include its history.
 *
 * @param droneName as it was called then
 * @param at from then on it is the other one's
 * @param histories whether the new owners see, without names of people, what the givers saw of it until then
 */
public record Gift(
        DroneId drone, String droneName, OrganisationId from, OrganisationId to, Instant at, boolean histories) {}
